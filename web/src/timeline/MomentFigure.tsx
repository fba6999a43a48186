// SPDX-License-Identifier: MIT
/** The section at one time: water, and the slip surface that governs. */
import { useState } from "preact/hooks";

import { Choice } from "../charts/base/Legend";
import { useDark } from "../drawing/dark";
import { clipToSoil, drawCrack, drawOutlines, drawSoilNames, drawSoils, drawSurcharges } from "../drawing/ground";
import { findSoilBox } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { drawSurface, drawSurfaceLabels } from "../drawing/surfaceLines";
import { useOpacity } from "../drawing/useOpacity";
import { formatFactor } from "../page/format";
import { criticalLook } from "../slices/surfacePainter";
import { listQuantities, quantityTitles, useWaterLayer } from "../water/useWaterLayer";
import type { WaterQuantity } from "../water/waterFields";
import type { ShownTimeline } from "./shownTimeline";

type Shown = "soils" | WaterQuantity;

export function MomentFigure({ timeline, chosen }: { timeline: ShownTimeline; chosen: number }) {
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
