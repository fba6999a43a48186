// SPDX-License-Identifier: MIT
// A thinned history shows every peak and every gap of the whole one.
import { expect, test } from "vitest";

import { pickRows } from "../../src/charts/base/rows";

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
