// SPDX-License-Identifier: MIT
// The crosshair reads the nearest value, compared with a plain search over all of them.
import { expect, test } from "vitest";

import { findNearest, findNearestFrame } from "../../src/charts/base/rows";

test("the nearest of uneven abscissas, against a search over all", () => {
  const sorted = [1, 1.05, 1.1, 1.5, 1.52, 1.55, 1.57, 1.58, 1.6, 1.61, 1.7, 1.75];
  for (let x = 0.8; x < 1.9; x += 0.0037) {
    const least = Math.min(...sorted.map((s) => Math.abs(s - x)));
    expect(Math.abs(sorted[findNearest(sorted, x)]! - x)).toBeCloseTo(least, 12);
  }
});

test("ends, one value, none", () => {
  expect(findNearest([2, 3], -Infinity)).toBe(0);
  expect(findNearest([2, 3], 99)).toBe(1);
  expect(findNearest([5], 1)).toBe(0);
  expect(findNearest([], 1)).toBe(-1);
  expect(findNearest([1, 2], Number.NaN)).toBe(-1);
});

test("frames without a factor are passed over", () => {
  const frames = [{ factor: null }, { factor: 1.4 }, { factor: null }, { factor: 1.6 }];
  expect(findNearestFrame(frames, (f) => f.factor, 1.59)).toBe(3);
  expect(findNearestFrame(frames.slice(0, 1), (f) => f.factor, 1)).toBe(-1);
});
