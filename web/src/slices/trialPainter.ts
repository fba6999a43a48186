// SPDX-License-Identifier: MIT
/** Draws thousands of trial arcs, the weakest last; finds the one under the pointer. */
import type { Pen } from "../drawing/pen";
import { findColour, writeColour } from "../viewer/colours";
import { makeScale } from "../viewer/scale";
import { chooseColours, type RankedTrials } from "./sliceData";

export const trialWidth = 5;

/** Angle of a place x on the lower arc, as canvases count it: clockwise from the right. */
const findAngle = (x: number, centre: number, radius: number) =>
  Math.acos(Math.min(1, Math.max(-1, (x - centre) / radius)));

/** `circles` [circle][x, y, radius, from, to]. Only those below `most` are drawn. */
export function drawTrials(pen: Pen, circles: Float32Array, trials: RankedTrials, most: number): void {
  const { context, camera, place } = pen;
  const colours = chooseColours(pen.dark);
  const scale = makeScale(trials.low, Math.min(trials.high, most));
  context.lineWidth = 1;
  context.globalAlpha = 0.85;
  let last = -1;
  context.beginPath();
  const finish = () => {
    if (last < 0) return;
    context.strokeStyle = writeColour(colours, last);
    context.stroke();
    context.beginPath();
  };
  for (const i of trials.order) {
    const factor = trials.factors[i]!;
    if (factor > most) continue;
    // Of 64 colours each is one stroke: a stroke for every arc would take seconds.
    const colour = findColour(factor, scale) & ~3;
    if (colour !== last) {
      finish();
      last = colour;
    }
    const [x, y, r, from, to] = circles.subarray(trialWidth * i, trialWidth * (i + 1));
    const [cx, cy] = place([x!, y!]);
    const [a, b] = [findAngle(to!, x!, r!), findAngle(from!, x!, r!)];
    const size = r! * camera.scale;
    context.moveTo(cx + size * Math.cos(a), cy + size * Math.sin(a));
    context.arc(cx, cy, size, a, b);
  }
  finish();
  context.globalAlpha = 1;
}

/** Number of the weakest trial that passes within `reach` [m] of a place; -1 for none. */
export function findTrial(
  at: [number, number],
  reach: number,
  circles: Float32Array,
  trials: RankedTrials,
  most: number,
): number {
  for (let k = trials.order.length - 1; k >= 0; --k) {
    const i = trials.order[k]!;
    if (trials.factors[i]! > most) return -1;
    const [x, y, r, from, to] = circles.subarray(trialWidth * i, trialWidth * (i + 1));
    if (at[0] < from! || at[0] > to! || at[1] > y!) continue;
    if (Math.abs(Math.hypot(at[0] - x!, at[1] - y!) - r!) < reach) return i;
  }
  return -1;
}
