// SPDX-License-Identifier: MIT
/** Smoothing of a line over columns of the section. */

const average = (some: number[]) => some.reduce((a, b) => a + b, 0) / some.length;
const findMiddle = (some: number[]) => some.sort((a, b) => a - b)[some.length >> 1]!;

/**
 * A median over five neighbours takes out jumps, means over five round what is left. Towards the ends the neighbourhood
 * shrinks and stays symmetric, so that the line is not drawn away from where it comes to the surface.
 */
export function smooth(line: [number, number][]): [number, number][] {
  const around = (ys: number[], i: number) => {
    const reach = Math.min(2, i, ys.length - 1 - i);
    return ys.slice(i - reach, i + reach + 1);
  };
  let ys = line.map((p) => p[1]);
  ys = ys.map((_, i) => findMiddle(around(ys, i)));
  for (let round = 0; round < 3; ++round) ys = ys.map((_, i) => average(around(ys, i)));
  return line.map((p, i) => [p[0], ys[i]!]);
}
