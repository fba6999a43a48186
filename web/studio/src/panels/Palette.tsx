// SPDX-License-Identifier: MIT
/** The tools of the canvas, with their keys: the usual ones as icons, further ones in a list over the canvas. */
import { signal } from "@preact/signals";

import { selectTool } from "../canvas/drawing";
import { showGrid } from "../canvas/overlay";
import { deleteSelected } from "../canvas/moving";
import { tools } from "../canvas/tools";
import * as state from "../state";

const listed = (Object.keys(tools) as state.Tool[]).filter((tool) => !tools[tool].further);
const further = (Object.keys(tools) as state.Tool[]).filter((tool) => tools[tool].further);
/** Whether the list of further tools is shown over the canvas. */
const isOpen = signal(false);

function Icon({ path }: { path: string }) {
  return (
    <svg viewBox="0 0 16 16" width="18" height="18" aria-hidden="true">
      <path d={path} fill="none" stroke="currentColor" stroke-width="1.3" stroke-linejoin="round" stroke-linecap="round" />
    </svg>
  );
}

export function Palette() {
  const chosen = state.selection.value.kind !== "none";
  return (
    <div class="palette" role="toolbar" aria-label="Tools" aria-orientation="vertical">
      {listed.map((tool) => {
        const { title, key, icon } = tools[tool];
        const name = `${title} (${key.toUpperCase()})`;
        return (
          <button
            key={tool}
            type="button"
            aria-label={name}
            aria-pressed={state.tool.value === tool}
            aria-keyshortcuts={key}
            title={name}
            disabled={state.fault.value !== null && tool !== "select"}
            onClick={() => selectTool(tool)}
          >
            <Icon path={icon} />
          </button>
        );
      })}
      <button
        type="button"
        aria-label="Further tools"
        title={tools[state.tool.value].further ? `Further tools: ${tools[state.tool.value].title}` : "Further tools: search, monitors, seepage"}
        aria-expanded={isOpen.value}
        aria-controls="further-tools"
        aria-pressed={tools[state.tool.value].further === true}
        onClick={() => (isOpen.value = !isOpen.value)}
      >
        <Icon path="M3 8h.01M8 8h.01M13 8h.01" />
      </button>
      <hr />
      <button type="button" aria-label="Delete the selection (Delete)" title="Delete the selection (Delete)" disabled={!chosen} onClick={deleteSelected}>
        <Icon path="M3 4.500h10M6 4.500V3h4v1.500M4.500 4.500l.7 9h5.600l.7-9" />
      </button>
      <button
        type="button"
        aria-label="Snapping"
        title="Snapping to vertices, lines, crossings and the grid (off while Alt is held)"
        aria-pressed={state.snapping.value}
        onClick={() => (state.snapping.value = !state.snapping.value)}
      >
        <Icon path="M4 2v6a4 4 0 008 0V2M4 5h2.500M9.500 5H12M6.500 2v6a1.500 1.500 0 003 0V2M4 2h2.500M9.500 2H12" />
      </button>
      <button
        type="button"
        aria-label="Grid"
        title="Grid"
        aria-pressed={showGrid.value}
        onClick={() => (showGrid.value = !showGrid.value)}
      >
        <Icon path="M2 5.500h12M2 10.500h12M5.500 2v12M10.500 2v12" />
      </button>
    </div>
  );
}

/** Tools of the search, of seepage and of monitors, with their names. */
export function FurtherTools() {
  if (!isOpen.value) return null;
  const close = () => {
    isOpen.value = false;
    document.querySelector<SVGSVGElement>("svg.section")?.focus();
  };
  return (
    <div
      class="further-tools"
      id="further-tools"
      role="toolbar"
      aria-label="Further tools"
      aria-orientation="vertical"
      onKeyDown={(e) => e.key === "Escape" && close()}
    >
      {further.map((tool) => (
        <button
          key={tool}
          type="button"
          aria-pressed={state.tool.value === tool}
          aria-keyshortcuts={tools[tool].key}
          disabled={state.fault.value !== null}
          onClick={() => {
            selectTool(tool);
            close();
          }}
        >
          <Icon path={tools[tool].icon} />
          {tools[tool].title}
          <kbd>{tools[tool].key.toUpperCase()}</kbd>
        </button>
      ))}
    </div>
  );
}
