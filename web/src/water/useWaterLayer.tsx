// SPDX-License-Identifier: MIT
/** The water under a section as a layer of its drawing: which state, which quantity, lines and arrows. */
import { useMemo, useState } from "preact/hooks";

import { Select, useToggles } from "../charts/base/Legend";
import { titleWithUnit } from "../charts/base/numbers";
import { paintTriangles, type Pen } from "../drawing/pen";
import { drawWaterState, writeLabel } from "../drawing/standingWater";
import { report } from "../state";
import { type Arrow, type ArrowField, roundDown } from "../viewer/arrows";
import { tabulateColours } from "../viewer/colours";
import { drawArrows } from "../viewer/lines";
import { type Level, makeLevels, makeScale } from "../viewer/scale";
import type { Bar } from "../viewer/scaleBar";
import {
  findLimits, type ShownWater, startWater, takeQuantity, traceLevel, useWaterArrays, type WaterArrays,
  type WaterQuantity, type WaterStates,
} from "./waterFields";

/** Pixels between arrows, and of the longest one. */
const [mesh, longest] = [30, 40];
/** Share of the arrows that are shorter than the longest: the few at a toe or a crest would hide all others. */
const usual = 0.95;

/** Lines of equal value with their values on them. */
function drawLevels(
  pen: Pen,
  arrays: WaterArrays,
  quantity: "pressure" | "head",
  levels: Level[],
  unit: number,
  colour: string,
): void {
  const { context, place, theme } = pen;
  const values = arrays[quantity];
  for (const { value, text } of levels) {
    // Zero pressure is the water table, which is drawn as such.
    if (quantity === "pressure" && value === 0) continue;
    const pieces = traceLevel(arrays.mesh, values, value * unit);
    if (!pieces.length) continue;
    context.beginPath();
    for (const [a, b] of pieces) {
      context.moveTo(...place(a));
      context.lineTo(...place(b));
    }
    context.strokeStyle = colour;
    context.lineWidth = 0.9;
    context.stroke();
    const middle = pieces.map(([a, b]) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
    const mean = [0, 1].map((d) => middle.reduce((sum, p) => sum + p[d]!, 0) / middle.length);
    const far = (p: number[]) => Math.hypot(p[0]! - mean[0]!, p[1]! - mean[1]!);
    context.textAlign = "center";
    writeLabel(context, text, place(middle.reduce((a, b) => (far(b) < far(a) ? b : a))), theme, colour);
  }
}

/** One arrow of Darcy's velocity for each square of the screen: of the triangle nearest to its middle. */
function chooseFlow(pen: Pen, { mesh: { nodes, triangles }, velocity }: WaterArrays): ArrowField | null {
  if (!velocity) return null;
  const best = new Map<string, { t: number; distance: number; at: [number, number] }>();
  for (let t = 0; 3 * t < triangles.length; ++t) {
    const corners = [0, 1, 2].map((k) => triangles[3 * t + k]!);
    const mean = [0, 1].map((d) => corners.reduce((sum, n) => sum + nodes[2 * n + d]!, 0) / 3);
    const at = pen.place(mean);
    const [column, row] = [Math.floor(at[0] / mesh), Math.floor(at[1] / mesh)];
    const distance = Math.hypot(at[0] - (column + 0.5) * mesh, at[1] - (row + 0.5) * mesh);
    const known = best.get(`${column} ${row}`);
    if (!known || distance < known.distance) best.set(`${column} ${row}`, { t, distance, at });
  }
  const speed = (t: number) => Math.hypot(velocity[2 * t]!, velocity[2 * t + 1]!);
  const speeds = [...best.values()].map(({ t }) => speed(t)).sort((a, b) => a - b);
  const full = speeds[Math.floor(usual * (speeds.length - 1))] ?? 0;
  if (!(full > 0)) return null;
  const arrows: Arrow[] = [];
  for (const { t, at } of best.values()) {
    const size = (longest * Math.min(1, speed(t) / full)) / (speed(t) || 1);
    const to: [number, number] = [at[0] + size * velocity[2 * t]!, at[1] - size * velocity[2 * t + 1]!];
    if (Math.hypot(to[0] - at[0], to[1] - at[1]) >= 2) arrows.push({ from: at, to });
  }
  const { name, si } = report.value.units.speed;
  const value = roundDown(full / si);
  const number = value.toExponential(0).replace("-", "−");
  return { arrows, reference: ((value * si) / full) * longest, text: `Darcy velocity ${number} ${name}` };
}

function drawFlow(pen: Pen, arrays: WaterArrays): void {
  const field = chooseFlow(pen, arrays);
  if (field) drawArrows(pen.context, field, pen.camera.width, pen.theme);
}

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

interface WaterLayer {
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
