// SPDX-License-Identifier: MIT
/** The water of a section: ponds with their level, the water table, and where water comes out of the ground. */
import type { WaterState } from "../contract";
import { report } from "../state";
import { startWater } from "../water/waterFields";
import { makeTicks } from "../viewer/scale";
import { drawDot, drawWaterMark, strokeLine, type Pixel, writeEdged } from "../viewer/lines";
import { fontFamily } from "../viewer/scaleBar";
import type { Theme } from "../viewer/theme";
import type { Pen } from "./pen";

/** The state that the methods began with; undefined in dry ground. */
export const findUsedWater = () => startWater.value.states.at(-1);

/** A text with a light edge, read over any colour. */
export function writeLabel(
  context: CanvasRenderingContext2D,
  text: string,
  at: Pixel,
  theme: Theme,
  colour: string,
): void {
  context.font = `600 11px ${fontFamily}`;
  context.textBaseline = "middle";
  context.lineJoin = "round";
  writeEdged(context, text, at, { colour, edge: theme.ground, width: 3.5 });
}

/** "17", "17.25": a level in the unit of the report. */
export function writeLevel(level: number): string {
  const { length } = report.value.units;
  return `${String(Number((level / length.si).toFixed(2))).replace("-", "−")} ${length.name}`;
}

export interface PondLine {
  /** From left to right along the surface of the water [m]. */
  surface: [number, number][];
  ground: number[][];
}

/** Stretches of ground that touch, under one level, are one pond. */
export function joinPonds(ponds: WaterState["ponds"]): PondLine[] {
  const joined: PondLine[] = [];
  const near = (a: number, b: number) => Math.abs(a - b) <= 1e-6 * Math.max(1, Math.abs(a));
  for (const { from, to, level_from, level_to } of ponds) {
    const last = joined.at(-1);
    const [x, y] = last?.surface.at(-1) ?? [Number.NaN, Number.NaN];
    if (last && near(x, from[0]!) && near(y, level_from)) {
      // A level surface has no corners.
      if (near(last.surface.at(-2)![1], y) && near(y, level_to)) last.surface.pop();
      last.surface.push([to[0]!, level_to]);
      last.ground.push(from, to);
    } else joined.push({ surface: [[from[0]!, level_from], [to[0]!, level_to]], ground: [from, to] });
  }
  return joined;
}

type Sketch = Pick<Pen, "context" | "place" | "theme">;

export function drawPonds({ context, place, theme }: Sketch, state: WaterState): void {
  for (const { surface, ground } of joinPonds(state.ponds)) {
    const line = surface.map(place);
    context.globalAlpha = 0.22;
    context.fillStyle = theme.water;
    context.beginPath();
    for (const p of [...line, ...ground.map(place).reverse()]) context.lineTo(...p);
    context.fill();
    context.globalAlpha = 1;
    strokeLine(context, line, { colour: theme.water, width: 1.6 });
    drawWaterMark(context, line, theme);
    const [a, b] = [line[0]!, line.at(-1)!];
    context.textAlign = "left";
    const at: Pixel = [(a[0] + b[0]) / 2 + 12, (a[1] + b[1]) / 2 - 8];
    writeLabel(context, writeLevel(surface[0]![1]), at, theme, theme.water);
  }
}

/** The highest places where water leaves the ground. */
export const listExits = (state: WaterState | undefined): number[][] => state?.exits.map((e) => e.highest) ?? [];

/** A ring with the height of the place; with the word alone where that is known to half an element only. */
export function drawExitMarks({ context, place, theme }: Sketch, exits: number[][], withHeight = true): void {
  for (const highest of exits) {
    const [x, y] = place(highest);
    drawDot(context, [x, y], 4, { fill: theme.ground, colour: theme.water, width: 2 });
    context.textAlign = "left";
    writeLabel(context, withHeight ? `exit ${writeLevel(highest[1]!)}` : "exit", [x + 8, y - 10], theme, theme.water);
  }
}

export function drawWaterState(pen: Pen, state: WaterState | undefined): void {
  if (!state) return;
  const { context, place, theme } = pen;
  drawPonds(pen, state);
  for (const points of state.water_table) {
    const line = points.map(place);
    strokeLine(context, line, { colour: theme.ground, width: 4 });
    strokeLine(context, line, { colour: theme.water, width: 2, dash: [10, 3, 2, 3] });
    drawWaterMark(context, line, theme);
  }
  drawExitMarks(pen, listExits(state));
}

/** A bar of a round length over the right end of the section. */
export function drawLengthBar({ context, camera, theme }: Pen): void {
  const { length } = report.value.units;
  const wanted = Math.min(140, camera.width / 5) / camera.scale / length.si;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const value = [5, 2, 1].map((k) => k * power).find((v) => v <= wanted) ?? power;
  const text = `${makeTicks(0, value, 1).at(-1)?.text ?? value} ${length.name}`;
  const size = value * length.si * camera.scale;
  const [x, y] = [camera.width - camera.margins.right - size - 12 - 7 * text.length, camera.margins.top - 12];
  context.fillStyle = theme.ground;
  context.strokeStyle = theme.ink;
  context.lineWidth = 1;
  for (const half of [0, 1]) {
    context.fillStyle = half ? theme.ground : theme.ink;
    context.fillRect(x + (half * size) / 2, y, size / 2, 4);
    context.strokeRect(x + (half * size) / 2 + 0.5, y + 0.5, size / 2, 4);
  }
  context.textAlign = "left";
  writeLabel(context, text, [x + size + 6, y + 3], theme, theme.ink);
}
