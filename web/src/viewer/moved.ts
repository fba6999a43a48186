// SPDX-License-Identifier: MIT
/** The slip surface as the lower limit of the soil that moved. */
import { smooth } from "./smooth";

/**
 * For each column of the section with soil that moved by more than `threshold` [m]: the height that parts best what
 * moved from what stayed, with the fewest points on the wrong side. The longest stretch of such columns, smoothed;
 * empty where fewer than six of them stand side by side.
 *
 * `positions` [point][2] [m], `displacement` [point] [m], `spacing`: mean distance of the points [m].
 */
export function findMovedLimit(
  positions: Float32Array,
  displacement: Float32Array,
  spacing: number,
  threshold: number,
): [number, number][] {
  const width = 1.5 * spacing;
  const columns = new Map<number, number[]>();
  for (let i = 0; i < displacement.length; ++i) {
    if (Number.isNaN(displacement[i]!)) continue;
    const c = Math.floor(positions[2 * i]! / width);
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
    current.push([(c + 0.5) * width, height]);
    if (current.length > longest.length) longest = current;
  }
  return longest.length < 6 ? [] : smooth(longest);
}
