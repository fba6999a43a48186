// SPDX-License-Identifier: MIT
/** Histories over time: the balance of energy, the approach to rest, momentum, and what the monitors saw. */
import { signal } from "@preact/signals";
import { useMemo, useState } from "preact/hooks";

import type { Table } from "../../contract";
import { report } from "../../state";
import type { CsvColumn } from "../base/csv";
import { findEnergyBalance } from "./energy";
import { HistoryPanel } from "./HistoryPanel";
import { type HistoryGroup, groupHistories, makePanels } from "./histories";
import { CsvButton } from "../base/Legend";
import { useSwitches } from "../base/useSwitches";
import { Select } from "../base/Select";

/** The table as it is, and the residual of the energy balance where it can be formed. */
function makeColumns(table: Table): CsvColumn[] {
  const balance = findEnergyBalance(table);
  const columns: CsvColumn[] = [table.x, ...table.columns];
  return balance ? [...columns, { name: "energy_residual", unit: "J", values: balance.residual }] : columns;
}

export function HistorySection() {
  const groups = useMemo(() => groupHistories(report.value), [report.value]);
  const [chosen, setChosen] = useState(0);
  const group = groups[chosen];
  if (!group) return null;
  return (
    <section class="chart-section" aria-labelledby="chart-history-title">
      <div class="chart-head">
        <h3 id="chart-history-title">Histories</h3>
        <div class="chart-tools">
          {group.tables.map((t) => (
            <CsvButton
              key={t.id}
              part={t.id}
              what={t.kind === "monitors" ? "monitors" : "history"}
              columns={() => makeColumns(t)}
            />
          ))}
        </div>
      </div>
      {groups.length > 1 && <p class="chart-note chart-printed">Time of: {group.title}</p>}
      {groups.length > 1 && (
        <div class="chart-bar">
          <Select label="Time of" value={chosen} options={groups.map((g, i) => [i, g.title])} onChange={(value) => setChosen(Number(value))} />
        </div>
      )}
      <Panels key={chosen} group={group} />
      <p class="chart-note">{group.tables.map((t) => t.title).join("; ")}.</p>
    </section>
  );
}

function Panels({ group }: { group: HistoryGroup }) {
  const panels = useMemo(
    () => group.tables.flatMap((table) => makePanels(table).map((panel) => ({ panel, table }))),
    [group],
  );
  const [shown, toggle] = useSwitches(() => panels.filter((p) => p.panel.first).map((p) => p.panel.id));
  // One crosshair for all charts of the run.
  const cross = useMemo(() => signal<number | null>(null), [group]);
  return (
    <>
      {group.tables.map((t) => (
        <div class="chart-bar" key={t.id}>
          <fieldset>
            <legend>{t.kind === "monitors" ? "Monitors" : "Whole body"}</legend>
            {panels
              .filter((p) => p.table === t)
              .map(({ panel }) => (
                <label key={panel.id}>
                  <input type="checkbox" checked={shown.has(panel.id)} onChange={() => toggle(panel.id)} />
                  {panel.title}
                </label>
              ))}
          </fieldset>
        </div>
      ))}
      <div class="chart-grid">
        {panels
          .filter((p) => shown.has(p.panel.id))
          .map(({ panel, table }) => (
            <HistoryPanel
              key={panel.id}
              panel={panel}
              cross={cross}
              sequence={group.sequence}
              monitors={table.kind === "monitors"}
            />
          ))}
      </div>
    </>
  );
}
