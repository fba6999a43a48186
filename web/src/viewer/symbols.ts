// SPDX-License-Identifier: MIT
/** Symbols as engineers draw them, in pixels: supports, levels of standing water, arrows of rain, seepage and inflow. */
import type { HydraulicCondition } from "../contract";
import { writeLabel, writeLevel } from "../drawing/standingWater";
import { drawWaterMark, type Pixel, strokeLine } from "./lines";
import type { Theme } from "./theme";

type Point = [number, number];

/** Symbol of a support by its kind in the case. */
export function chooseSymbol(fix: string): "hatching" | "rollers" | "dashes" {
  return fix === "full" ? "hatching" : fix === "friction" ? "dashes" : "rollers";
}

/**
 * Draws one line of a support with its symbol on the side that is away from the model.
 * Hatching: fixed in all directions; rollers: fixed across, free along; dashed hatching: friction.
 */
export function drawSupport(context: CanvasRenderingContext2D, line: Point[], fix: string, middle: Point): void {
  const kind = chooseSymbol(fix);
  for (let i = 0; i + 1 < line.length; ++i) {
    const [a, b] = [line[i]!, line[i + 1]!];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 2) continue;
    const along: Point = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    let out: Point = [-along[1], along[0]];
    const outwards = ((a[0] + b[0]) / 2 - middle[0]) * out[0] + ((a[1] + b[1]) / 2 - middle[1]) * out[1];
    if (outwards < 0) out = [-out[0], -out[1]];
    const place = (s: number, d: number): Point => [a[0] + along[0] * s + out[0] * d, a[1] + along[1] * s + out[1] * d];
    const stroke = (from: Point, to: Point) => {
      context.moveTo(...from);
      context.lineTo(...to);
    };
    const steps = Math.max(1, Math.round(length / (kind === "rollers" ? 22 : 9)));
    const step = length / steps;
    context.lineWidth = 1;
    context.beginPath();
    if (kind === "rollers") {
      stroke(place(0, 1), place(length, 1));
      stroke(place(0, 9), place(length, 9));
      for (let k = 0; k < steps; ++k) {
        const [x, y] = place((k + 0.5) * step, 5);
        context.moveTo(x + 3.2, y);
        context.arc(x, y, 3.2, 0, 2 * Math.PI);
      }
    } else {
      stroke(place(0, 1), place(length, 1));
      if (kind === "dashes") context.setLineDash([3, 2]);
      for (let k = 0; k < steps; ++k) stroke(place((k + 1) * step - 1, 1), place((k + 1) * step - 8, 9));
    }
    context.stroke();
    context.setLineDash([]);
  }
}

/** The value of a condition at a time [s], in the unit of its series: straight between rows, constant beyond. */
export function evaluateSeries(condition: Pick<HydraulicCondition, "series">, time: number): number {
  const { time: times, values } = condition.series ?? { time: [], values: [] };
  if (!times.length) return Number.NaN;
  // The last row at or before the time: of two rows at one time, the second.
  let i = -1;
  while (i + 1 < times.length && times[i + 1]! <= time) ++i;
  if (i < 0) return values[0]!;
  if (i + 1 === times.length) return values[i]!;
  const fraction = (time - times[i]!) / (times[i + 1]! - times[i]!);
  return values[i]! + fraction * (values[i + 1]! - values[i]!);
}

/** The parts of a line that lie below a level, in metres. */
export function clipBelow(line: number[][], level: number): number[][][] {
  const parts: number[][][] = [];
  let part: number[][] = [];
  const end = () => {
    if (part.length > 1) parts.push(part);
    part = [];
  };
  line.forEach((p, i) => {
    const q = line[i - 1];
    if (q && q[1]! < level !== p[1]! < level && q[1] !== p[1]) {
      const fraction = (level - q[1]!) / (p[1]! - q[1]!);
      part.push([q[0]! + fraction * (p[0]! - q[0]!), level]);
      if (p[1]! >= level) end();
    }
    if (p[1]! < level || (p[1] === level && (!q || q[1]! <= level))) part.push(p);
    else end();
  });
  end();
  return parts;
}

interface Sketch {
  context: CanvasRenderingContext2D;
  place: (at: number[]) => Pixel;
  /** Middle of the model [px]: symbols are on the other side. */
  middle: Pixel;
  theme: Theme;
}

