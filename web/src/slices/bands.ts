// SPDX-License-Identifier: MIT
/** The bands of the trial surfaces: from the smallest factor up to a chosen one. */
import { bandColours, findShare, makeScale, type Level, type Scale } from "../viewer/scale";

export interface Bands {
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
