// SPDX-License-Identifier: MIT
/** A study with sampled numbers: probability of failure, distribution of the factor, sensitivities, runout. */
import { formatNumber, formatQuantity } from "../charts/base/numbers";
import type { FailureProbability, FittedLaw, SampledRunout, Sampling } from "../contract";
import { ChartTable, Facts } from "../page/DataTable";
import { formatSentence, formatUnit } from "../page/format";
import { report } from "../state";
import { BandChart } from "./BandChart";
import { HistogramChart } from "./HistogramChart";
import { TornadoChart } from "./TornadoChart";
import { formatShare, showName, showValue } from "./probability";

function NumbersTable({ sampling }: { sampling: Sampling }) {
  const { correlations } = sampling;
  const ranks = sampling.ranks ?? [];
  const name = (key: string) => showName(sampling.numbers.find((n) => n.key === key)?.name ?? key);
  const rank = (key: string) => ranks.find((r) => r.key === key)?.coefficient ?? null;
  return (
    <figure class="chart-figure" aria-label="Uncertain numbers">
      <h4>Uncertain numbers</h4>
      <ChartTable
        label="Uncertain numbers"
        rows={sampling.numbers}
        columns={[
          [
            "Number",
            (n) => (
              <>
                {showName(n.name)}
                {n.unit && ` [${formatUnit(n.unit)}]`}
                <div class="chart-missing">{n.key}</div>
              </>
            ),
            "name",
          ],
          ["Distribution", (n) => n.text],
          ["Sampled mean", (n) => formatNumber(n.sampled.mean, 4), "number"],
          ["deviation", (n) => formatNumber(n.sampled.deviation, 3), "number"],
          ["from", (n) => formatNumber(n.sampled.smallest, 4), "number"],
          ["to", (n) => formatNumber(n.sampled.largest, 4), "number"],
          ranks.length > 0 && ["Rank correlation with F", (n) => formatNumber(rank(n.key), 2), "wrap"],
        ]}
      />
      {correlations.map((c) => (
        <p key={c.keys.join()} class="chart-note">
          Correlation of {c.keys.map(name).join(" and ")}: {formatNumber(c.asked, 3)} asked,{" "}
          {formatNumber(c.sampled, 3)} sampled.
        </p>
      ))}
    </figure>
  );
}

function GrowthChart({ failure }: { failure: FailureProbability }) {
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

function RunoutChart({ runout }: { runout: SampledRunout }) {
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

/** The estimates of the probability of failure, each with what it rests on. */
function Estimates({ sampling }: { sampling: Sampling }) {
  const { failure, fits, first_order: first, design_point: point } = sampling;
  const index = (value: number | null) => (value === null ? "not known" : `β = ${formatNumber(value, 3)}`);
  const rows: [string, string][] = [];
  if (failure) {
    const { probability, lower, upper, confidence, count, samples } = failure;
    rows.push([
      "Samples",
      `${formatShare(probability)} (${formatNumber(count, 7)} of ${formatNumber(samples, 7)} below ${failure.limit}), ` +
        `between ${formatShare(lower)} and ${formatShare(upper)} with ${formatNumber(100 * confidence, 3)} % confidence` +
        (failure.standard_error === null ? "" : `, standard error ${formatShare(failure.standard_error)}`) +
        (failure.index === null ? "" : `; ${index(failure.index)}`),
    ]);
  }
  const addFit = (name: string, fit: FittedLaw) =>
    rows.push([
      `${name} distribution of F`,
      `${formatShare(fit.probability)}, ${index(fit.index)}: from mean and deviation of the samples`,
    ]);
  if (fits) {
    addFit("Normal", fits.normal);
    addFit("Lognormal", fits.lognormal);
  }
  if (first)
    rows.push([
      "First order at the means",
      `F = ${formatNumber(first.mean_factor, 4)} with deviation ${formatNumber(first.deviation, 3)}; ` +
        `${index(first.index_normal)} (normal), ${index(first.index_lognormal)} (lognormal)`,
    ]);
  if (point) {
    const values = point.values.map(
      (v) => `${showName(v.name)} ${showValue(v.value, v.unit)} (${formatShare(v.importance)})`,
    );
    rows.push([
      "Most probable failure",
      `${formatShare(point.probability)}, ${index(point.index)}, at ${values.join(", ")}; in brackets the share of each ` +
        `in the scatter${point.converged ? "" : "; the search did not come to rest"}`,
    ]);
  }
  if (rows.length === 0) return null;
  return (
    <>
      <h4>Probability of failure</h4>
      <Facts caption="Estimates of the probability of failure" rows={rows} />
      {failure?.interval && <p class="chart-note">{failure.interval}</p>}
    </>
  );
}

export function SamplingSection() {
  const sampling = report.value.study_result?.sampling;
  if (!sampling) return null;
  const { factor, failure, runout, failure_time } = sampling;
  const plan =
    sampling.plan === "random"
      ? "drawn at random"
      : sampling.replicates > 1
        ? `${formatNumber(sampling.replicates)} Latin hypercubes`
        : "a Latin hypercube";
  return (
    <section class="chart-section" aria-labelledby="chart-sampling-title">
      <h3 id="chart-sampling-title">Uncertain numbers</h3>
      <p>
        {formatNumber(sampling.samples, 7)} samples, {plan}, seed {sampling.seed}; {sampling.method_title},{" "}
        {formatQuantity(sampling.seconds, "s", 3)}.
      </p>
      <Estimates sampling={sampling} />
      <div class="chart-grid">
        {factor && factor.histogram.counts.length > 0 && (
          <HistogramChart
            values={factor}
            title="Factor of safety"
            unit=""
            limit={failure?.limit ?? null}
            probability={failure?.probability ?? null}
            part="factor-histogram"
          />
        )}
        {sampling.tornado && sampling.tornado.length > 0 && <TornadoChart sampling={sampling} />}
        {failure && failure.growth.length > 1 && <GrowthChart failure={failure} />}
        {failure_time && failure_time.histogram.counts.length > 0 && (
          <HistogramChart
            values={failure_time}
            title="Time of failure"
            unit="days"
            limit={null}
            probability={null}
            part="failure-time-histogram"
          />
        )}
        {runout && <RunoutChart runout={runout} />}
        {runout && runout.histogram.counts.length > 0 && (
          <HistogramChart
            values={runout}
            title="Runout beyond the toe"
            unit={runout.unit}
            limit={null}
            probability={null}
            part="runout-histogram"
          />
        )}
      </div>
      <NumbersTable sampling={sampling} />
      {sampling.notes.length > 0 && (
        <ul class="chart-note">
          {sampling.notes.map((note) => (
            <li key={note}>{formatSentence(note)}</li>
          ))}
        </ul>
      )}
      <p class="chart-note">All samples with their results are in samples.csv of the study's folder.</p>
    </section>
  );
}