/** Small arrows on a line, every so many pixels; `turn` gives their direction from the outward normal. */
function drawLineArrows(sketch: Sketch, line: Pixel[], length: number, aim: (out: Pixel) => Pixel, inwards: boolean) {
  const { context, middle, theme } = sketch;
  context.strokeStyle = theme.water;
  context.lineWidth = 1.3;
  context.beginPath();
  for (let i = 0; i + 1 < line.length; ++i) {
    const [a, b] = [line[i]!, line[i + 1]!];
    const size = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const count = Math.floor(size / 30 + 0.5);
    if (!count) continue;
    let out: Pixel = [-(b[1] - a[1]) / size, (b[0] - a[0]) / size];
    const side = ((a[0] + b[0]) / 2 - middle[0]) * out[0] + ((a[1] + b[1]) / 2 - middle[1]) * out[1];
    if (side < 0) out = [-out[0], -out[1]];
    const [dx, dy] = aim(out);
    for (let k = 0; k < count; ++k) {
      const fraction = (k + 0.5) / count;
      const foot: Pixel = [a[0] + fraction * (b[0] - a[0]) + 4 * out[0], a[1] + fraction * (b[1] - a[1]) + 4 * out[1]];
      const far: Pixel = [foot[0] + length * dx, foot[1] + length * dy];
      const [from, to] = inwards ? [far, foot] : [foot, far];
      const [ux, uy] = inwards ? [-dx, -dy] : [dx, dy];
      context.moveTo(...from);
      context.lineTo(...to);
      for (const turn of [1, -1]) {
        context.moveTo(...to);
        context.lineTo(to[0] - 4.5 * ux + 2.5 * turn * uy, to[1] - 4.5 * uy - 2.5 * turn * ux);
      }
    }
  }
  context.stroke();
}

/** Wetted line, water over it, and the level with its triangle; beside the model where the line is vertical. */
function drawLevel(sketch: Sketch, part: number[][], level: number): void {
  const { context, place, middle, theme } = sketch;
  const pixels = part.map(place);
  const [left, right] = [Math.min(...pixels.map((p) => p[0])), Math.max(...pixels.map((p) => p[0]))];
  const y = place([part[0]![0]!, level])[1];
  strokeLine(context, pixels, { colour: theme.water, width: 2.6 });
  if (right - left > 24) {
    context.globalAlpha = 0.22;
    context.fillStyle = theme.water;
    context.beginPath();
    for (const [x, z] of pixels) context.lineTo(x, z);
    context.lineTo(pixels.at(-1)![0], y);
    context.lineTo(pixels[0]![0], y);
    context.fill();
    context.globalAlpha = 1;
    const surface: Pixel[] = [[left, y], [right, y]];
    strokeLine(context, surface, { colour: theme.water, width: 1.4 });
    drawWaterMark(context, surface, theme);
    context.textAlign = "left";
    writeLabel(context, writeLevel(level), [(left + right) / 2 + 12, y - 9], theme, theme.water);
    return;
  }
  const outwards = (left + right) / 2 < middle[0] ? -1 : 1;
  const surface: Pixel[] = [[outwards < 0 ? left : right, y], [(outwards < 0 ? left : right) + 30 * outwards, y]];
  strokeLine(context, surface, { colour: theme.water, width: 1.4 });
  drawWaterMark(context, surface, theme);
}

/** Draws one condition as it is at a time [s]. */
export function drawHydraulic(sketch: Sketch, condition: HydraulicCondition, time: number): void {
  const { context, place, theme } = sketch;
  const value = evaluateSeries(condition, time);
  for (const line of condition.lines) {
    const pixels = line.map(place);
    if (condition.condition === "total_head") {
      const level = value * (condition.series?.unit.si ?? 1);
      // A line that lies just at the level is its surface.
      for (const part of clipBelow(line, level + 1e-9 * Math.max(1, Math.abs(level)))) drawLevel(sketch, part, level);
    } else if (condition.condition === "rain" && value !== 0) {
      drawLineArrows(sketch, pixels, 15, () => [0, -1], value > 0);
    } else if (condition.condition === "flux" && value !== 0) {
      drawLineArrows(sketch, pixels, 15, (out) => out, value > 0);
    } else if (condition.condition === "seepage_face") {
      drawLineArrows(sketch, pixels, 11, (out) => out, false);
    } else if (condition.condition === "pressure") {
      strokeLine(context, pixels, { colour: theme.water, width: 2.6 });
    } else if (condition.condition === "no_flow") {
      strokeLine(context, pixels, { colour: theme.water, width: 4 });
      strokeLine(context, pixels, { colour: theme.ground, width: 1.6 });
    }
  }
}
