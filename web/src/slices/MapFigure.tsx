// SPDX-License-Identifier: MIT
/** The smallest factor over the centres of the circles, above the slope. */
import { useMemo } from "preact/hooks";

import { formatNumber } from "../charts/base/numbers";
import type { Slices } from "../contract";
import { formatFactor, formatPlace } from "../page/format";
import { LineKey, useDark } from "../drawing/Keys";
import { drawOutlines, drawSoils, drawWater } from "../drawing/ground";
import { findBox, findSoilBox, joinBoxes, type Pen } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { load, report, useLoaded } from "../state";
import { findColour, writeColour } from "../viewer/colours";
import { strokeLine } from "../viewer/lines";
import { makeLevels, makeScale } from "../viewer/scale";
import type { Bar } from "../viewer/scaleBar";
import { binTrials, type CentreMap, takeMap, traceContour } from "./centreMap";
import { chooseColours, nameSurface, rankTrials, type SlicedSurface, titleMethod } from "./sliceData";
import { criticalLook, drawCritical } from "./surfacePainter";
import { useTrials } from "./trialPainter";

/** Map of centres: that of a search on a grid, else of the trial circles, which are denser near the minimum. */
function useMap(slices: Slices, method: string): CentreMap | null {
  const map = slices.maps.find((m) => m.method === method);
  const values = useLoaded(() => map && load(map.factor), map);
  const { arrays } = useTrials(slices);
  const { trials } = slices;
  const kind = report.value.result.lem?.search?.kind;
  return useMemo(() => {
    const own = trials?.methods.indexOf(method) ?? -1;
    if (arrays && trials && own >= 0 && kind !== "grid") {
      const ranked = rankTrials(arrays.factors, trials.methods.length, own);
      return ranked && binTrials(arrays.circles, ranked, findSoilBox());
    }
    return map && values ? takeMap(map, values) : null;
  }, [slices, method, values, arrays]);
}

export function MapFigure({ slices, selected }: { slices: Slices; selected: SlicedSurface }) {
  const { method } = selected;
  const map = useMap(slices, method);
  const dark = useDark();
  const bar = useMemo<Bar | null>(
    () =>
      map && {
        title: "Smallest F",
        colours: chooseColours(dark),
        scale: makeScale(map.low, map.high),
        levels: null,
        below: false,
        above: false,
      },
    [map, dark],
  );
  if (!map) return null;
  const { columns, rows, from, to } = map;
  const [width, height] = [(to[0]! - from[0]!) / columns, (to[1]! - from[1]!) / rows];
  const at = (i: number, j: number) => [from[0]! + i * width, from[1]! + j * height];
  const value = (i: number, j: number) => map.factor[j * columns + i]!;
  const cells: number[][] = [];
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) if (value(i, j) <= map.high) cells.push(at(i, j), at(i + 1, j + 1));
  const { circle } = selected;
  const box = joinBoxes(joinBoxes(findSoilBox(), findBox([cells])), circle ? findBox([[circle.centre]]) : null);
  const drawMap = ({ context, place, theme, dark: night }: Pen) => {
    const colours = chooseColours(night);
    const scale = makeScale(map.low, map.high);
    for (let j = 0; j < rows; ++j)
      for (let i = 0; i < columns; ++i) {
        if (!(value(i, j) <= map.high)) continue;
        const [x0, y0] = place(at(i, j));
        const [x1, y1] = place(at(i + 1, j + 1));
        context.fillStyle = writeColour(colours, findColour(value(i, j), scale));
        // Half a pixel more, so that no seams are seen between cells.
        context.fillRect(x0 - 0.25, y1 - 0.25, x1 - x0 + 0.5, y0 - y1 + 0.5);
      }
    for (const level of makeLevels(scale, 8))
      for (const [x0, y0, x1, y1] of traceContour(columns, rows, value, level.value))
        strokeLine(context, [place(at(x0, y0)), place(at(x1, y1))], { colour: theme.ground, width: 1 });
  };
  const { length } = report.value.units;
  const grid = report.value.result.lem?.search?.ranges.grid;
  return (
    <figure class="chart-figure" aria-label="Map of the smallest factors">
      <h4>Smallest factor by centre of the circles, {titleMethod(method)}</h4>
      <SectionCanvas
        label="Map of the smallest factor of safety over the centres of the trial circles, above the slope"
        file={`centres_${method}`}
        box={box}
        bar={bar}
        tallest={560}
        draw={(pen) => {
          drawSoils(pen, 0.2);
          drawOutlines(pen);
          drawWater(pen);
          drawMap(pen);
        }}
        depends={[map, dark]}
        drawOver={(pen) => {
          if (grid) {
            const { from: a, to: b } = grid;
            const corners = [a, [b[0]!, a[1]!], b, [a[0]!, b[1]!]].map(pen.place);
            strokeLine(pen.context, corners, { colour: pen.theme.accent, width: 1.6, dash: [6, 4], closed: true });
          }
          if (circle) drawCritical(pen, selected, true);
        }}
        dependsOver={[selected]}
        hint="Point at the map to read it."
        read={(p) => {
          const [i, j] = [Math.floor((p[0] - from[0]!) / width), Math.floor((p[1] - from[1]!) / height)];
          const factor = i >= 0 && j >= 0 && i < columns && j < rows ? value(i, j) : Number.NaN;
          if (Number.isNaN(factor)) return "";
          return `Centre near ${formatPlace(p)}: smallest F = ${factor.toFixed(3)}`;
        }}
      />
      <ul class="drawing-keys" aria-label="Legend">
        {circle && (
          <LineKey colour={criticalLook.colour} width={2.6}>
            {nameSurface(selected)}: F = {formatFactor(selected.factor, "none")}, centre{" "}
            {formatPlace(circle.centre)}, radius{" "}
            {formatNumber(circle.radius / length.si, 4)} {length.name}
          </LineKey>
        )}
        {grid && (
          <LineKey colour="var(--accent)" dash="6 4">
            Searched centres
          </LineKey>
        )}
      </ul>
      <p class="chart-note">
        Each cell shows the lowest factor of all circles centred in it; single empty cells are interpolated. Factors above{" "}
        {formatNumber(map.high / map.low, 3)} times the lowest, and centres far from the critical one, are left out.
      </p>
    </figure>
  );
}
