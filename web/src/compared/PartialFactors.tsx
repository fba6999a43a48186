// SPDX-License-Identifier: MIT
/** Partial factors, design values and the over-design factor. */
import { formatNumber } from "../charts/base/numbers";
import type { DesignStatement } from "../contract";
import { ChartTable, SymbolText } from "../page/DataTable";
import { formatFactor, formatSentence } from "../page/format";
import { Scroller } from "../page/Scroller";

export function PartialFactors({ partial }: { partial: DesignStatement }) {
  return (
    <figure class="chart-figure" aria-label="Partial factors">
      <h4>Partial factors{partial.set && `: ${partial.set}`}</h4>
      <p>{formatSentence(partial.text)}</p>
      <Scroller class="chart-scroll" label="Partial factors">
        <table class="chart-table compared-narrow">
          <tbody>
            {partial.values.map((v) => (
              <tr key={v.key}>
                <th scope="row">
                  <SymbolText text={v.symbol} /> {v.title}
                </th>
                <td class="number">{formatNumber(v.value, 4)}</td>
              </tr>
            ))}
            {partial.over_design !== null && (
              <tr>
                <th scope="row">Over-design factor</th>
                <td class={`number ${partial.over_design < 1 ? "chart-bad" : "chart-good"}`}>
                  {formatFactor(partial.over_design)}
                </td>
              </tr>
            )}
          </tbody>
        </table>
      </Scroller>
      {partial.materials.length > 0 && (
        <ChartTable
          label="Design values"
          class="compared-narrow"
          rows={partial.materials}
          columns={[
            ["Soil", (m) => m.material, "name"],
            [
              "Quantity",
              (m) => (
                <>
                  {m.quantity}
                  {m.symbol && " "}
                  {m.symbol && <SymbolText text={m.symbol} />}
                  {m.unit && ` [${m.unit === "deg" ? "°" : m.unit}]`}
                </>
              ),
            ],
            ["Characteristic", (m) => formatNumber(m.characteristic, 4), "number"],
            ["Design", (m) => formatNumber(m.design, 4), "number"],
          ]}
        />
      )}
      {partial.notes.map((text) => (
        <p key={text} class="chart-note">
          {formatSentence(text)}
        </p>
      ))}
    </figure>
  );
}
