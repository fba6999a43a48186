// SPDX-License-Identifier: MIT
/** The section with every trial surface coloured by its factor, the critical ones, slices and line of thrust. */
import { useMemo, useState } from "preact/hooks";

import { Choice } from "../charts/base/Legend";
import { formatNumber } from "../charts/base/numbers";
import type { LocalMinimum, SlicedSurface, Slices } from "../contract";
import { formatFactor } from "../page/format";
import { useDark } from "../drawing/dark";
import { clipToSoil, drawOutlines, drawSoils, drawSurcharges, drawWater } from "../drawing/ground";
import { GroundKeys, LineKey } from "../drawing/Keys";
import { findSoilBox } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { drawSurface } from "../drawing/surfaceLines";
import { report } from "../state";
import { makeScale } from "../viewer/scale";
import type { Bar } from "../viewer/scaleBar";
import { drawRanges } from "./ranges";
import { chooseColours, nameSurface, rankTrials, titleMethod } from "./sliceData";
import { criticalLook, drawCritical, drawSlices, drawThrust, hasThrust, thrustLook } from "./surfacePainter";
import { drawTrials, findTrial, trialWidth } from "./trialPainter";
import { useTrials } from "./useTrials";

type Shown = "all" | "below" | "best";

export const otherLook = { colour: "#8a6100", dash: [8, 4] };
export const minimumLook = { colour: "#0068a5", dash: [3, 3] };

interface Props {
  slices: Slices;
  selected: SlicedSurface;
  /** A local minimum that is pointed at. */
  lit: LocalMinimum | null;
}

export function TrialFigure({ slices, selected, lit }: Props) {
  const { arrays, failure } = useTrials(slices);
  const [show, setShow] = useState<Shown>("all");
  const [limit, setLimit] = useState<number | null>(null);
  const [on, setOn] = useState({ slices: true, thrust: true, others: false, ranges: true });
  const dark = useDark();
  const { length } = report.value.units;
  const method = slices.trials?.methods.indexOf(selected.method) ?? -1;
  const trials = useMemo(
    () =>
      arrays && slices.trials && method >= 0 ? rankTrials(arrays.factors, slices.trials.methods.length, method) : null,
    [arrays, method],
  );
  const below = limit ?? (trials ? Number((trials.low * 1.1).toFixed(2)) : 1.5);
  const most = show === "best" ? 0 : show === "below" ? below : Infinity;
  const others = slices.surfaces.filter((s) => s !== selected && s.factor !== null);
  const { exit, entry } = slices.search ?? {};
  const bar = useMemo<Bar | null>(
    () =>
      trials && show !== "best"
        ? {
            title: "Factor of safety",
            colours: chooseColours(dark),
            scale: makeScale(trials.low, Math.min(trials.high, most)),
            levels: null,
            below: false,
            above: trials.high < Math.min(most, trials.factors[trials.order[0]!]!),
          }
        : null,
    [trials, dark, show, most],
  );
  const toggle = (name: keyof typeof on, title: string) => (
    <label key={name}>
      <input type="checkbox" checked={on[name]} onChange={(e) => setOn({ ...on, [name]: e.currentTarget.checked })} />
      {title}
    </label>
  );
  const count = trials ? trials.order.reduce((sum, i) => sum + (trials.factors[i]! <= most ? 1 : 0), 0) : 0;
  return (
    <figure class="chart-figure" aria-label="Trial surfaces and slices">
      <h4>
        Trial surfaces by {titleMethod(slices, selected.method)}, and {nameSurface(selected)}
      </h4>
      <div class="chart-bar">
        {trials && (
          <Choice
            label="Trial surfaces that are drawn"
            value={show}
            options={[
              { value: "all", title: "all" },
              { value: "below", title: "below a factor" },
              { value: "best", title: "critical only" },
            ]}
            onChange={setShow}
          />
        )}
        {trials && show === "below" && (
          <label>
            Below F ={" "}
            <input
              type="number"
              step="0.01"
              min={trials.low.toFixed(2)}
              value={below}
              onInput={(e) => e.currentTarget.valueAsNumber > 0 && setLimit(e.currentTarget.valueAsNumber)}
            />
          </label>
        )}
        {selected.slices && toggle("slices", "Slices")}
        {hasThrust(selected) && toggle("thrust", "Line of thrust")}
        {others.length > 0 && toggle("others", "Other critical surfaces")}
        {(exit || entry) && toggle("ranges", "Searched ranges")}
      </div>
      {failure && <p class="chart-bad">The trial surfaces cannot be read: {failure}</p>}
      <SectionCanvas
        label={`Section with ${show === "best" ? "the critical surface" : `${count} trial surfaces coloured by factor of safety`}; ${nameSurface(selected)} with F = ${formatFactor(selected.factor, "none")}`}
        file={`slices_${selected.method}`}
        box={findSoilBox()}
        bar={bar}
        draw={(pen) => {
          drawSoils(pen);
          if (trials && arrays && show !== "best") clipToSoil(pen, () => drawTrials(pen, arrays.circles, trials, most));
          drawOutlines(pen);
          drawWater(pen);
          drawSurcharges(pen);
        }}
        depends={[trials, show, most, dark]}
        drawOver={(pen) => {
          const { context, place } = pen;
          if (on.slices) drawSlices(pen, selected);
          if (on.others) for (const s of others) drawSurface(context, s.points.map(place), otherLook, 1.6);
          drawCritical(pen, selected, false);
          if (on.thrust) drawThrust(pen, selected);
          if (lit) drawSurface(context, lit.points.map(place), minimumLook, 2.6);
          if (on.ranges) drawRanges(pen, exit, entry);
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
                const tell = (v: number) => formatNumber(v / length.si, 4);
                return `F = ${trials.factors[i]!.toFixed(3)}: centre (${tell(x!)}, ${tell(y!)}), radius ${tell(r!)} ${length.name}`;
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
            Local minimum: F = {lit.factor.toFixed(3)}
          </LineKey>
        )}
      </ul>
    </figure>
  );
}
