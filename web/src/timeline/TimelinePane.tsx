// SPDX-License-Identifier: MIT
/** The first figure of a run with a timeline: the factor of safety and the rain with the section at the chosen time, or the material points. */
import { useState } from "preact/hooks";

import { Choice } from "../charts/base/Legend";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { useDark, useOpacity } from "../drawing/Keys";
import { clipToSoil, drawBars, drawCrack, drawOutlines, drawSoilNames, drawSoils, drawSurcharges } from "../drawing/ground";
import { findSoilBox } from "../drawing/pen";
import { drawSurface, drawSurfaceLabels } from "../drawing/surfaceLines";
import { formatFactor } from "../page/format";
import { criticalLook } from "../slices/surfacePainter";
import { report } from "../state";
import { Viewer } from "../viewer/Viewer";
import { listQuantities, quantityTitles, useWaterLayer } from "../water/useWaterLayer";
import type { WaterQuantity } from "../water/waterFields";
import { FactorChart } from "./FactorChart";
import {
  chooseFigure, chooseMoment, chosenFigure, chosenMoment, findMoment, type FirstFigure, type ShownTimeline,
  shownTimeline,
} from "./chosen";

type Shown = "soils" | WaterQuantity;

function MomentFigure({ timeline, chosen }: { timeline: ShownTimeline; chosen: number }) {
  const dark = useDark();
  const moment = timeline.factors[chosen]!;
    const options: Shown[] = ["soils", ...listQuantities(timeline)];
  const [shows, choose] = useState<Shown>("soils");
  const { opacity, slider } = useOpacity();
  const layer = useWaterLayer(shows === "soils" ? null : shows, timeline, chosen);
  return (
    <figure class="chart-figure" aria-label={`Section at ${moment.title}`}>
      <h4>
        {moment.title}: F = {formatFactor(moment.factor, "none")}
        {moment.factor !== null && `, ${moment.surface.title}, ${moment.source}`}
      </h4>
      {options.length > 1 && (
        <div class="chart-bar no-print">
          <Choice
            label="Colours of the section"
            value={shows}
            options={options.map((value) => ({ value, title: value === "soils" ? "soils" : quantityTitles[value] }))}
            onChange={choose}
          />
          {layer.controls}
          {shows !== "soils" && slider}
        </div>
      )}
      <SectionCanvas
        label={`Section at ${moment.title} with the water and the slip surface that governs, F = ${formatFactor(moment.factor, "none")}`}
        file={`timeline_${chosen}`}
        box={findSoilBox()}
        bar={layer.bar}
        tallest={430}
        draw={(pen) => {
          drawSoils(pen);
          clipToSoil(pen, () => layer.paint(pen, opacity));
          drawOutlines(pen);
          drawSurcharges(pen);
          drawBars(pen);
        }}
        depends={[dark, shows, ...layer.depends, opacity]}
        drawOver={(pen) => {
          const names = drawSoilNames(pen);
          layer.drawOver(pen);
          if (moment.factor === null) return;
          const line = moment.surface.points.map(pen.place);
          drawCrack(pen, moment.surface.points);
          drawSurface(pen.context, line, criticalLook, 2.6);
          drawSurfaceLabels(pen.context, [{ line, text: moment.factor.toFixed(3), colour: criticalLook.colour }], names);
        }}
        dependsOver={[timeline, chosen, ...layer.depends]}
      />
      {layer.note && <p class="chart-note">{layer.note}</p>}
    </figure>
  );
}

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
