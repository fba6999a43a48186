// SPDX-License-Identifier: MIT
/** Draws one sliced surface: the slices, the surface, the line of thrust, the circle's centre; and the ranges of the search. */
import type { CriticalSurface } from "../contract";
import type { Pen } from "../drawing/pen";
import { drawSurface } from "../drawing/surfaceLines";
import { drawDot, strokeLine, writeEdged } from "../viewer/lines";

/** Ranges of x under the section, each on a line of its own unless they are the same. */
export function drawRanges({ context, camera, place, theme }: Pen, exit?: number[], entry?: number[]): void {
  const same = exit && entry && exit[0] === entry[0] && exit[1] === entry[1];
  const ranges: [string, number[] | undefined][] = same
    ? [["exit and entry", exit]]
    : [
        ["exit", exit],
        ["entry", entry],
      ];
  context.font = "600 11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  ranges.forEach(([name, range], i) => {
    if (!range) return;
    const y = camera.height - 27 - 14 * i;
    const [from, to] = range.map((x) => place([x, 0])[0]) as [number, number];
    strokeLine(context, [[from, y], [to, y]], { colour: theme.accent, width: 2.5 });
    for (const x of [from, to]) strokeLine(context, [[x, y - 4], [x, y + 4]], { colour: theme.accent, width: 1.5 });
    writeEdged(context, name, [(from + to) / 2, y + 4], { colour: theme.ink, edge: theme.ground, width: 4 });
  });
}

export const criticalLook = { colour: "#c2185b", dash: [] };
export const thrustLook = { colour: "#00755a", dash: [7, 3] };

export const supportLook = { colour: "#d9480f", dash: [] };

/** Bars that the surface crosses, as thick as their resistance is used, with the force on the mass. */
export function drawSupportForces({ context, place, theme }: Pen, { supports }: CriticalSurface): void {
  const largest = Math.max(0, ...(supports ?? []).map((s) => s.resistance ?? 0));
  for (const { head, end, crossing, direction, resistance } of supports ?? []) {
    const fraction = largest > 0 ? (resistance ?? 0) / largest : 0;
    strokeLine(context, [head, end].map((p) => place(p as number[])), { colour: supportLook.colour, width: 1 + 4 * fraction });
    const at = place(crossing as number[]);
    const to: [number, number] = [at[0] + 34 * fraction * direction[0]!, at[1] - 34 * fraction * direction[1]!];
    strokeLine(context, [at, to], { colour: criticalLook.colour, width: 1.6 });
    drawDot(context, at, 3, { fill: criticalLook.colour, colour: theme.ground, width: 1 });
  }
}

export function drawSlices({ context, place, theme }: Pen, { slices }: CriticalSurface): void {
  const { left, base_left, base_right, top_left, top_right, right } = slices;
  context.globalAlpha = 0.45;
  context.fillStyle = theme.ground;
  context.beginPath();
  left.forEach((x, i) => {
    const corners = [[x, top_left[i]!], [right[i]!, top_right[i]!], base_right[i]!, base_left[i]!].map(place);
    context.moveTo(...corners[0]!);
    for (const corner of corners.slice(1)) context.lineTo(...corner);
    context.closePath();
  });
  context.fill();
  context.globalAlpha = 0.9;
  context.strokeStyle = theme.ink;
  context.lineWidth = 0.8;
  context.stroke();
  context.globalAlpha = 1;
}

/** Returns whether a surface has a line of thrust; methods without interslice forces have none. */
export function hasThrust({ slices }: CriticalSurface): boolean {
  return slices.normal_right.some((e) => e) && slices.thrust_right.some((y) => y !== null && y !== 0);
}

/**
 * The pieces of the line of thrust [m]. Where the force is nearly zero its position is unbounded: a point outside the mass by
 * more than a quarter of its height there ends a piece. On the last side, at the ground, there is no force.
 */
export function traceThrust({ slices }: CriticalSurface): number[][][] {
  const pieces: number[][][] = [[]];
  slices.right.slice(0, -1).forEach((x, i) => {
    const y = slices.thrust_right[i] ?? Number.NaN;
    const [base, top] = [slices.base_right[i]![1]!, slices.top_right[i]!];
    const margin = Math.max(top - base, 0) / 4;
    if (y >= base - margin && y <= top + margin) pieces.at(-1)!.push([x, y]);
    else pieces.push([]);
  });
  return pieces.filter((piece) => piece.length > 1);
}

/** Inside the frame of the drawing. */
export function drawThrust({ context, camera, place }: Pen, surface: CriticalSurface): void {
  if (!hasThrust(surface)) return;
  const { margins, width, height } = camera;
  context.save();
  context.beginPath();
  context.rect(margins.left, margins.top, width - margins.left - margins.right, height - margins.top - margins.bottom);
  context.clip();
  for (const piece of traceThrust(surface)) drawSurface(context, piece.map(place), thrustLook, 1.8);
  context.restore();
}

/** The surface; of a circle also the lines from its centre to its ends. */
export function drawCritical({ context, place, theme }: Pen, surface: CriticalSurface, withCentre: boolean): void {
  const { slices } = surface;
  const points = [...surface.points];
  if (points.length < 2) return;
  const last = slices.left.length - 1;
  // A tension crack ends the surface below the ground.
  if (last >= 0 && slices.top_left[0]! > slices.base_left[0]![1] + 1e-6)
    points.unshift([slices.left[0]!, slices.top_left[0]!]);
  if (last >= 0 && slices.top_right[last]! > slices.base_right[last]![1] + 1e-6)
    points.push([slices.right[last]!, slices.top_right[last]!]);
  const line = points.map(place);
  drawSurface(context, line, criticalLook, 2.6);
  if (!surface.circle || !withCentre) return;
  const centre = place(surface.circle.centre);
  for (const end of [line[0]!, line.at(-1)!])
    strokeLine(context, [centre, end], { colour: theme.muted, width: 1, dash: [5, 4] });
  drawDot(context, centre, 4.5, { fill: criticalLook.colour, colour: theme.ground, width: 1.5 });
}
