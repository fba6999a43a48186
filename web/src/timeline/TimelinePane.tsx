// SPDX-License-Identifier: MIT
/** The first figure of a run with a timeline: the factor of safety and the rain with the section at the chosen time, or
 * the points of MPM. */
import { Choice } from "../charts/base/Legend";
import { report } from "../state";
import { Viewer } from "../viewer/Viewer";
import { chooseFigure, chooseMoment, chosenFigure, chosenMoment, findMoment, type FirstFigure } from "./chosen";
import { FactorChart } from "./FactorChart";
import { MomentFigure } from "./MomentFigure";
import "./timeline.css";
import { shownTimeline, type ShownTimeline } from "./shownTimeline";

const titles: Record<FirstFigure, string> = { motion: "MPM", time: "factor in time" };

export function TimelinePane() {
  const { sequences } = report.value;
  const timeline = shownTimeline.value;
  if (!timeline) return null;
  const shown = chosenFigure(timeline);
  return (
    <>
      {sequences.length > 0 && (
        <div class="chart-bar no-print">
          <Choice
            label="First figure"
            value={shown}
            options={(["motion", "time"] as const).map((value) => ({ value, title: titles[value] }))}
            onChange={chooseFigure}
          />
        </div>
      )}
      {shown === "motion" ? <Viewer /> : <History timeline={timeline} />}
    </>
  );
}

function History({ timeline }: { timeline: ShownTimeline }) {
  const chosen = chosenMoment(timeline);
  const { title, time } = timeline.factors[chosen]!;
  return (
    <>
      <FactorChart timeline={timeline} chosen={chosen} onChoose={chooseMoment} />
      <label class="timeline-slider no-print">
        Time
        <input
          type="range"
          min={0}
          max={timeline.duration}
          step="any"
          value={time}
          aria-valuetext={title}
          onInput={(e) => chooseMoment(findMoment(timeline, e.currentTarget.valueAsNumber))}
        />
        <output>{title}</output>
      </label>
      <MomentFigure timeline={timeline} chosen={chosen} />
    </>
  );
}
