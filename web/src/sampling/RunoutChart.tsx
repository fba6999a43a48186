/** How probable it is that the soil comes farther than a distance beyond the toe. */
import { formatNumber } from "../charts/base/numbers";
import type { Runout } from "../contract";
import { Scroller } from "../page/Scroller";
import { BandChart } from "./BandChart";
import { formatShare } from "./probability";

export function RunoutChart({ runout }: { runout: Runout }) {
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
        <Scroller class="chart-scroll" label="Probability that the runout exceeds a distance">
          <table class="chart-table">
            <thead>
              <tr>
                <th scope="col" class="chart-number">
                  Farther than [{runout.unit}]
                </th>
                <th scope="col" class="chart-number">
                  Probability
                </th>
                <th scope="col" class="chart-number">
                  from
                </th>
                <th scope="col" class="chart-number">
                  to
                </th>
              </tr>
            </thead>
            <tbody>
              {runout.exceedance.map((e) => (
                <tr key={e.distance}>
                  <th scope="row" class="chart-number">
                    {formatNumber(e.distance, 3)}
                  </th>
                  <td class="chart-number">{formatShare(e.probability)}</td>
                  <td class="chart-number">{formatShare(e.lower)}</td>
                  <td class="chart-number">{formatShare(e.upper)}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </Scroller>
      )}
    </div>
  );
}
