// SPDX-License-Identifier: MIT
/** The slip surface as the lower limit of the soil that moved. */
import { findDivide, type Divide } from "./divide";
import { smooth } from "./smooth";

type Line = [number, number][];
/** Rise of the plane that a wedge of soil sinks along, 45° + φ/2, for φ = 30°. */
const wedgeSlope = Math.sqrt(3);

/** Left end of the points [m]: columns counted from there divide the soil alike wherever the axes begin. */
export function findLeft(positions: ArrayLike<number>): number {
  let left = Infinity;
  for (let i = 0; i < positions.length; i += 2) if (positions[i]! < left) left = positions[i]!;
  return left;
}

/** Leads the line of a side that ends under the divide, where the other side begins, up to the ground beyond it. */
function leadUp(line: Line, positions: ArrayLike<number>, spacing: number, divide: Divide, isLeft: boolean): Line {
  const end = (isLeft ? line.at(-1) : line[0])!;
  const [width, start] = [1.5 * spacing, findLeft(positions)];
  if (Math.abs(end[0] - divide.x) > 2 * width) return line; // the soil between the sides stayed
  const tops = new Map<number, number>();
  for (let i = 0; i < positions.length; i += 2) {
    const c = Math.floor((positions[i]! - start) / width);
    tops.set(c, Math.max(tops.get(c) ?? -Infinity, positions[i + 1]!));
  }
  const added: Line = [];
  for (let k = 1; ; ++k) {
    const rise = (k * spacing) / 2;
    const next: [number, number] = [end[0] + (isLeft ? rise : -rise), end[1] + wedgeSlope * rise];
    const top = tops.get(Math.floor((next[0] - start) / width));
    if (top === undefined) break;
    added.push(next);
    if (next[1] >= top) break;
  }
  return isLeft ? [...line, ...added] : [...added.reverse(), ...line];
}

/**
 * The lower limits of the soil that moved: one, or one of each side where the soil moves to both, which goes on from the
 * divide to the ground as steep as an active wedge where the sides move apart. `across` [point]: how far points moved
 * along x [m]; null: not known, and one limit is drawn. The rest as for findMovedLimit().
 */
export function findMovedLimits(
  positions: ArrayLike<number>,
  displacement: Float32Array,
  across: Float32Array | null,
  spacing: number,
  threshold: number,
): Line[] {
  const keep = (lines: Line[]) => lines.filter((line) => line.length > 0);
  const xs = displacement.map((_, i) => positions[2 * i]!);
  const divide = across && findDivide(xs, across, threshold);
  if (!divide) return keep([findMovedLimit(positions, displacement, spacing, threshold)]);
  const sides = [true, false].map((isLeft) => {
    const own = displacement.map((u, i) => (xs[i]! < divide.x === isLeft ? u : NaN));
    const line = findMovedLimit(positions, own, spacing, threshold);
    return line.length && divide.left < 0 ? leadUp(line, positions, spacing, divide, isLeft) : line;
  });
  return keep(sides);
}

/**
 * For each column of the section with soil that moved by more than `threshold` [m]: the height that parts best what
 * moved from what stayed, with the fewest points on the wrong side. The longest stretch of such columns, smoothed;
 * empty where fewer than six of them are adjacent.
 *
 * `positions` [point][2] [m], `displacement` [point] [m], `spacing`: mean distance of the points [m].
 */
export function findMovedLimit(
  positions: ArrayLike<number>,
  displacement: Float32Array,
  spacing: number,
  threshold: number,
): [number, number][] {
  const [width, left] = [1.5 * spacing, findLeft(positions)];
  const columns = new Map<number, number[]>();
  for (let i = 0; i < displacement.length; ++i) {
    if (Number.isNaN(displacement[i]!)) continue;
    const c = Math.floor((positions[2 * i]! - left) / width);
    const column = columns.get(c);
    if (column) column.push(i);
    else columns.set(c, [i]);
  }

  /** null where nothing moved. */
  function findHeight(column: number[]): number | null {
    const heightOf = (i: number) => positions[2 * i + 1]!;
    const hasMoved = (i: number) => displacement[i]! > threshold;
    column.sort((a, b) => heightOf(a) - heightOf(b));
    // With the limit under all points those that stayed are on the wrong side; it then climbs point by point.
    let wrong = column.filter((i) => !hasMoved(i)).length;
    if (wrong === column.length) return null;
    let [fewest, height] = [wrong, heightOf(column[0]!) - spacing / 2];
    column.forEach((i, k) => {
      wrong += hasMoved(i) ? 1 : -1;
      const next = column[k + 1];
      if (wrong < fewest && next !== undefined) [fewest, height] = [wrong, (heightOf(i) + heightOf(next)) / 2];
    });
    return height;
  }

  let [longest, current]: [[number, number][], [number, number][]] = [[], []];
  let last = -Infinity;
  for (const c of [...columns.keys()].sort((a, b) => a - b)) {
    const height = findHeight(columns.get(c)!);
    if (height === null) continue;
    if (c - last > 2) current = [];
    last = c;
    current.push([left + (c + 0.5) * width, height]);
    if (current.length > longest.length) longest = current;
  }
  return longest.length < 6 ? [] : smooth(longest);
}
