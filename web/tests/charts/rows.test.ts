// SPDX-License-Identifier: MIT
/** Rows of a table: the nearest one, and those that a chart needs. */
import { expect, test } from "vitest";

import { findNearest, findNearestFrame, pickRows } from "../../src/charts/base/rows";

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

test("extremes of every stretch, ends and gaps stay; the rest is few", () => {
  const values = Array.from({ length: 20000 }, (_, i): number | null => Math.sin(i * 0.37) * Math.exp(-i / 5000));
  values[7777] = 40; // one row that flies away
  values[12345] = null;
  const rows = pickRows(values, 500);
  expect(rows.length).toBeLessThan(1600);
  expect(rows).toEqual([...new Set(rows)].sort((a, b) => a - b));
  for (const row of [0, 7777, 12345, 19999]) expect(rows).toContain(row);
  const kept = new Set(rows);
  for (let c = 0; c < 500; ++c) {
    const stretch = Array.from({ length: 40 }, (_, k) => c * 40 + k);
    const whole = stretch.map((i) => values[i]!).filter((v) => v !== null);
    const shown = stretch.filter((i) => kept.has(i)).map((i) => values[i]!).filter((v) => v !== null);
    expect(Math.max(...shown)).toBe(Math.max(...whole));
    expect(Math.min(...shown)).toBe(Math.min(...whole));
  }
});

test("short histories are drawn whole", () => {
  expect(pickRows([1, 2, null, 3], 300)).toEqual([0, 1, 2, 3]);
});
