// SPDX-License-Identifier: MIT
/** How probable it is that the soil comes farther than a distance beyond the toe. */
import { formatNumber } from "../charts/base/numbers";
import type { SampledRunout } from "../contract";
import { ChartTable } from "../page/DataTable";
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
          rows={runout.exceedance}
          columns={[
            [`Farther than [${runout.unit}]`, (e) => formatNumber(e.distance, 3), "name number"],
            ["Probability", (e) => formatShare(e.probability), "number"],
            ["from", (e) => formatShare(e.lower), "number"],
            ["to", (e) => formatShare(e.upper), "number"],
          ]}
        />
      )}
    </div>
  );
}
