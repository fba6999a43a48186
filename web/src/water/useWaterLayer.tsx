// SPDX-License-Identifier: MIT
/** The water under a section as a layer of its drawing: which state, which quantity, lines and arrows. */
import { useMemo, useState } from "preact/hooks";

import { titleWithUnit } from "../charts/base/numbers";
import type { Pen } from "../drawing/pen";
import { drawWaterState } from "../drawing/standingWater";
import { paintTriangles } from "../drawing/trianglePainter";
import { report } from "../state";
import { tabulateColours } from "../viewer/colours";
import { makeLevels, makeScale } from "../viewer/scale";
import type { Bar } from "../viewer/scaleBar";
import { findLimits, takeQuantity, useWaterArrays, type WaterQuantity } from "./waterFields";
import { drawFlow, drawLevels } from "./waterPainter";
import { startWater, type ShownWater, type WaterStates } from "./waterStates";
import { Select, useToggles } from "../charts/base/Select";

export const quantityTitles: { [name in WaterQuantity]: string } = {
  pressure: "pore pressure",
  head: "total head",
  saturation: "degree of saturation",
};

/** The quantities that states have; by default those that the methods began with. */
export function listQuantities({ states, water_mesh }: WaterStates = startWater.value): WaterQuantity[] {
  if (!water_mesh || !states.some((s) => s.fields)) return [];
  return states.some((s) => s.fields?.saturation) ? ["pressure", "head", "saturation"] : ["pressure", "head"];
}

const lineCount = 9;

export interface WaterLayer {
  state: ShownWater | undefined;
  bar: Bar | null;
  /** Changes with all that the drawing depends on. */
  depends: unknown[];
  /** The colours, if a quantity is chosen; and what lies over them. */
  paint: (pen: Pen, opacity: number) => void;
  drawOver: (pen: Pen) => void;
  /** Note on the quantity; empty without one. */
  note: string;
  /** Controls of the shown state, lines and arrows. */
  controls: preact.ComponentChildren;
}

/** Blue is pressure, red is suction: zero is in the middle. */
function makeBar(quantity: WaterQuantity, limits: [number, number]): { bar: Bar; unit: number } {
  const { length, stress } = report.value.units;
  const flat = { levels: null, below: false, above: false };
  if (quantity === "pressure") {
    const largest = Math.max(Math.abs(limits[0]), Math.abs(limits[1])) / stress.si;
    const scale = makeScale(-largest, largest);
    const title = titleWithUnit("Pressure", stress.name);
    return { unit: stress.si, bar: { ...flat, title, colours: tabulateColours("redBlue"), scale } };
  }
  const colours = tabulateColours("viridis");
  if (quantity === "saturation") {
    const scale = makeScale(Math.min(limits[0], 0.9), 1);
    return { unit: 1, bar: { ...flat, title: "Saturation", colours, scale } };
  }
  const scale = makeScale(limits[0] / length.si, limits[1] / length.si);
  return { unit: length.si, bar: { ...flat, title: titleWithUnit("Head", length.name), colours, scale } };
}

/** Layer of the initial states of the methods; or of others, of which `given` is shown. */
export function useWaterLayer(
  quantity: WaterQuantity | null,
  { states, water_mesh }: WaterStates = startWater.value,
  given?: number,
): WaterLayer {
  const [picked, setIndex] = useState(states.length - 1);
  const [on, toggle] = useToggles({ lines: true, arrows: false });
  const index = given ?? picked;
  const state = states[index];
  const arrays = useWaterArrays(state, water_mesh);
  const shown = useMemo(() => (arrays && quantity ? takeQuantity(arrays, quantity) : null), [arrays, quantity]);
  const scaled = useMemo(() => (shown && quantity ? makeBar(quantity, findLimits(shown)) : null), [shown]);
  const hasSuction = quantity === "pressure" && shown !== null && findLimits(shown)[0] < 0;
  const hasLines = shown !== null && quantity !== "saturation";
  return {
    state,
    bar: scaled?.bar ?? null,
    note: hasSuction ? "Negative pressure is suction. It adds strength only in soils that take it." : "",
    depends: [shown, scaled, arrays, on],
    paint: (pen, opacity) => {
      if (!shown || !scaled) return;
      const { bar, unit } = scaled;
      const inUnit = { ...bar.scale, low: bar.scale.low * unit, high: bar.scale.high * unit };
      paintTriangles(pen, shown.mesh, shown.values, bar.colours, inUnit, opacity);
    },
    drawOver: (pen) => {
      if (hasLines && on.lines && arrays && scaled && shown) {
        const [low, high] = findLimits(shown).map((v) => v / scaled.unit) as [number, number];
        const levels = makeLevels(makeScale(low, high), lineCount);
        drawLevels(pen, arrays, quantity as "pressure" | "head", levels, scaled.unit, pen.theme.ink);
      }
      drawWaterState(pen, state);
      if (on.arrows && arrays) drawFlow(pen, arrays);
    },
    controls: (
      <>
        {states.length > 1 && given === undefined && (
          <Select label="Water at" value={index} options={states.map((s, i) => [i, s.title])} onChange={(value) => setIndex(Number(value))} />
        )}
        {hasLines && toggle("lines", quantity === "head" ? "Head lines" : "Contours")}
        {arrays?.velocity && toggle("arrows", "Flow")}
      </>
    ),
  };
}
