// SPDX-License-Identifier: MIT
/** The weather before the run: where its water went, and how dry the soil became. */
import { report } from "../../state";
import { DataTable, Facts, numbers } from "../DataTable";
import { formatNumber, formatQuantity } from "../format";
import type { Season } from "../../contract";

export function SeasonTable({ season }: { season: Season }) {
  const { units } = report.value;
  const volume = (value: number) => formatQuantity(value, units.volume);
  const length = (value: number) => formatNumber(value / units.length.si);
  const suction = (value: number) => formatNumber(value / units.stress.si);
  const growth = season.growth < 0 ? "less" : "more";
  const rows: [string, string][] = [
    ["Weather before the run", `${formatNumber(season.duration / 86400)} days, in soil at rest`],
    ["Came in", volume(season.inflow)],
    ["Ran off", volume(season.runoff)],
    ["Left through the ground and the sides", volume(season.outflow)],
    ["Transpired", `${volume(season.transpired)} of ${volume(season.potential)} that the plants asked for`],
    ["Stored at its end", `${volume(Math.abs(season.growth))} ${growth} than at its start`],
    ["Balance", `closes to ${formatNumber(Math.abs(season.error), 1)} of the greatest of these`],
  ];
  return (
    <>
      <Facts caption="The weather before the run" rows={rows} />
      <DataTable
        caption={`Suction under the ground, ${units.stress.name}; negative is pressure`}
        head={[`Depth, ${units.length.name}`, ...numbers("Mean, start", "Mean, end", "Least", "Greatest")]}
      >
        {season.layers.map((layer, i) => (
          <tr key={layer.depth}>
            <th scope="row">
              {length(season.layers[i - 1]?.depth ?? 0)}–{length(layer.depth)}
            </th>
            <td class="number">{suction(layer.initial)}</td>
            <td class="number">{suction(layer.mean)}</td>
            <td class="number">{suction(layer.least)}</td>
            <td class="number">{suction(layer.greatest)}</td>
          </tr>
        ))}
      </DataTable>
    </>
  );
}
