// SPDX-License-Identifier: MIT
/** What is behind the factor of safety in time: the balance of the water, and every time that was tried. */
import { formatNumber } from "../charts/base/numbers";
import { ChartTable, numbers } from "../page/DataTable";
import { formatFactor } from "../page/format";
import { report } from "../state";
import { chooseMoment, chosenMoment } from "./chosen";
import "./timeline.css";

export function TimelineSection() {
  const { timeline } = report.value;
  if (!timeline) return null;
  const chosen = chosenMoment(timeline);
  const { water } = timeline;
  const volume = (v: number) => `${formatNumber(v, 3)} m³`;
  return (
    <>
      <p>{timeline.sentence}</p>
      <p class="chart-note">
        Water over the whole time, per metre: {volume(water.inflow)} came in, {volume(water.outflow)} left
        {water.transpired > 0 && `, ${volume(water.transpired)} were drawn by roots`}, {volume(Math.abs(water.growth))} {water.growth < 0 ? "less" : "more"} are in
        the soil, {volume(water.runoff)} of the rain ran off; it closes to {water.error === 0 ? "0" : Math.abs(water.error).toExponential(0)}.
        {timeline.distance !== null &&
          ` Between the times a straight line is off by ${formatNumber(100 * timeline.distance, 2)} % of the factor, as far as the bends of the curve tell.`}
      </p>
      <ChartTable
        label="Factors of safety in time"
        class="timeline-factors"
        head={["Time", ...numbers("F"), "Slip surface that governs"]}
      >
        {timeline.factors.map((f, i) => (
          <tr key={f.time} class={i === chosen ? "surface-selected" : undefined}>
            <th scope="row">
              <button type="button" class="link" aria-pressed={i === chosen} onClick={() => chooseMoment(i)}>
                {f.title}
              </button>
            </th>
            <td class="number">{formatFactor(f.factor, "none")}</td>
            <td>{f.factor !== null && `${f.method}, ${f.source}${f.refusal && ` (${f.refusal})`}`}</td>
          </tr>
        ))}
      </ChartTable>
    </>
  );
}
