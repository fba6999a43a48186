// SPDX-License-Identifier: MIT
/** Lines, arrows and marks in pixels, as the overlay is made of. */
import type { ArrowField } from "./arrows";
import { fontFamily, uprightFrom } from "./scaleBar";
import type { Theme } from "./theme";

export type Pixel = [number, number];

export interface Style {
  colour: string;
  width: number;
  dash?: number[];
  closed?: boolean;
}

export function strokeLine(context: CanvasRenderingContext2D, line: Pixel[], style: Style): void {
  context.strokeStyle = style.colour;
  context.lineWidth = style.width;
  context.setLineDash(style.dash ?? []);
  context.beginPath();
  for (const [x, y] of line) context.lineTo(x, y);
  if (style.closed) context.closePath();
  context.stroke();
  context.setLineDash([]);
}

/** A dot with a border. */
export function drawDot(
  context: CanvasRenderingContext2D,
  [x, y]: Pixel,
  radius: number,
  look: { fill: string; colour: string; width: number },
): void {
  context.fillStyle = look.fill;
  context.strokeStyle = look.colour;
  context.lineWidth = look.width;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

/** A text with an edge, read over any colour; `width` of the edge [px]. */
export function writeEdged(
  context: CanvasRenderingContext2D,
  text: string,
  [x, y]: Pixel,
  look: { colour: string; edge: string; width: number },
): void {
  context.lineWidth = look.width;
  context.strokeStyle = look.edge;
  context.strokeText(text, x, y);
  context.fillStyle = look.colour;
  context.fillText(text, x, y);
}

/**
 * The inverted triangle over two short lines, in the middle of the longest piece of the water table; of a line of many
 * short ones in the middle of the line.
 */
export function drawWaterMark(context: CanvasRenderingContext2D, line: Pixel[], theme: Theme): void {
  let best = 0;
  const width = (i: number) => Math.abs(line[i + 1]![0] - line[i]![0]);
  for (let i = 0; i + 1 < line.length; ++i) if (width(i) > width(best)) best = i;
  if (line.length < 2) return;
  if (width(best) < Math.abs(line.at(-1)![0] - line[0]![0]) / 4) best = (line.length - 1) >> 1;
  const [x, y] = [(line[best]![0] + line[best + 1]![0]) / 2, (line[best]![1] + line[best + 1]![1]) / 2];
  context.fillStyle = theme.water;
  context.beginPath();
  for (const [dx, dy] of [[-7, -12], [7, -12], [0, -1]] as const) context.lineTo(x + dx, y + dy);
  context.closePath();
  context.strokeStyle = theme.ground;
  context.lineWidth = 2.5;
  context.stroke();
  context.fill();
  strokeLine(context, [[x - 5, y + 4], [x + 5, y + 4]], { colour: theme.water, width: 1.2 });
  strokeLine(context, [[x - 2.5, y + 7], [x + 2.5, y + 7]], { colour: theme.water, width: 1.2 });
}

export function drawMonitor(context: CanvasRenderingContext2D, [x, y]: Pixel, name: string, theme: Theme): void {
  drawDot(context, [x, y], 4.5, { fill: theme.ground, colour: theme.ink, width: 1.6 });
  context.font = `600 12px ${fontFamily}`;
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  writeEdged(context, name, [x + 8, y - 7], { colour: theme.ink, edge: theme.ground, width: 3.5 });
}

export function drawPicked(context: CanvasRenderingContext2D, [x, y]: Pixel, theme: Theme): void {
  if (Number.isNaN(x)) return;
  for (const [colour, width] of [[theme.ground, 4.5], [theme.accent, 2]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.arc(x, y, 8, 0, 2 * Math.PI);
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) {
      context.moveTo(x + 8 * dx, y + 8 * dy);
      context.lineTo(x + 14 * dx, y + 14 * dy);
    }
    context.stroke();
  }
}

/** The way of a point over the frames, with a dot where it began. */
export function drawPath(context: CanvasRenderingContext2D, line: Pixel[], theme: Theme): void {
  const there = line.filter(([x]) => !Number.isNaN(x));
  if (there.length < 2) return;
  strokeLine(context, there, { colour: theme.ground, width: 4.5 });
  strokeLine(context, there, { colour: theme.accent, width: 2 });
  context.fillStyle = theme.accent;
  context.beginPath();
  context.arc(...there[0]!, 3.5, 0, 2 * Math.PI);
  context.fill();
}

/** All arrows, dark with a light edge so that they are visible on any colour, and one for their scale. */
export function drawArrows(context: CanvasRenderingContext2D, field: ArrowField, width: number, theme: Theme): void {
  const upright = width >= uprightFrom;
  const [x, y] = upright ? [54, 18] : [54, 72];
  traceArrows(context, field.arrows, "#ffffff", 2.8);
  traceArrows(context, field.arrows, "#111111", 1.2);
  const key = { from: [x, y] as Pixel, to: [x + field.reference, y] as Pixel };
  traceArrows(context, [key], theme.ink, 1.4);
  context.font = `11px ${fontFamily}`;
  context.textAlign = "left";
  context.textBaseline = "middle";
  writeEdged(context, field.text, [x + field.reference + 6, y], { colour: theme.ink, edge: theme.ground, width: 3 });
}

function traceArrows(
  context: CanvasRenderingContext2D,
  arrows: ArrowField["arrows"],
  colour: string,
  width: number,
): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.beginPath();
  for (const { from, to } of arrows) {
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const head = Math.min(6, 0.5 * Math.hypot(dx, dy)) / Math.hypot(dx, dy);
    const side = (turn: number) =>
      context.lineTo(to[0] - head * (dx - 0.5 * turn * dy), to[1] - head * (dy + 0.5 * turn * dx));
    context.moveTo(...from);
    context.lineTo(...to);
    context.moveTo(...to);
    side(1);
    context.moveTo(...to);
    side(-1);
  }
  context.stroke();
}
