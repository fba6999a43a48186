// SPDX-License-Identifier: MIT
/** The slip surface as the lower limit of the soil that moved, and the axis of the largest shear as the ridge of the strain. */
/** Soil on the left of `x` moved in the direction `left` (-1, 1) of x, soil on its right in the other. */
interface Divide {
  x: number;
  left: -1 | 1;
}

/** Share of the soil that moved across that is a side of its own at least. */
const leastSide = 0.05;
/** Share of the smaller side that may lie on the wrong side of the divide. */
const mostMixed = 0.25;

/**
 * The place that best divides points that moved towards smaller x by more than `threshold` [m] from those that moved as
 * far towards larger x, by the rule of the results (src/mesh/divide.hpp); null where all move one way, or the two lie
 * among one another. `x` [point]: where the points lie [m]; `across` [point]: how far they moved along x [m].
 */
function findDivide(x: ArrayLike<number>, across: ArrayLike<number>, threshold: number): Divide | null {
  const moved: number[] = [];
  for (let i = 0; i < across.length; ++i) if (Math.abs(across[i]!) > threshold) moved.push(i);
  moved.sort((a, b) => x[a]! - x[b]!);
  const toLeft = moved.filter((i) => across[i]! < 0).length;
  const smaller = Math.min(toLeft, moved.length - toLeft);
  if (smaller === 0 || smaller < leastSide * moved.length) return null;
  let best: Divide | null = null;
  // Points on the wrong side when those on the left should move to the left.
  let [wrong, fewest] = [toLeft, mostMixed * smaller];
  moved.slice(0, -1).forEach((i, k) => {
    wrong += across[i]! < 0 ? -1 : 1;
    const least = Math.min(wrong, moved.length - wrong);
    if (least >= fewest) return;
    fewest = least;
    best = { x: 0.5 * (x[i]! + x[moved[k + 1]!]!), left: wrong < moved.length - wrong ? -1 : 1 };
  });
  return best;
}

const average = (some: number[]) => some.reduce((a, b) => a + b, 0) / some.length;
const findMiddle = (some: number[]) => some.sort((a, b) => a - b)[some.length >> 1]!;

/**
 * A median over five neighbours takes out jumps, means over five round what is left. Towards the ends the neighbourhood
 * shrinks and stays symmetric, so that the line is not drawn away from where it comes to the surface.
 */
function smooth(line: [number, number][]): [number, number][] {
  const around = (ys: number[], i: number) => {
    const reach = Math.min(2, i, ys.length - 1 - i);
    return ys.slice(i - reach, i + reach + 1);
  };
  let ys = line.map((p) => p[1]);
  ys = ys.map((_, i) => findMiddle(around(ys, i)));
  for (let round = 0; round < 3; ++round) ys = ys.map((_, i) => average(around(ys, i)));
  return line.map((p, i) => [p[0], ys[i]!]);
}

type Line = [number, number][];
/** Rise of the plane that a wedge of soil sinks along, 45° + φ/2, for φ = 30°. */
const wedgeSlope = Math.sqrt(3);

/** Left end of the points [m]: columns counted from there divide the soil alike wherever the axes begin. */
function findLeft(positions: ArrayLike<number>): number {
  let left = Infinity;
  for (let i = 0; i < positions.length; i += 2) if (positions[i]! < left) left = positions[i]!;
  return left;
}

/** Points with a value by the column of the section in which they lie. */
function groupColumns(positions: ArrayLike<number>, values: Float32Array, left: number, width: number) {
  const columns = new Map<number, number[]>();
  values.forEach((value, i) => {
    if (Number.isNaN(value)) return;
    const c = Math.floor((positions[2 * i]! - left) / width);
    columns.set(c, columns.get(c) ?? []);
    columns.get(c)!.push(i);
  });
  return columns;
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
  const columns = groupColumns(positions, displacement, left, width);

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

/**
 * Returns the line along which the soil shears most: for each column of the section the height of the largest deviatoric strain, smoothed, over
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
  const columns = groupColumns(positions, strain, left, width);

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
