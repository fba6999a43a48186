// SPDX-License-Identifier: MIT
/** Draws the lines and arrows of a water field. */
import type { Pen } from "../drawing/pen";
import { writeLabel } from "../drawing/standingWater";
import { report } from "../state";
import { roundDown, type Arrow, type ArrowField } from "../viewer/arrows";
import { drawArrows } from "../viewer/lines";
import type { Level } from "../viewer/scale";
import { traceLevel, type WaterArrays } from "./waterFields";

/** Pixels between arrows, and of the longest one. */
const [mesh, longest] = [30, 40];
/** Share of the arrows that are shorter than the longest: the few at a toe or a crest would hide all others. */
const usual = 0.95;

/** Lines of equal value with their values on them. */
export function drawLevels(
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
export function chooseFlow(pen: Pen, { mesh: { nodes, triangles }, velocity }: WaterArrays): ArrowField | null {
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

export function drawFlow(pen: Pen, arrays: WaterArrays): void {
  const field = chooseFlow(pen, arrays);
  if (field) drawArrows(pen.context, field, pen.camera.width, pen.theme);
}
