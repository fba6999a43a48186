// SPDX-License-Identifier: MIT
/** The section at one time: water, and the slip surface that governs. */
import type { Timeline } from "../contract";
import { useDark } from "../drawing/dark";
import { drawOutlines, drawSoilNames, drawSoils, drawSurcharges } from "../drawing/ground";
import { findSoilBox } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { drawWaterState } from "../drawing/standingWater";
import { drawSurface, drawSurfaceLabels } from "../drawing/surfaceLines";
import { formatFactor } from "../page/format";
import { criticalLook } from "../slices/surfacePainter";

export function MomentFigure({ timeline, chosen }: { timeline: Timeline; chosen: number }) {
  const dark = useDark();
  const moment = timeline.factors[chosen]!;
  return (
    <figure class="chart-figure" aria-label={`Section at ${moment.title}`}>
      <h4>
        {moment.title}: F = {formatFactor(moment.factor, "none")}
        {moment.factor !== null && `, ${moment.method}, ${moment.source}`}
      </h4>
      <SectionCanvas
        label={`Section at ${moment.title} with the water and the slip surface that governs, F = ${formatFactor(moment.factor, "none")}`}
        file={`timeline_${chosen}`}
        box={findSoilBox()}
        draw={(pen) => {
          drawSoils(pen);
          drawOutlines(pen);
          drawSurcharges(pen);
        }}
        depends={[dark]}
        drawOver={(pen) => {
          drawSoilNames(pen);
          drawWaterState(pen, timeline.states[chosen]);
          if (moment.factor === null) return;
          const line = moment.points.map(pen.place);
          drawSurface(pen.context, line, criticalLook, 2.6);
          drawSurfaceLabels(pen.context, [{ line, text: moment.factor.toFixed(3), colour: criticalLook.colour }]);
        }}
        dependsOver={[timeline, chosen]}
      />
    </figure>
  );
}
