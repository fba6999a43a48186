// SPDX-License-Identifier: MIT
/** Values over height along a vertical section: the points within a band around it, binned by height. */

export interface Section {
  /** Coordinates of the points, [point][dimension] [m]. */
  positions: ArrayLike<number>;
  dimension: 2 | 3;
  /** Axis that points up. */
  vertical: number;
  /** Middle of the band along each axis [m]; null: all of this axis. */
  at: (number | null)[];
  /** Half the width of the band [m]. */
  half: number;
}

export interface Bin {
  /** Number of the layer, counted from the bottom. */
  layer: number;
  /** Mean height of the points of the bin [m]. */
  height: number;
  mean: number;
  min: number;
  max: number;
  count: number;
}

/** Indices of the points inside the band; points without a place (NaN: left the grid) are in none. */
export function selectPoints({ positions, dimension, vertical, at, half }: Section): number[] {
  const found: number[] = [];
  for (let p = 0; p < positions.length / dimension; ++p) {
    let inside = true;
    for (let d = 0; d < dimension && inside; ++d) {
      const x = positions[p * dimension + d]!;
      const middle = at[d] ?? null;
      inside = Number.isFinite(x) && (d === vertical || middle === null || Math.abs(x - middle) <= half);
    }
    if (inside) found.push(p);
  }
  return found;
}

/**
 * Means of the points' `values` in layers of `height` [m] above `bottom` [m]: from below, empty layers left out.
 * Values that are NaN do not count.
 */
export function makeProfile(section: Section, values: Float32Array, bottom: number, height: number): Bin[] {
  const bins = new Map<number, Bin>();
  for (const p of selectPoints(section)) {
    const value = values[p]!;
    if (!Number.isFinite(value)) continue;
    const y = section.positions[p * section.dimension + section.vertical]!;
    const key = Math.floor((y - bottom) / height);
    let bin = bins.get(key);
    if (!bin) bins.set(key, (bin = { layer: key, height: 0, mean: 0, min: Infinity, max: -Infinity, count: 0 }));
    bin.height += y;
    bin.mean += value;
    bin.min = Math.min(bin.min, value);
    bin.max = Math.max(bin.max, value);
    ++bin.count;
  }
  return [...bins]
    .sort(([a], [b]) => a - b)
    .map(([, b]) => ({ ...b, height: b.height / b.count, mean: b.mean / b.count }));
}

/** Thickness of the layers [m]: half a mean element, so that a layer of the band still holds a few points. */
export function findLayer(meanSize: number): number {
  return meanSize / 2;
}

/** Row `frame` of an array [frame][...]. */
export function takeFrame<A extends Float32Array | Float64Array>(values: A, shape: readonly number[], frame: number): A {
  const row = shape.slice(1).reduce((a, b) => a * b, 1);
  return values.subarray(frame * row, (frame + 1) * row) as A;
}
