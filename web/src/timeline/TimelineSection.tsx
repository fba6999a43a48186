// SPDX-License-Identifier: MIT
/** The factor of safety in time: curve and rain, and the section at the time that is chosen. */
import { useState } from "preact/hooks";

import { formatNumber } from "../charts/base/numbers";
import { ChartTable, numbers } from "../page/DataTable";
import { formatFactor } from "../page/format";
import { report } from "../state";
import { FactorChart } from "./FactorChart";
import { MomentFigure } from "./MomentFigure";
import "./timeline.css";

export function TimelineSection() {
  const { timeline } = report.value;
  const least = timeline?.factors.findIndex((f) => f.time === timeline.least_time) ?? -1;
  const [chosen, setChosen] = useState(Math.max(0, least));
  if (!timeline) return null;
  const { water } = timeline;
  const volume = (v: number) => `${formatNumber(v, 3)} m³`;
  return (
    <>
      <p>{timeline.sentence}</p>
      <FactorChart timeline={timeline} chosen={chosen} onChoose={setChosen} />
      <label class="timeline-slider no-print">
        Time
        <input
          type="range"
          min={0}
          max={timeline.factors.length - 1}
          value={chosen}
          aria-valuetext={timeline.factors[chosen]!.title}
          onInput={(e) => setChosen(e.currentTarget.valueAsNumber)}
        />
        <output>{timeline.factors[chosen]!.title}</output>
      </label>
      <MomentFigure timeline={timeline} chosen={chosen} />
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
              <button type="button" class="link" aria-pressed={i === chosen} onClick={() => setChosen(i)}>
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
