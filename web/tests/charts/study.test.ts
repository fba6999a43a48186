// SPDX-License-Identifier: MIT
// The table of a study: order of its rows, groups of lines, and differences from published values.
import { expect, test } from "vitest";

import { measureDifference } from "../../src/charts/compare/CompareSection";
import { orderValues } from "../../src/charts/base/rows";
import { findBars, findGoals, findNumeric, makeStudyColumns, nameGroup, takeOrdered } from "../../src/charts/study/studyData";

const column = (name: string, values: (number | null)[], shown = values.map((v) => (v === null ? "" : String(v)))) =>
  ({ name, title: name, unit: "-", shown, values });

const study = {
  mode: "all",
  reference: "",
  vary: [{ key: "mesh.size", unit: "", values: [] }, { key: "mesh.algorithm", unit: "", values: [] }],
  columns: [
    column("mesh.size", [0.75, 10, 2, 0.5]),
    column("mesh.algorithm", [null, null, null, null], ["delaunay", "frontal", "delaunay", "frontal"]),
    column("factor", [1.42, null, 1.5, -1]),
    column("never", [null, null, null, null]),
  ],
  rows: ["a", "b", "c", "d"].map((name, i) =>
    i === 1 ?
      { name, folder: name, status: "failed" as const, reason: "no, mesh", warnings: [] }
    : { name, folder: name, status: "finished" as const, reason: "", warnings: [] },
  ),
};

test("rows are ordered as numbers, and missing ones stand last both ways", () => {
  const order = (k: number, down: boolean) => orderValues(takeOrdered(study.columns[k]!), down);
  expect(order(0, false)).toEqual([3, 0, 2, 1]);
  expect(order(2, false)).toEqual([3, 0, 2, 1]);
  expect(order(2, true)).toEqual([2, 0, 3, 1]);
  expect(order(1, false)).toEqual([0, 2, 1, 3]);
});

test("a line holds the variants that differ only in the key on the axis", () => {
  expect(nameGroup(study, 0, "mesh.size")).toBe(nameGroup(study, 2, "mesh.size"));
  expect(nameGroup(study, 0, "mesh.size")).not.toBe(nameGroup(study, 1, "mesh.size"));
  expect(findNumeric(study).map((c) => c.name)).toEqual(["factor"]);
});

test("the CSV keeps numbers as numbers, words as words, and the reason of what is missing", () => {
  const columns = makeStudyColumns(study);
  expect(columns.find((c) => c.name === "factor")!.values).toEqual([1.42, null, 1.5, -1]);
  expect(columns.find((c) => c.name === "mesh.algorithm")!.values[1]).toBe("frontal");
  expect(columns.at(-1)!.values[1]).toBe("no, mesh");
});

test("differences over tolerances: one is the edge of passing", () => {
  const d = measureDifference({ computed: 1.54, published: 1.6, tolerance: 0.06 });
  expect(d.overTolerance).toBeCloseTo(-1, 9);
  expect(d.relative).toBeCloseTo(-0.0375, 9);
  expect(measureDifference({ computed: null, published: 1, tolerance: 1 }).overTolerance).toBeNull();
  const fromZero = measureDifference({ computed: 1, published: 0, tolerance: 2 });
  expect(fromZero).toEqual({ absolute: 1, relative: null, overTolerance: 0.5 });
  const exact = measureDifference({ computed: -2, published: -1, tolerance: 0 });
  expect(exact).toEqual({ absolute: -1, relative: -1, overTolerance: -Infinity });
});

test("one key at a time: from the smallest to the largest value, the longest bar first, the case itself is the line", () => {
  const factor = column("factor", [1.165, 1.088, 1.239, 1.05, null]);
  const changed = {
    ...study,
    mode: "one_at_a_time",
    vary: ["cohesion", "k_h", "law"].map((key) => ({ key, unit: "", values: [] })),
    columns: [
      column("cohesion", [250, 200, 300, 250, 250]),
      column("k_h", [0.1, 0.1, 0.1, 0.15, 0.05]),
      column("law", [null, null, null, null, null], ["a", "a", "a", "a", "b"]),
      factor,
    ],
    rows: ["base", "b", "c", "d", "e"].map((name) => ({ name, folder: name, status: "finished" as const, reason: "", warnings: [] })),
  };
  const { bars, base } = findBars(changed, factor);
  expect(base).toBe(1.165);
  expect(bars.map((b) => [b.key, b.low, b.high, b.low_factor, b.high_factor])).toEqual([
    ["cohesion", "200", "300", 1.088, 1.239],
    ["k_h", "0.1", "0.15", 1.165, 1.05],
  ]);
});

test("a chart has every target of its result and key, whichever of them is first", () => {
  const goal = (result: string, target: number) => ({ key: "force", result, target, value: 10, low: null, high: null });
  const found = { ...study, goals: [goal("bishop", 1.3), goal("spencer", 1.3), goal("spencer", 1.5)] };
  expect(findGoals(found, "spencer", "force").map((g) => g.target)).toEqual([1.3, 1.5]);
  expect(findGoals(found, "bishop", "force")).toHaveLength(1);
  expect(findGoals(found, "bishop", "length")).toHaveLength(0);
  expect(findGoals(study, "bishop", "force")).toHaveLength(0);
});
