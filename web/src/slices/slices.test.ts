// SPDX-License-Identifier: MIT
/** Slices: the table, the trials, the map of centres. */
import { beforeEach, describe, expect, it } from "vitest";

import type { CriticalSurface, Report } from "../contract";
import { orderValues } from "../charts/base/rows";
import { report } from "../state";
import { binTrials, traceContour } from "./centreMap";
import { chooseLimit, findTrial, makeBands } from "./trialPainter";
import { makeSliceTable, rankTrials } from "./sliceData";
import { traceThrust } from "./surfacePainter";
import { listIdle } from "./SupportTable";

const units = {
  length: { name: "m", si: 1 },
  displacement: { name: "mm", si: 1e-3 },
  stress: { name: "kPa", si: 1e3 },
  line_force: { name: "kN/m", si: 1e3 },
};

beforeEach(() => {
  report.value = { units } as Report;
});

const zeros = [0, 0];
const surface = {
  slices: {
    soil: ["clay", "clay"],
    left: [0, 1],
    right: [1, 2],
    base_left: [
      [0, 0],
      [1, 0],
    ],
    base_right: [
      [1, 0],
      [2, 0],
    ],
    top_left: [2, 2],
    top_right: [2, 2],
    alpha: [0, Math.PI / 6],
    length: [1, 2],
    weight: [4e4, 5e4],
    surface_load: zeros,
    surface_thrust: zeros,
    earthquake: zeros,
    pore_pressure: [1e4, -5e3],
    cohesion: [5e3, 5e3],
    root_cohesion: zeros,
    suction_strength: [0, 1e3],
    tan_friction: [Math.tan(Math.PI / 6), 0],
    normal: [4e4, 4.5e4],
    shear: [1e4, 1e4],
    m_alpha: [1, 0.9],
    normal_right: zeros,
    shear_right: zeros,
    thrust_right: zeros,
  },
} as unknown as CriticalSurface;

describe("the slice table", () => {
  const column = (name: string) => makeSliceTable(surface).find((c) => c.name === name);

  it("shows forces in kN/m, stresses in kPa, angles in degrees", () => {
    expect(column("weight")).toMatchObject({ unit: "kN/m", values: [40, 50] });
    expect(column("pore_pressure")).toMatchObject({ unit: "kPa", values: [10, -5] });
    expect(column("alpha")!.values[1]).toBeCloseTo(30, 12);
    expect(column("friction")!.values[0]).toBeCloseTo(30, 12);
  });

  it("takes the pore pressure off the normal force, and no suction", () => {
    expect(column("effective_normal")!.values).toEqual([30, 45]);
  });

  it("leaves out what is zero everywhere, and keeps the rest", () => {
    for (const name of ["surface_load", "earthquake", "root_cohesion", "normal_right", "soil"])
      expect(column(name), name).toBeUndefined();
    for (const name of ["suction_strength", "cohesion"]) expect(column(name), name).toBeDefined();
  });
});

describe("the line of thrust", () => {
  const slices = {
    right: [1, 2, 3, 4, 5],
    base_right: [0, 0, 0, 0, 0].map((y, i) => [i + 1, y]),
    top_right: [2, 2, 2, 2, 2],
  };
  const trace = (thrust_right: (number | null)[]) =>
    traceThrust({ slices: { ...slices, thrust_right } } as unknown as CriticalSurface);

  it("is drawn in the mass or just beside it, without its last point", () => {
    expect(trace([0.5, 0.7, -0.3, 2.4, 1])).toEqual([
      [
        [1, 0.5],
        [2, 0.7],
        [3, -0.3],
        [4, 2.4],
      ],
    ]);
  });

  it("is broken where it runs away", () => {
    expect(trace([0.5, 0.6, 1e6, 0.7, 0])).toEqual([
      [
        [1, 0.5],
        [2, 0.6],
      ],
    ]);
    expect(trace([null, -50, 40, null, 0])).toEqual([]);
  });
});

