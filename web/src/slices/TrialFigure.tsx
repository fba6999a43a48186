// SPDX-License-Identifier: MIT
/** The section with every trial surface coloured by its factor, the critical ones, slices and line of thrust. */
import { useMemo, useState } from "preact/hooks";

import { Choice, useToggles } from "../charts/base/Legend";
import { formatNumber } from "../charts/base/numbers";
import type { Slices, SlipSurface } from "../contract";
import { formatFactor, formatPlace } from "../page/format";
import { GroundKeys, LineKey, useDark } from "../drawing/Keys";
import {
  clipToSoil, drawBars, drawCrack, drawOutlines, drawSoilNames, drawSoils, drawSurcharges, drawWater,
} from "../drawing/ground";
import { findSoilBox } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { drawSurface, drawSurfaceLabels, type SurfaceLabel } from "../drawing/surfaceLines";
import { report } from "../state";
import type { Pixel } from "../viewer/lines";
import type { Bar } from "../viewer/scaleBar";
import { drawRestrictions } from "./restrictions";
import {
  criticalLook, drawCritical, drawRanges, drawSlices, drawSupportForces, drawThrust, hasThrust, thrustLook,
} from "./surfacePainter";
import { chooseLimit, drawTrials, findTrial, makeBands, trialWidth, useTrials } from "./trialPainter";
import {
  chooseColours, hasSlices, nameSurface, rankTrials, type SlicedSurface, slicedSurfaces, titleMethod,
} from "./sliceData";

type Shown = "banded" | "below" | "best";

const otherLook = { colour: "#8a6100", dash: [8, 4] };
const minimumLook = { colour: "#0068a5", dash: [3, 3] };

const label = (line: Pixel[], factor: number | null, colour: string): SurfaceLabel[] =>
  factor === null ? [] : [{ line, text: factor.toFixed(3), colour }];

interface Props {
  slices: Slices;
  selected: SlicedSurface;
  /** A local minimum that is pointed at. */
  lit: SlipSurface | null;
}

