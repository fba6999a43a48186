// SPDX-License-Identifier: MIT
// The displacement curve: which trials rest, where the fitted lines run, and labels that cover nothing.
import { expect, test } from "vitest";

import { findRestLimits, judgeTrial, placeFlags, sampleBranch } from "../../src/charts/curve/curveData";

test("labels cover no other label and no other line, on either side", () => {
  // A small generator with a fixed seed, so that a failure can be repeated.
  let seed = 7;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  for (let round = 0; round < 500; ++round) {
    const at = Array.from({ length: 5 }, () => 60 + 500 * random());
    const widths = at.map(() => 40 + 120 * random());
    const { side, rows } = placeFlags(at, widths, 60 + 600 * random());
    for (let i = 0; i < at.length; ++i)
      for (let k = 0; k < at.length; ++k) {
        const start = side === "right" ? at[i]! : at[i]! - widths[i]!;
        const covers = k !== i && at[k]! > start && at[k]! < start + widths[i]!;
        // The line of k runs from the frame up to its row.
        if (covers) expect(rows[i]).toBeGreaterThan(rows[k]!);
      }
  }
});

test("fitted lines meet where the criterion says and stay inside of the frame", () => {
  const first = { slope: 0.0528, intercept: -0.0581, points: [] };
  const last = { slope: 19.887, intercept: -31.663, points: [] };
  const meet = (first.intercept - last.intercept) / (last.slope - first.slope);
  const points = sampleBranch(last, 1, 1.75, 0, 3);
  expect(points.length).toBeGreaterThan(10);
  for (const [srf, u] of points) {
    expect(u).toBeGreaterThanOrEqual(0);
    expect(u).toBeLessThanOrEqual(3);
    expect(srf < meet).toBe(u < first.slope * srf + first.intercept);
  }
});

test("a trial rests when force ratio and nodal speed are below the case's limits", () => {
  const leaf = (value: unknown) => ({ value, given: true });
  const input = { rest: { force_ratio: leaf(1e-3), speed_ratio: leaf(1e-4) }, gravity: { acceleration: leaf(9.81) } };
  const limits = findRestLimits(input, 10);
  // √(9.81 × 10) = 9.9 m/s
  expect(limits.nodalSpeed).toBeCloseTo(9.9045e-4, 7);
  const trial = { srf: 1.5, displacement: 0.1, end: "time" as const, force_ratio: 5e-4, nodal_speed: 5e-4 };
  expect(judgeTrial(trial, limits)).toBe("rest");
  expect(judgeTrial({ ...trial, force_ratio: 2e-3 }, limits)).toBe("moving");
  expect(judgeTrial({ ...trial, nodal_speed: 2e-3 }, limits)).toBe("moving");
  expect(judgeTrial({ ...trial, end: "failed" }, limits)).toBe("failed");
  expect(judgeTrial({ ...trial, end: "rest", force_ratio: 1 }, limits)).toBe("rest");
  // A report without the table falls back to the program's defaults.
  expect(findRestLimits({}, 10)).toEqual(limits);
});
