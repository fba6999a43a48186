// SPDX-License-Identifier: MIT
/** The body of a section: its area, its gaps, its surface, whether every pixel of it has a point. */
import { describe, expect, it } from "vitest";

import { findCells, measureArea, type Cells } from "./cells";
import { findMovedLimits } from "./slipLines";
import { toLocal } from "./painter";
import { distributeVolume } from "./sizes";

/** Points near the middles of squares of side 0.5 in a box of 20 m by 10 m, those left out where `isGap`. */
function makeBlock(isGap: (x: number, y: number) => boolean = () => false) {
  const at: number[] = [];
  let seed = 1;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5;
  for (let x = 0.25; x < 20; x += 0.5)
    for (let y = 0.25; y < 10; y += 0.5) if (!isGap(x, y)) at.push(x + 0.2 * random(), y + 0.2 * random());
  return { positions: Float32Array.from(at), sizes: new Float32Array(at.length / 2).fill(0.5) };
}

/** Returns whether a place lies in one of the triangles. */
function isCovered(cover: ArrayLike<number>, x: number, y: number): boolean {
  for (let t = 0; t < cover.length; t += 6) {
    const side = (i: number, j: number) => {
      const [fromX, fromY] = [cover[t + i]!, cover[t + i + 1]!];
      return (cover[t + j]! - fromX) * (y - fromY) - (cover[t + j + 1]! - fromY) * (x - fromX);
    };
    const [a, b, c] = [side(0, 2), side(2, 4), side(4, 0)];
    if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) return true;
  }
  return false;
}

/** The painter's rule for a pixel: it belongs to the nearest point, if its cell extends to it. */
function isDrawn(cells: Cells, positions: Float32Array, x: number, y: number): boolean {
  let [best, distance] = [-1, Infinity];
  for (let i = 0; i < cells.radii.length; ++i) {
    const d = Math.hypot(positions[2 * i]! - x, positions[2 * i + 1]! - y);
    if (d <= cells.radii[i]! * 1.0001 && d < distance) [best, distance] = [i, d];
  }
  return best >= 0 && (distance <= cells.reach[best]! || isCovered(cells.cover, x, y));
}

describe("cells of a block", () => {
  const { positions, sizes } = makeBlock();
  const cells = findCells(positions, sizes, [0, 0, 20]);

  it("have its area, and end within half a point of its surface", () => {
    expect(cells.outlines.length).toBe(1);
    expect(Math.abs(measureArea(cells.outlines[0]!))).toBeCloseTo(200, -1);
    expect(Math.abs(Math.abs(measureArea(cells.outlines[0]!)) - 200)).toBeLessThan(3);
    for (const [x, y] of cells.outlines[0]!) {
      expect(x).toBeGreaterThanOrEqual(0);
      expect(x).toBeLessThanOrEqual(20);
      expect(y).toBeGreaterThanOrEqual(0);
      expect(y).toBeLessThan(10.25);
    }
  });

  it("leave no hole, and nothing is drawn more than half a point outside", () => {
    for (let k = 0; k < 600; ++k) {
      const [x, y] = [0.3 + ((k * 0.7548776662) % 1) * 19.4, 0.3 + ((k * 0.5698402909) % 1) * 9.4];
      expect(isDrawn(cells, positions, x, y)).toBe(true);
      expect(isDrawn(cells, positions, x, 10.3)).toBe(false);
    }
  });
});

it("leaves a gap of six points open and closes one of a single point", () => {
  const wide = makeBlock((x, y) => Math.hypot(x - 10, y - 5) < 1.5);
  const open = findCells(wide.positions, wide.sizes);
  expect(isDrawn(open, wide.positions, 10, 5)).toBe(false);
  expect(open.outlines.length).toBe(2);
  const narrow = makeBlock((x, y) => x === 10.25 && y === 5.25);
  const closed = findCells(narrow.positions, narrow.sizes);
  expect(isDrawn(closed, narrow.positions, 10.25, 5.25)).toBe(true);
  expect(closed.outlines.length).toBe(1);
});

it("draws no point that left the grid, and a lonely one with half its size", () => {
  const { positions, sizes } = makeBlock();
  positions.set([NaN, NaN], 2 * 7);
  positions.set([40, 3], 2 * 9);
  const { radii } = findCells(positions, sizes);
  expect(radii[7]).toBe(0);
  expect(radii[9]).toBeCloseTo(0.25, 6);
});

it("handles few points, to points in a line and to points at the same place", () => {
  for (const at of [[], [1, 1], [1, 1, 2, 2], [0, 0, 1, 0, 2, 0, 3, 0], [1, 1, 1, 1, 1, 1, 2, 2]]) {
    const { radii } = findCells(Float32Array.from(at), new Float32Array(at.length / 2).fill(0.5));
    for (const radius of radii) expect(radius).toBeGreaterThanOrEqual(0.25);
  }
});

it("divides the body by volume: squares and cubes together fill what the mean ones do", () => {
  const sizes = distributeVolume([1, 4, 4, 7, NaN], 5, 2, 2);
  expect([...sizes].slice(0, 4).reduce((sum, side) => sum + side ** 2, 0)).toBeCloseTo(4 * 2 ** 2, 4);
  expect(sizes[1]! / sizes[0]!).toBeCloseTo(2, 6);
  expect(sizes[4]).toBe(2);
  const cubes = distributeVolume([1, 8], 2, 1, 3);
  expect(cubes[1]! / cubes[0]!).toBeCloseTo(2, 6);
});

describe("a body in the coordinates of a map", () => {
  const { positions, sizes } = makeBlock((x, y) => y > 4 + 0.3 * x);
  const origin: [number, number, number] = [500_000.25, 4_000_000.5, 0];
  const moved = Float64Array.from(positions, (x, i) => x + origin[i % 2]!);
  const here = findCells(positions, sizes, [0, 0, 20]);
  const there = findCells(moved, sizes, [origin[0], origin[1], origin[0] + 20]);

  it("has the cells, cover and outlines of the same body at the origin of the axes", () => {
    const largest = (a: ArrayLike<number>, b: ArrayLike<number>) =>
      Math.max(...Array.from(a, (v, i) => Math.abs(v - b[i]!)));
    expect(there.outlines.length).toBe(here.outlines.length);
    expect(largest(there.radii, here.radii)).toBeLessThan(1e-6);
    const cover = toLocal(there.cover, 2, origin);
    expect(cover.length).toBe(here.cover.length);
    expect(largest(cover, here.cover)).toBeLessThan(1e-6);
    expect(Math.abs(measureArea(there.outlines[0]!))).toBeCloseTo(Math.abs(measureArea(here.outlines[0]!)), 5);
  });

  it("has the slip surface of the same body at the origin of the axes", () => {
    const displacement = Float32Array.from({ length: sizes.length }, (_, i) =>
      positions[2 * i + 1]! > 2 + 0.1 * positions[2 * i]! ? 1 : 0,
    );
    const [line] = findMovedLimits(positions, displacement, null, 0.5, 0.5);
    const [other] = findMovedLimits(moved, displacement, null, 0.5, 0.5);
    expect(other!.length).toBe(line!.length);
    line!.forEach((p, i) => {
      expect(other![i]![0] - origin[0]).toBeCloseTo(p[0], 6);
      expect(other![i]![1] - origin[1]).toBeCloseTo(p[1], 6);
    });
  });
});