export function TrialFigure({ slices, selected, lit }: Props) {
  const { arrays, failure } = useTrials(slices);
  const [show, setShow] = useState<Shown>("banded");
  const [limit, setLimit] = useState<number | null>(null);
  const [on, toggle] = useToggles({ slices: true, thrust: true, others: false, ranges: true });
  const dark = useDark();
  const { length } = report.value.units;
  const method = slices.trials?.methods.indexOf(selected.method) ?? -1;
  const trials = useMemo(
    () =>
      arrays && slices.trials && method >= 0 ? rankTrials(arrays.factors, slices.trials.methods.length, method) : null,
    [arrays, method],
  );
  const below = limit ?? (trials ? chooseLimit(trials.low) : 1.5);
  const bands = useMemo(
    () => (trials && show !== "best" ? makeBands(trials.low, below, chooseColours(dark)) : null),
    [trials, show, below, dark],
  );
  /** Trials beyond the bands are grey, or not drawn. */
  const most = show === "best" ? 0 : show === "below" ? below : Infinity;
  const others = slicedSurfaces.value.filter((s) => s !== selected && s.factor !== null);
  const { exit, entry } = report.value.result.lem?.search?.ranges ?? {};
  const restrictions = report.value.result.lem?.search?.restrictions;
  const bar = useMemo<Bar | null>(
    () => bands && { title: "Factor of safety", ...bands, below: false, above: false },
    [bands],
  );
  const count = trials ? trials.order.reduce((sum, i) => sum + (trials.factors[i]! <= most ? 1 : 0), 0) : 0;
  return (
    <figure class="chart-figure" aria-label="Trial surfaces and slices">
      <h4>
        Trial surfaces by {titleMethod(selected.method)}, and {nameSurface(selected)}
      </h4>
      <div class="chart-bar">
        {trials && (
          <Choice
            label="Trial surfaces that are drawn"
            value={show}
            options={[
              { value: "banded", title: "all" },
              { value: "below", title: "coloured only" },
              { value: "best", title: "critical only" },
            ]}
            onChange={setShow}
          />
        )}
        {trials && show !== "best" && (
          <label>
            Colours up to F ={" "}
            <input
              type="number"
              step="0.01"
              min={trials.low.toFixed(2)}
              value={below}
              onInput={(e) => e.currentTarget.valueAsNumber > 0 && setLimit(e.currentTarget.valueAsNumber)}
            />
          </label>
        )}
        {hasSlices(selected) && toggle("slices", "Slices")}
        {hasThrust(selected) && toggle("thrust", "Line of thrust")}
        {others.length > 0 && toggle("others", "Other critical surfaces")}
        {(exit || entry || restrictions) && toggle("ranges", "Searched ranges")}
      </div>
      {failure && <p class="chart-bad">The trial surfaces cannot be read: {failure}</p>}
      <SectionCanvas
        label={`Section with ${show === "best" ? "the critical surface" : `${count} trial surfaces, coloured by factor of safety up to ${below}`}; ${nameSurface(selected)} with F = ${formatFactor(selected.factor, "none")}`}
        file={`slices_${selected.method}`}
        box={findSoilBox()}
        bar={bar}
        draw={(pen) => {
          drawSoils(pen);
          if (trials && arrays && bands)
            clipToSoil(pen, () => drawTrials(pen, arrays.circles, trials, bands, below, show === "banded"));
          drawOutlines(pen);
          drawSurcharges(pen);
          drawBars(pen);
        }}
        depends={[trials, show, bands, dark]}
        drawOver={(pen) => {
          const { context, place } = pen;
          const names = drawSoilNames(pen);
          if (on.slices) drawSlices(pen, selected);
          drawWater(pen);
          if (on.others) for (const s of others) drawSurface(context, s.points.map(place), otherLook, 1.6);
          drawCrack(pen, selected.points);
          drawCritical(pen, selected, false);
          drawSupportForces(pen, selected);
          if (on.thrust) drawThrust(pen, selected);
          if (lit) drawSurface(context, lit.points.map(place), minimumLook, 2.6);
          if (on.ranges) drawRanges(pen, exit, entry);
          if (on.ranges && restrictions) drawRestrictions(pen, restrictions);
          drawSurfaceLabels(context, [
            ...label(selected.points.map(place), selected.factor, criticalLook.colour),
            ...(on.others ? others.flatMap((s) => label(s.points.map(place), s.factor, otherLook.colour)) : []),
            ...(lit ? label(lit.points.map(place), lit.factor ?? 0, minimumLook.colour) : []),
          ], names);
        }}
        dependsOver={[on, selected, lit]}
        hint={
          trials ? "Point at a trial surface to read its factor; drag moves, after a click the wheel zooms." : undefined
        }
        read={
          trials && arrays
            ? (at, reach) => {
                const i = findTrial(at, reach, arrays.circles, trials, most);
                if (i < 0) return "";
                const [x, y, r] = arrays.circles.subarray(trialWidth * i, trialWidth * i + 3);
                return `F = ${trials.factors[i]!.toFixed(3)}: centre ${formatPlace([x!, y!])}, radius ${formatNumber(r! / length.si, 4)} ${length.name}`;
              }
            : undefined
        }
      />
      <ul class="drawing-keys" aria-label="Legend">
        <GroundKeys />
        <LineKey colour={criticalLook.colour} width={2.6}>
          {nameSurface(selected)}: F = {formatFactor(selected.factor, "none")}
        </LineKey>
        {on.thrust && hasThrust(selected) && (
          <LineKey colour={thrustLook.colour} dash="7 3">
            Line of thrust
          </LineKey>
        )}
        {on.others && others.length > 0 && (
          <LineKey colour={otherLook.colour} dash="8 4">
            Other critical surfaces
          </LineKey>
        )}
        {lit && (
          <LineKey colour={minimumLook.colour} dash="3 3">
            Local minimum: F = {(lit.factor ?? 0).toFixed(3)}
          </LineKey>
        )}
      </ul>
    </figure>
  );
}
