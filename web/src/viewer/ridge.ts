// SPDX-License-Identifier: MIT
/** Axis of the largest shear: the ridge of the deviatoric strain. */
import { findLeft } from "./moved";
import { smooth } from "./smooth";

/**
 * Where soil shears most: for each column of the section the height of the largest deviatoric strain, smoothed, over
 * the longest stretch of columns in which it is well above the median of all points. Empty where there is no band.
 *
 * `positions` [point][2] [m], `strain` [point], `spacing`: mean distance of the points [m].
 */
export function findStrainRidge(positions: ArrayLike<number>, strain: Float32Array, spacing: number): [number, number][] {
  const count = strain.length;
  // Some thousand points give the median as well as all, and sorting them does not delay the animation.
  const stride = Math.max(1, Math.floor(count / 4000));
  const sorted = strain.filter((s, i) => i % stride === 0 && !Number.isNaN(s)).sort();
  if (sorted.length < 50) return [];
  const [median, peak] = [sorted[sorted.length >> 1]!, sorted[Math.floor(0.99 * sorted.length)]!];
  const threshold = Math.max(4 * median, 0.3 * peak);
  if (!(peak > 8 * median)) return [];

  const [width, left] = [1.5 * spacing, findLeft(positions)];
  const columns = new Map<number, number[]>();
  for (let i = 0; i < count; ++i) {
    if (Number.isNaN(strain[i]!)) continue;
    const c = Math.floor((positions[2 * i]! - left) / width);
    const column = columns.get(c);
    if (column) column.push(i);
    else columns.set(c, [i]);
  }

  /** Height of the ridge in a column: mean of its band, weighted with the strain; null without a band. */
  function findHeight(c: number): number | null {
    let best = -1;
    const column = columns.get(c) ?? [];
    for (const i of column) if (best < 0 || strain[i]! > strain[best]!) best = i;
    if (best < 0 || strain[best]! < threshold) return null;
    let [sum, weight] = [0, 0];
    for (const i of column) {
      if (Math.abs(positions[2 * i + 1]! - positions[2 * best + 1]!) > 3 * spacing) continue;
      const w = strain[i]! ** 3;
      sum += w * positions[2 * i + 1]!;
      weight += w;
    }
    return sum / weight;
  }

  const order = [...columns.keys()].sort((a, b) => a - b);
  let [longest, current]: [[number, number][], [number, number][]] = [[], []];
  let gap = 0;
  for (let c = order[0]!; c <= order.at(-1)!; ++c) {
    const y = findHeight(c);
    if (y === null && ++gap <= 2) continue;
    if (y === null) current = [];
    else [gap] = [0, current.push([left + (c + 0.5) * width, y])];
    if (current.length > longest.length) longest = current;
  }
  return longest.length < 6 ? [] : smooth(longest);
}
