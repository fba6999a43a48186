// SPDX-License-Identifier: MIT
/** The trial surfaces: decoded, coloured in bands from the smallest factor up to a chosen one, thousands of arcs drawn with the weakest last. */
import { useEffect, useState } from "preact/hooks";

import type { Slices } from "../contract";
import type { Pen } from "../drawing/pen";
import { load, loadPlaces } from "../state";
import { findColour, writeColour } from "../viewer/colours";
import { bandColours, findShare, type Level, makeScale, type Scale } from "../viewer/scale";
import type { RankedTrials } from "./sliceData";

interface Bands {
  colours: Uint8Array;
  scale: Scale;
  /** The ends of the bands, with that of the smallest factor. */
  levels: Level[];
}

const steps = [0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5];
const mostBands = 8;

/** A fifth above the smallest factor: what lies beyond is no rival of the critical surface. */
export const chooseLimit = (low: number): number => Number((1.2 * low).toFixed(2));

/** Bands that end at round factors. */
export function makeBands(low: number, limit: number, colours: Uint8Array): Bands {
  const high = Math.max(limit, low * 1.001);
  const step = steps.find((s) => (high - low) / s <= mostBands) ?? (high - low) / mostBands;
  const digits = Math.max(2, -Math.floor(Math.log10(step) + 1e-9));
  const ends = [low];
  for (let i = Math.floor(low / step) + 1; i * step < high - 1e-3 * step; ++i) ends.push(i * step);
  ends.push(high);
  const scale = makeScale(low, high);
  const shares = ends.slice(1, -1).map((value) => findShare(value, scale));
  return {
    colours: bandColours(colours, shares),
    scale,
    levels: ends.map((value, i) => ({ value, text: value.toFixed(i === 0 ? 3 : digits) })),
  };
}

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

interface TrialArrays {
  circles: Float64Array;
  factors: Float32Array;
}

export function useTrials({ trials }: Slices): { arrays: TrialArrays | null; failure: string } {
  const [arrays, setArrays] = useState<TrialArrays | null>(null);
  const [failure, setFailure] = useState("");
  useEffect(() => {
    if (!trials) return;
    Promise.all([loadPlaces(trials.circles), load(trials.factors)]).then(
      ([circles, factors]) => setArrays({ circles, factors }),
      (error) => setFailure(String(error?.message ?? error)),
    );
  }, [trials]);
  return { arrays, failure };
}
