// SPDX-License-Identifier: MIT
// Monitors and sections of the variants of a study: what belongs onto one chart, and what a crosshair reads there.
import { expect, test } from "vitest";

import {
  interpolate, joinScales, listPictures, makeMotionCharts, makeMotionColumns, nameRow, type Study,
} from "../../src/charts/study/studyData";
import {
  chooseField, findAxis, listSectionsOf, makeSectionCharts, nameTime,
} from "../../src/charts/sections/SectionCharts";
import type { Section, SequenceField } from "../../src/contract";

const paths = (scale: number) => ({
  time: [0, 1, 3],
  paths: [
    { name: "toe", displacement: [0, scale, 3 * scale] },
    { name: "crest", displacement: [0, null, scale] },
  ],
});
const motion = (toe: number | null) => ({
  stage: "rain",
  start: 5,
  threshold: 0.1,
  monitors: [
    { name: "toe", onset: toe, displacement: 1 },
    { name: "crest", onset: null, displacement: 1 },
  ],
  order: ["toe"],
  pattern: "single" as const,
  sentence: "",
});
const section = (to: number[], values: (number | null)[][] = []): Section => ({
  name: "A",
  from: [6, 1],
  to,
  width: 0.2,
  fields: ["stress_xx", "deviatoric_strain"].map((name) => ({ name, title: name, unit: { name: "-", si: 1 } })),
  profiles: [0, 40].map((time) => ({ time, distance: [1, 2], values })),
});
const row = (name: string) => ({ name, folder: name, status: "finished" as const, reason: "", warnings: [] });
const study: Study = {
  vary: [{ key: "roots.content", unit: "%", values: ["0", "0.5"] }],
  mode: "one_at_a_time",
  reference: "base",
  columns: [{ name: "roots.content", title: "content", unit: "%", shown: ["0", "0.5", "1"], values: [0, 0.5, 1] }],
  rows: [
    { ...row("base"), paths: paths(1), motion: motion(0.5), sections: [section([6, 5], [[1, 2], [3, null]])] },
    { ...row("content = 0.5"), paths: paths(0.5), motion: motion(null) },
    row("content = 1"),
  ],
};

test("a chart by monitor holds every variant, a chart by variant every monitor", () => {
  const byMonitor = makeMotionCharts(study, "monitor");
  expect(byMonitor.map((c) => c.title)).toEqual(["toe", "crest"]);
  expect(byMonitor[0]!.lines.map((l) => [l.name, l.onset])).toEqual([
    ["base (content = 0 %)", 0.5],
    ["content = 0.5", null],
  ]);
  const byVariant = makeMotionCharts(study, "variant");
  expect(byVariant.map((c) => c.title)).toEqual(["base (content = 0 %)", "content = 0.5"]);
  expect(byVariant[1]!.lines[0]!.displacement).toEqual([0, 0.5, 1.5]);
});

test("the base case is named by its value only where one key is varied", () => {
  expect(nameRow(study, 2)).toBe("content = 1");
  expect(nameRow({ ...study, vary: [...study.vary, { key: "mesh.size", unit: "", values: [] }], columns: [
    ...study.columns, { ...study.columns[0]!, name: "mesh.size" }] }, 0)).toBe("base");
});

test("between rows a reading is interpolated, and there is none beyond them or beside a gap", () => {
  expect(interpolate([0, 1, 3], [0, 1, 3], 2)).toBe(2);
  expect(interpolate([0, 1, 3], [0, 1, 3], 3)).toBe(3);
  expect(interpolate([0, 1, 3], [0, 1, 3], 3.1)).toBeNull();
  expect(interpolate([0, 1, 3], [0, null, 3], 2)).toBeNull();
  expect(interpolate([1, 3], [1, 3], 0)).toBeNull();
});

test("the CSV of displacements is in the unit of its header", () => {
  const columns = makeMotionColumns(study, { name: "mm", si: 1e-3 });
  expect(columns.map((c) => c.name)).toEqual(["variant", "time", "displacement of toe", "displacement of crest"]);
  expect(columns[2]!.values.slice(0, 3)).toEqual([0, 1000, 3000]);
  expect(columns[3]!.values[1]).toBeNull();
});

test("a steep section has heights, a flat one distances", () => {
  const runs = listSectionsOf(study, "A");
  expect(runs.map((r) => r.title)).toEqual(["base (content = 0 %)"]);
  expect(findAxis(runs[0]!.section).steep).toBe(true);
  expect(makeSectionCharts(runs, "deviatoric_strain", "run")[0]!.lines[0]!).toEqual({
    name: "0 s",
    place: [2, 3],
    values: [3, null],
  });
  const flat = section([16, 2], [[1, 2], [3, 4]]);
  expect(findAxis(flat).steep).toBe(false);
  const flats = ["a", "b"].map((title) => ({ title, section: flat }));
  const [first, second] = makeSectionCharts(flats, "stress_xx", "time");
  expect([first!.title, second!.title]).toEqual(["0 s", "40 s"]);
  expect(first!.lines.map((l) => [l.name, l.place])).toEqual([["a", [1, 2]], ["b", [1, 2]]]);
  expect([nameTime(0.5009, 2), nameTime(40.02, 560), nameTime(0, 0)]).toEqual(["0.5 s", "40 s", "0 s"]);
  expect(chooseField(flat)).toBe("deviatoric_strain");
});

test("pictures share the widest scale, about zero where a sign matters", () => {
  const field = (scale: [number, number], diverging = false) => ({ scale, diverging }) as SequenceField;
  expect(joinScales([field([0, 1]), field([0, 3])])).toEqual([0, 3]);
  expect(joinScales([field([-1, 1], true), field([-4, 3])])).toEqual([-4, 4]);
  expect(listPictures(study, [])).toEqual([]);
});