describe("bands of the trials", () => {
  it("run from the smallest factor to the chosen one, and end at round factors", () => {
    const { levels, scale } = makeBands(1.177, 1.42, new Uint8Array(1024));
    expect(levels.map((l) => l.text)).toEqual(["1.177", "1.20", "1.25", "1.30", "1.35", "1.40", "1.42"]);
    expect([scale.low, scale.high]).toEqual([1.177, 1.42]);
  });

  it("are never more than nine, and at least one", () => {
    for (const limit of [0.5, 1.01, 1.1, 1.5, 3, 40]) {
      const { levels } = makeBands(1, limit, new Uint8Array(1024));
      expect(levels.length, `up to ${limit}`).toBeGreaterThanOrEqual(2);
      expect(levels.length, `up to ${limit}`).toBeLessThanOrEqual(10);
    }
    expect(chooseLimit(1.177)).toBe(1.41);
  });
});

/** Half circles below y = 0 about (x, 0): [x, y, r, from, to]. */
const circle = (x: number, y: number, r: number) => [x, y, r, x - r, x + r];

describe("trials", () => {
  const circles = Float64Array.from([...circle(0, 0, 1), ...circle(0, 0, 2), ...circle(1, 1, 2), ...circle(90, 1, 2)]);
  // Two methods; 0 is refused.
  const factors = [1.5, 9, 1.2, 9, 0, 9, 1.4, 9];

  it("are ranked from the safest to the weakest, without the refused", () => {
    const ranked = rankTrials(factors, 2, 0)!;
    expect(Array.from(ranked.order)).toEqual([0, 3, 1]);
    expect(ranked.low).toBeCloseTo(1.2, 6);
    expect(rankTrials([0, 0], 1, 0)).toBeNull();
  });

  it("are found under the pointer: the weakest of those that pass there", () => {
    const ranked = rankTrials(factors, 2, 0)!;
    expect(findTrial([0, -1], 0.05, circles, ranked, Infinity)).toBe(0);
    expect(findTrial([0, -2.02], 0.05, circles, ranked, Infinity)).toBe(1);
    expect(findTrial([0, 2], 0.05, circles, ranked, Infinity)).toBe(-1);
    expect(findTrial([0, -1], 0.05, circles, ranked, 1.3), "not drawn").toBe(-1);
    // The third was refused, though it passes here.
    expect(findTrial([1, -1], 0.01, circles, ranked, Infinity)).toBe(-1);
  });

  it("are binned by centre: the weakest of a cell stays, far ones are left out", () => {
    const map = binTrials(circles, rankTrials([1.5, 1.2, 1.3, 1.4], 1, 0)!, [
      [-5, -5],
      [5, 0],
    ])!;
    expect(map.to[0]).toBeLessThan(10);
    const at = (x: number, y: number) =>
      map.factor[
        Math.floor(((y - map.from[1]!) / (map.to[1]! - map.from[1]!)) * map.rows) * map.columns +
          Math.floor(((x - map.from[0]!) / (map.to[0]! - map.from[0]!)) * map.columns)
      ];
    expect(at(0, 0)).toBeCloseTo(1.2, 6);
    expect(at(1, 1)).toBeCloseTo(1.3, 6);
    expect(at(0, 1)).toBeNaN();
  });
});

describe("contours", () => {
  it("follow a plane's lines of equal value, and stop at gaps", () => {
    const lines = traceContour(4, 3, (i, j) => i + 2 * j, 2.5);
    expect(lines.length).toBeGreaterThan(0);
    // Values belong to the middles of the cells.
    for (const [x0, y0, x1, y1] of lines)
      for (const [x, y] of [
        [x0, y0],
        [x1, y1],
      ] as const)
        expect(x - 0.5 + 2 * (y - 0.5)).toBeCloseTo(2.5, 12);
    expect(traceContour(2, 2, (i, j) => (i + j ? 1 : Number.NaN), 0.5)).toEqual([]);
  });
});

describe("the order of a table", () => {
  it("puts missing values last, whichever way", () => {
    expect(orderValues([2, null, 1], false)).toEqual([2, 0, 1]);
    expect(orderValues([2, null, 1], true)).toEqual([0, 2, 1]);
    expect(orderValues(["sand", "clay"], false)).toEqual([1, 0]);
  });
});

it("names rows without force on a surface once, pieces of a wall as one", () => {
  const bars = [
    { support: "nails", row: 1 }, { support: "nails", row: 2 }, { support: "wall", row: 1 }, { support: "wall", row: 1 },
  ];
  expect(listIdle(bars, [{ support: "nails", row: 2 }])).toEqual(["nails 1", "wall 1"]);
  expect(listIdle(bars, [])).toEqual(["nails 1", "nails 2", "wall 1"]);
});
