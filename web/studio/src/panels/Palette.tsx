// SPDX-License-Identifier: MIT
/** The tools of the canvas, with their keys. */
import { selectTool, tools } from "../canvas/drawing";
import { showGrid } from "../canvas/overlay";
import { deleteSelected } from "../canvas/moving";
import * as state from "../state";

const listed = Object.keys(tools) as state.Tool[];

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
