// SPDX-License-Identifier: MIT
/** The panels beside the canvas: selection, soils, blocks of the case, text, runs. */
import { setting } from "../session";
import { CasePanel } from "./CasePanel";
import { RunsPanel } from "./RunsPanel";
import { SelectionPanel } from "./SelectionPanel";
import { SoilsPanel } from "./SoilsPanel";
import { type Tab, tab } from "./tabs";
import { TextPanel } from "./TextPanel";

const titles: Record<Tab, string> = { selection: "Section", soils: "Soils", case: "Case", text: "Text", runs: "Runs" };
const panels: Record<Tab, () => preact.JSX.Element> = {
  selection: SelectionPanel,
  soils: SoilsPanel,
  case: CasePanel,
  text: TextPanel,
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
