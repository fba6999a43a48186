// SPDX-License-Identifier: MIT
/** The map of the smallest factor over the centres, of the grid of the search or of the trial circles binned by centre; and its contours. */
import { type Box, findBox } from "../drawing/pen";
import type { RankedTrials } from "./sliceData";
import { trialWidth } from "./trialPainter";

type Segment = [number, number, number, number];

/** `value(column, row)` is NaN where there is none. Segments in units of cells, from the lower left corner. */
export function traceContour(
  columns: number,
  rows: number,
  value: (column: number, row: number) => number,
  level: number,
): Segment[] {
  const segments: Segment[] = [];
  for (let j = 0; j + 1 < rows; ++j)
    for (let i = 0; i + 1 < columns; ++i) {
      const corners = [
        [i, j],
        [i + 1, j],
        [i + 1, j + 1],
        [i, j + 1],
      ] as const;
      const values = corners.map(([a, b]) => value(a, b));
      if (values.some(Number.isNaN)) continue;
      const cuts: [number, number][] = [];
      for (let k = 0; k < 4; ++k) {
        const [a, b] = [values[k]!, values[(k + 1) % 4]!];
        if (a < level === b < level) continue;
        const fraction = (level - a) / (b - a);
        const [from, to] = [corners[k]!, corners[(k + 1) % 4]!];
        cuts.push([from[0] + fraction * (to[0] - from[0]) + 0.5, from[1] + fraction * (to[1] - from[1]) + 0.5]);
      }
      // Four cuts are a saddle: which pairs belong together is open, and either is right.
      for (let k = 0; k + 1 < cuts.length; k += 2) segments.push([...cuts[k]!, ...cuts[k + 1]!]);
    }
  return segments;
}

export interface CentreMap {
  /** Outer corners [m]. */
  from: number[];
  to: number[];
  columns: number;
  rows: number;
  /** Row by row from the lower left; NaN: none. */
  factor: Float32Array;
  low: number;
  /** Factors beyond are left out. */
  high: number;
}

/** How far above the smallest factor the map goes. */
const reach = 1.5;
const cells = 34;

/** Around the weakest circle's centre: farther ones would make the slope too small to be seen. */
function findWindow(best: number[], soil: Box): Box {
  const width = soil[1][0]! - soil[0][0]!;
  return [
    [best[0]! - 0.8 * width, best[1]! - width],
    [best[0]! + 0.8 * width, best[1]! + 0.6 * width],
  ];
}

/** Cells without a value between cells that have one get the mean of their neighbours. */
function fillGaps(factor: Float32Array, columns: number, rows: number): Float32Array {
  const filled = factor.slice();
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) {
      if (!Number.isNaN(factor[j * columns + i]!)) continue;
      let [sum, count] = [0, 0];
      for (let dj = -1; dj <= 1; ++dj)
        for (let di = -1; di <= 1; ++di) {
          const [a, b] = [i + di, j + dj];
          if (a < 0 || b < 0 || a >= columns || b >= rows) continue;
          const value = factor[b * columns + a]!;
          if (Number.isNaN(value)) continue;
          sum += value;
          ++count;
        }
      if (count >= 4) filled[j * columns + i] = sum / count;
    }
  return filled;
}

/** `circles` as in the report. */
export function binTrials(circles: ArrayLike<number>, trials: RankedTrials, soil: Box): CentreMap | null {
  const centre = (i: number) => [circles[trialWidth * i]!, circles[trialWidth * i + 1]!];
  const [low, high] = findWindow(centre(trials.order.at(-1)!), soil);
  const chosen = trials.order.filter((i) => {
    const [x, y] = centre(i);
    const inside = x! >= low[0]! && x! <= high[0]! && y! >= low[1]! && y! <= high[1]!;
    return inside && trials.factors[i]! <= reach * trials.low;
  });
  const box = findBox([Array.from(chosen, centre)])!;
  const size = Math.max(box[1][0]! - box[0][0]!, box[1][1]! - box[0][1]!) / cells;
  if (!(size > 0)) return null;
  const from = box[0].map((x) => x - size / 2);
  const [columns, rows] = [0, 1].map((k) => Math.floor((box[1][k]! - from[k]!) / size) + 1) as [number, number];
  let factor = new Float32Array(columns * rows).fill(Number.NaN);
  // From the safest to the weakest: the last one stays.
  for (const i of chosen) {
    const [x, y] = centre(i);
    factor[Math.floor((y! - from[1]!) / size) * columns + Math.floor((x! - from[0]!) / size)] = trials.factors[i]!;
  }
  for (let pass = 0; pass < 2; ++pass) factor = fillGaps(factor, columns, rows) as Float32Array<ArrayBuffer>;
  const to = [from[0]! + columns * size, from[1]! + rows * size];
  return { from, to, columns, rows, factor, low: trials.low, high: reach * trials.low };
}

/** The map of a search on a grid of centres; `values` 0: none. */
export function takeMap(
  map: { from: number[]; to: number[]; columns: number; rows: number },
  values: Float32Array,
): CentreMap | null {
  const factor = values.map((f) => (f > 0 ? f : Number.NaN));
  const low = factor.reduce((a, b) => (b < a ? b : a), Infinity);
  if (!Number.isFinite(low)) return null;
  const { from, to, columns, rows } = map;
  return { from, to, columns, rows, factor, low, high: reach * low };
}
