// SPDX-License-Identifier: MIT
/** How the estimate of the probability of failure settled as the samples grew. */
import { formatNumber } from "../charts/base/numbers";
import type { FailureProbability } from "../contract";
import { BandChart } from "./BandChart";

export function GrowthChart({ failure }: { failure: FailureProbability }) {
  return (
    <BandChart
      title="Probability of failure over the number of samples"
      axis="Samples"
      axisUnit=""
      probability={`P(F < ${failure.limit})`}
      points={failure.growth}
      part="probability-of-failure"
      note={`The band is the interval of ${formatNumber(100 * failure.confidence, 3)} % confidence.`}
    />
  );
}
