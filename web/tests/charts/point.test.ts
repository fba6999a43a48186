// SPDX-License-Identifier: MIT
/** Numbers of the charts of element tests. */
import { describe, expect, it } from "vitest";

import {
  findSpan, listTicks, makeLines, makePointCsv, makeStops, readLines,
} from "../../src/charts/laboratory/diagram";
import type { PointTests } from "../../src/contract";

const test = (name: string) => ({
  name,
  material: "clay",
  kind: "isotropic compression",
  path: "",
  set: "",
  file: "",
  steps: 1,
  turns: [],
  stopped: "",
  peak_q: 0,
  peak_q_strain: 0,
  end: { q: 0, p: 0, volumetric_strain: 0, void_ratio: 0, preconsolidation: 0 },
});
const makeColumns = (x: number[], y: number[]) => [
  { name: "p", title: "p", unit: "kPa", values: x },
  { name: "void_ratio", title: "e", unit: "-", values: y },
];

const tests = {
  tests: [test("a"), test("b")],
  groups: [
    {
      id: "compression",
      title: "Compression tests",
      picture: "compression.svg",
      panels: [{ x: "p", y: "void_ratio", log_x: true }],
      tests: [0, 1],
      colour: [0, 1],
      dash: [0, 2],
    },
  ],
} as unknown as PointTests;
const curves = [makeColumns([100, 400, 200, 800], [0.9, 0.8, 0.82, 0.7]), makeColumns([50, 60], [0.95, 0.94])];
const lines = makeLines(tests, curves, tests.groups[0]!);

describe("element tests", () => {
  it("spans all lines, and a constant still has an axis", () => {
    expect(findSpan(lines, "p", true)).toEqual([50, 800]);
    expect(findSpan(lines, "p")).toEqual([0, 800]);
    const flat = makeLines(tests, [makeColumns([1, 2], [0, 0])], { ...tests.groups[0]!, tests: [0] });
    const [low, high] = findSpan(flat, "void_ratio");
    expect(low).toBeLessThan(0);
    expect(high).toBeGreaterThan(0);
  });

  it("reads the first passage of an abscissa, and nothing beyond a line's end", () => {
    const [first, ...others] = readLines(lines, "p", "void_ratio", 250);
    expect(first!.value).toBeCloseTo(0.85);
    expect(others).toEqual([]);
    expect(readLines(lines, "p", "void_ratio", 55).map((r) => r.line.test.name)).toEqual(["b"]);
    expect(readLines(lines, "p", "void_ratio", 900)).toEqual([]);
  });

  it("stops evenly on both kinds of axis", () => {
    expect(makeStops(1, 100, true, 2).map((v) => Math.round(v))).toEqual([1, 10, 100]);
    expect(makeStops(0, 10, false, 2)).toEqual([0, 5, 10]);
  });

  it("has ticks on an axis shorter than a power of ten", () => {
    expect(listTicks(300, 350).length).toBeGreaterThan(2);
    expect(listTicks(50, 800)).toContain(100);
  });

  it("writes all curves below each other", () => {
    const columns = makePointCsv(lines);
    expect(columns[0]!.values).toEqual(["a", "a", "a", "a", "b", "b"]);
    expect(columns[2]!.values).toEqual([0.9, 0.8, 0.82, 0.7, 0.95, 0.94]);
  });

  it("dashes denote the apparatus, colours the soil", () => {
    expect(lines[0]!.style.dash).not.toBe(lines[1]!.style.dash);
    expect(lines[0]!.style.colour).not.toBe(lines[1]!.style.colour);
  });
});
