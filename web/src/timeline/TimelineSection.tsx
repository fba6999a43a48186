// SPDX-License-Identifier: MIT
/** Details of the factor of safety in time: the water balance, and every searched time. */
import { formatNumber } from "../charts/base/numbers";
import { ChartTable } from "../page/DataTable";
import { formatFactor, formatQuantity } from "../page/format";
import { report } from "../state";
import { chooseMoment, chosenMoment, findRelease, type ShownRelease, shownTimeline, showRelease } from "./chosen";

/** Moved soil after each release, and its dependence on the time of release. */
function Releases({ releases }: { releases: ShownRelease[] }) {
  const { units } = report.value;
  const length = (x: number) => formatQuantity(x, units.displacement);
  return (
    <ChartTable
      label="Start of MPM"
      class="timeline-releases"
      rows={releases}
      columns={[
        ["Start of MPM", (r) => r.title, "name"],
        ["F", (r) => formatFactor(r.factor, "none"), "number"],
        ["Start", (r) => r.start],
        [
          "Largest displacement",
          (r) => (r.error === null ? length(r.largest_displacement) : <span class="chart-reason">{r.error}</span>),
          "number",
        ],
        ["Front", (r) => r.error === null && r.front, "number"],
        ["Moved", (r) => r.error === null && formatQuantity(r.moved_volume, units.volume, 3), "number"],
        [
          "Results",
          (r) =>
            findRelease(r) < 0 ? (
              r.folder || "this folder"
            ) : (
              <a class="link" href="#section" onClick={() => showRelease(r)}>
                show its end
              </a>
            ),
        ],
      ]}
    />
  );
}

export function TimelineSection() {
  const timeline = shownTimeline.value;
  if (!timeline) return null;
  const chosen = chosenMoment(timeline);
  const { weather: water } = timeline;
  const standing = water.standing ?? 0;
  const { units } = report.value;
  const volume = (v: number) => formatQuantity(v, units.volume, 3);
  return (
    <>
      <p>{timeline.sentence}</p>
      <p class="chart-note">
        Water over the whole time: {volume(water.inflow)} came in, {volume(water.outflow)} left
        {water.transpired > 0 && `, ${volume(water.transpired)} were drawn by roots`}, {volume(Math.abs(water.growth))} {water.growth < 0 ? "less" : "more"} are in
        the soil, {volume(water.runoff)} of the rain ran off{standing > 0 && `, ${volume(standing)} stand on the ground`}; it closes to {water.error === 0 ? "0" : Math.abs(water.error).toExponential(0)}. {water.steps}{" "}
        steps; the largest error of one, by its prediction, is {formatQuantity(timeline.step_error, units.length, 2)} of head.
        {timeline.distance !== null &&
          ` Between the times a straight line is off by ${formatNumber(100 * timeline.distance, 2)} % of the factor, as far as the bends of the curve tell.`}
      </p>
      {timeline.releases.length > 0 && <Releases releases={timeline.releases} />}
      <ChartTable
        label="Factors of safety in time"
        class="timeline-factors"
        rows={timeline.factors}
        rowClass={(_, i) => i === chosen && "surface-selected"}
        columns={[
          [
            "Time",
            (f, i) => (
              <button type="button" class="link" aria-pressed={i === chosen} onClick={() => chooseMoment(i)}>
                {f.title}
              </button>
            ),
            "name",
          ],
          ["F", (f) => formatFactor(f.factor, "none"), "number"],
          [
            "Slip surface that governs",
            (f) => f.factor !== null && `${f.surface.title}, ${f.source}${f.refusal && ` (${f.refusal})`}`,
          ],
        ]}
      >
        {timeline.elements.map((e) => (
          <tr key={`elements ${e.time}`}>
            <th scope="row">{e.title}</th>
            <td class="number">{e.runs.length > 0 ? e.runs.map((r) => formatFactor(r.factor)).join("; ") : "none"}</td>
            <td>
              FEM
              {e.runs.length > 0 && `, ${e.runs.map((r) => (r.davis ? `Davis ${r.davis.toUpperCase()}` : r.flow === "associated" ? "ψ = φ" : "ψ as given")).join("; ")}`}
              {e.error && `: ${e.error}`} ({e.folder})
            </td>
          </tr>
        ))}
      </ChartTable>
    </>
  );
}
