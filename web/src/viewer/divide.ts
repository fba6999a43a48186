// SPDX-License-Identifier: MIT
/** Divides a section whose soil moves to both sides, such as an embankment on soft ground. */

/** Soil on the left of `x` moved in the direction `left` (-1, 1) of x, soil on its right in the other. */
export interface Divide {
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
export function findDivide(x: ArrayLike<number>, across: ArrayLike<number>, threshold: number): Divide | null {
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
