// SPDX-License-Identifier: MIT
/** The slice table: sortable, to be saved as CSV; symbols in its head, their meaning below. */
import { useState } from "preact/hooks";

import { CsvButton } from "../charts/base/Legend";
import { orderValues } from "../charts/base/rows";
import { formatNumber, titleWithUnit } from "../charts/base/numbers";
import { formatCoordinate, formatFactor } from "../page/format";
import { Scroller, SymbolText } from "../page/DataTable";
import { report } from "../state";
import { hasSlices, makeSliceTable, nameSurface, type SlicedSurface } from "./sliceData";

const writeValue = (value: number | null, digits: number | "place") =>
  digits !== "place" ? formatNumber(value, digits)
  : value === null ? "–"
  : formatCoordinate(value * report.value.units.length.si);

const lowerFirst = (text: string) => text[0]!.toLowerCase() + text.slice(1);

export function SliceTable({ surface }: { surface: SlicedSurface }) {
  const [sort, setSort] = useState<{ by: number; down: boolean }>({ by: 0, down: false });
  const columns = makeSliceTable(surface);
  if (!hasSlices(surface)) return null;
  const by = Math.min(sort.by, columns.length - 1);
  const order = orderValues(columns[by]!.values, sort.down);
  const part = ["slices", surface.method, surface.kind === "circle" ? "" : surface.name || surface.kind];
  return (
    <figure class="chart-figure" aria-label="Slice table">
      <div class="chart-head">
        <h4>Slices of {nameSurface(surface)}</h4>
        <CsvButton
          part={part.filter(Boolean).join("-")}
          columns={() => columns.map(({ name, unit, values }) => ({ name, unit: unit || undefined, values }))}
        />
      </div>
      <p class="chart-note">
        F = {formatFactor(surface.factor, "none")}
        {surface.lambda !== null && `, λ = ${formatNumber(surface.lambda, 4)}`}
        {surface.correction !== 1 && `, f₀ = ${formatNumber(surface.correction, 4)}`}; forces per {report.value.units.speed.name.startsWith("ft") ? "foot" : "metre"} of thickness.
      </p>
      <Scroller class="chart-scroll slice-table" label={`Slices of ${nameSurface(surface)}`}>
        <table class="chart-table">
          <thead>
            <tr>
              {columns.map((c, i) => (
                <th
                  key={c.name}
                  scope="col"
                  class={c.name === "soil" ? undefined : "number"}
                  title={c.title}
                  aria-sort={by === i ? (sort.down ? "descending" : "ascending") : "none"}
                >
                  <button type="button" onClick={() => setSort({ by: i, down: by === i ? !sort.down : false })}>
                    {c.symbol ? <SymbolText text={c.symbol} /> : "#"}
                    <span aria-hidden="true" class="chart-missing">
                      {by === i ? (sort.down ? " ▼" : " ▲") : ""}
                    </span>
                    {c.unit && <small> {c.unit}</small>}
                  </button>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {order.map((row) => (
              <tr key={row}>
                {columns.map((c) => {
                  const value = c.values[row]!;
                  return (
                    <td key={c.name} class={typeof value === "string" ? undefined : "number"}>
                      {typeof value === "string" ? value : writeValue(value, c.digits)}
                    </td>
                  );
                })}
              </tr>
            ))}
          </tbody>
        </table>
      </Scroller>
      <p class="chart-note">
        {columns
          .filter((c) => c.symbol && c.symbol !== "soil")
          .map((c, i) => (
            <span key={c.name}>
              {i > 0 && "; "}
              <SymbolText text={c.symbol} /> {titleWithUnit(lowerFirst(c.title), c.unit)}
            </span>
          ))}
        . E and X act on the right side of a slice.
      </p>
    </figure>
  );
}
