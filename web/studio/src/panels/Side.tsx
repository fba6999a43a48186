// SPDX-License-Identifier: MIT
/** The panels beside the canvas: selection, soils, blocks of the case, text, runs. */
import { signal } from "@preact/signals";

import { setting } from "../session";
import { CasePanel } from "./CasePanel";
import { RunsPanel } from "./RunsPanel";
import { SelectionPanel } from "./SelectionPanel";
import { SoilsPanel } from "./SoilsPanel";
import { type Tab, tab } from "./tabs";

const editor = signal<(() => preact.JSX.Element) | null>(null);

/** The editor is half of the page's code: it is loaded when it is opened first. */
function LateTextPanel() {
  const Editor = editor.value;
  if (!Editor) {
    void import("./TextPanel").then(({ TextPanel }) => (editor.value = TextPanel));
    return <p class="muted loading">Loading the editor …</p>;
  }
  return <Editor />;
}

const titles: Record<Tab, string> = { selection: "Section", soils: "Soils", case: "Case", text: "Text", runs: "Runs" };
const panels: Record<Tab, () => preact.JSX.Element> = {
  selection: SelectionPanel,
  soils: SoilsPanel,
  case: CasePanel,
  text: LateTextPanel,
  runs: RunsPanel,
};

function press(event: KeyboardEvent): void {
  const all = Object.keys(titles) as Tab[];
  const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
  if (!step) return;
  event.preventDefault();
  tab.value = all[(all.indexOf(tab.value) + step + all.length) % all.length]!;
  setTimeout(() => document.getElementById(`tab-${tab.value}`)?.focus());
}

export function Side() {
  const Panel = panels[tab.value];
  return (
    <aside class="side" aria-label="Panels">
      <div class="tabs" role="tablist" aria-label="Panels" onKeyDown={press}>
        {(Object.keys(titles) as Tab[]).map((key) => (
          <button
            key={key}
            id={`tab-${key}`}
            type="button"
            role="tab"
            aria-selected={tab.value === key}
            aria-controls="panel"
            tabIndex={tab.value === key ? 0 : -1}
            onClick={() => (tab.value = key)}
          >
            {titles[key]}
          </button>
        ))}
      </div>
      <div class={`panel panel-${tab.value}`} id="panel" role="tabpanel" aria-labelledby={`tab-${tab.value}`} tabIndex={-1}>
        {setting.value && <Panel />}
      </div>
    </aside>
  );
}
