// SPDX-License-Identifier: MIT
/** How probable it is that the soil comes farther than a distance beyond the toe. */
import { formatNumber } from "../charts/base/numbers";
import type { SampledRunout } from "../contract";
import { ChartTable, numbers } from "../page/DataTable";
import { BandChart } from "./BandChart";
import { formatShare } from "./probability";

export function RunoutChart({ runout }: { runout: SampledRunout }) {
  return (
    <div>
      {runout.curve.length > 1 && (
        <BandChart
          title="Exceedance of the runout"
          axis="Distance beyond the toe"
          axisUnit={runout.unit}
          probability="Probability of more"
          points={runout.curve}
          part="runout-exceedance"
          note="The band is the confidence interval of the share of samples."
        />
      )}
      {runout.exceedance.length > 0 && (
        <ChartTable
          label="Probability that the runout exceeds a distance"
          head={[...numbers(`Farther than [${runout.unit}]`, "Probability", "from", "to")]}
        >
          {runout.exceedance.map((e) => (
            <tr key={e.distance}>
              <th scope="row" class="number">
                {formatNumber(e.distance, 3)}
              </th>
              <td class="number">{formatShare(e.probability)}</td>
              <td class="number">{formatShare(e.lower)}</td>
              <td class="number">{formatShare(e.upper)}</td>
            </tr>
          ))}
        </ChartTable>
      )}
    </div>
  );
}
