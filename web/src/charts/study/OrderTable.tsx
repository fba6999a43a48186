// SPDX-License-Identifier: MIT
/** When the monitored points of each variant began to move, and in which order. */
import { ChartTable, type Column } from "../../page/DataTable";
import { CsvButton } from "../base/Legend";
import { formatNumber } from "../base/numbers";
import type { Study } from "./shownStudy";

export function OrderTable({ study }: { study: Study }) {
  const rows = study.rows.filter((r) => r.motion);
  const monitors = [...new Set(rows.flatMap((r) => r.motion!.monitors.map((m) => m.name)))];
  if (rows.length === 0 || monitors.length === 0) return null;
  const onset = (row: (typeof rows)[number], name: string) =>
    row.motion!.monitors.find((m) => m.name === name)?.onset ?? null;
  return (
    <figure aria-label="Order of movement" class="chart-figure">
      <div class="chart-head">
        <h4>Order of movement</h4>
        <CsvButton
          part="study-onsets"
          what="onsets"
          columns={() => [
            { name: "variant", values: rows.map((r) => r.name) },
            ...monitors.map((name) => ({ name, unit: "s", values: rows.map((r) => onset(r, name)) })),
            { name: "pattern", values: rows.map((r) => r.motion!.pattern) },
          ]}
        />
      </div>
      <ChartTable
        label="When the monitored points began to move"
        rows={rows}
        columns={[
          ["Variant", (r) => r.name, "name"],
          ...monitors.map((name): Column<(typeof rows)[number]> => [
            `${name} [s]`,
            (r) => {
              const time = onset(r, name);
              return time === null ? <span class="chart-missing">at rest</span> : formatNumber(time, 3);
            },
            "number",
          ]),
          ["In words", (r) => r.motion!.sentence],
        ]}
      />
    </figure>
  );
}
