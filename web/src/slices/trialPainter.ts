// SPDX-License-Identifier: MIT
/** Draws thousands of trial arcs, the weakest last; finds the one under the pointer. */
import type { Pen } from "../drawing/pen";
import { findColour, writeColour } from "../viewer/colours";
import type { Bands } from "./bands";
import type { RankedTrials } from "./sliceData";

export const trialWidth = 5;

/** Angle of a place x on the lower arc, as canvases count it: clockwise from the right. */
const findAngle = (x: number, centre: number, radius: number) =>
  Math.acos(Math.min(1, Math.max(-1, (x - centre) / radius)));

/**
 * `circles` [circle][x, y, radius, from, to]. Circles up to `limit` have the colour of their band; the rest are thin and
 * grey where `withRest`.
 */
export function drawTrials(
  pen: Pen,
  circles: Float64Array,
  trials: RankedTrials,
  bands: Bands,
  limit: number,
  withRest: boolean,
): void {
  const { context, camera, place, theme } = pen;
  let last = "";
  context.beginPath();
  const finish = () => {
    context.stroke();
    context.beginPath();
  };
  // From the safest on: the weakest lie uppermost. A stroke for every arc would take seconds, one for each band not.
  for (const i of trials.order) {
    const factor = trials.factors[i]!;
    const isRest = factor > limit;
    if (isRest && !withRest) continue;
    const colour = isRest ? theme.muted : writeColour(bands.colours, findColour(factor, bands.scale));
    if (colour !== last) {
      finish();
      last = colour;
      context.strokeStyle = colour;
      context.globalAlpha = isRest ? 0.12 : 0.9;
      context.lineWidth = isRest ? 0.5 : 1.1;
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
  circles: Float64Array,
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
