// SPDX-License-Identifier: MIT
// Profiles along a vertical section: a field that is linear in height is found again, from the right points.
import { expect, test } from "vitest";

import { findLayer, makeProfile, selectPoints, takeFrame } from "../../src/charts/profile/profileData";

/** A regular cloud over [0, 20] × [0, 10] at distance 0.25 with the stress −20 kPa/m × depth, and 1e9 left of x = 5. */
function makeCloud() {
  const positions: number[] = [];
  const values: number[] = [];
  for (let x = 0.125; x < 20; x += 0.25)
    for (let y = 0.125; y < 10; y += 0.25) {
      positions.push(x, y);
      values.push(x < 5 ? 1e9 : -20e3 * (10 - y));
    }
  return { positions: Float32Array.from(positions), values: Float32Array.from(values) };
}

test("geostatic stress along a section comes back at the height of its layers", () => {
  const { positions, values } = makeCloud();
  const section = { positions, dimension: 2 as const, vertical: 1, at: [6, null], half: 0.5 };
  const bins = makeProfile(section, values, 0, findLayer(1));
  expect(bins).toHaveLength(20);
  for (const bin of bins) {
    expect(bin.mean).toBeCloseTo(-20e3 * (10 - bin.height), 0);
    expect(bin.min).toBeLessThan(bin.mean);
    expect(bin.max).toBeGreaterThan(bin.mean);
    expect(bin.count).toBe(8);
  }
  expect(bins.map((b) => b.layer)).toEqual(bins.map((_, i) => i));
});

test("points that left the grid, and values that are none, count nowhere", () => {
  const positions = Float32Array.from([1, 1, Number.NaN, Number.NaN, 1, 2]);
  const section = { positions, dimension: 2 as const, vertical: 1, at: [1, null], half: 0.5 };
  expect(selectPoints(section)).toEqual([0, 2]);
  expect(makeProfile(section, Float32Array.from([7, 8, Number.NaN]), 0, 1)).toEqual([
    { layer: 1, height: 1, mean: 7, min: 7, max: 7, count: 1 },
  ]);
});

test("in space the band is a column of square section; the frame decides where points are", () => {
  const frames = Float32Array.from([0, 0, 0, 1, 5, 1, 2, 5, 2, /* second frame */ 9, 9, 9, 1, 5, 1.4, 1, 5, 3]);
  const section = (frame: number) => ({
    positions: takeFrame(frames, [2, 3, 3], frame),
    dimension: 3 as const,
    vertical: 1,
    at: [1, null, 1],
    half: 0.5,
  });
  expect(selectPoints(section(0))).toEqual([1]);
  expect(selectPoints(section(1))).toEqual([1]);
  expect(selectPoints({ ...section(1), at: [1, null, null] })).toEqual([1, 2]);
});
