// SPDX-License-Identifier: MIT
/** The first figure of a run with a timeline: the factor of safety and the rain, and the section at the chosen time. */
import { report } from "../state";
import { chooseMoment, chosenMoment } from "./chosen";
import { FactorChart } from "./FactorChart";
import { MomentFigure } from "./MomentFigure";
import "./timeline.css";

export function TimelinePane() {
  const { timeline } = report.value;
  if (!timeline) return null;
  const chosen = chosenMoment(timeline);
  const { title } = timeline.factors[chosen]!;
  return (
    <>
      <FactorChart timeline={timeline} chosen={chosen} onChoose={chooseMoment} />
      <label class="timeline-slider no-print">
        Time
        <input
          type="range"
          min={0}
          max={timeline.factors.length - 1}
          value={chosen}
          aria-valuetext={title}
          onInput={(e) => chooseMoment(e.currentTarget.valueAsNumber)}
        />
        <output>{title}</output>
      </label>
      <MomentFigure timeline={timeline} chosen={chosen} />
    </>
  );
}
