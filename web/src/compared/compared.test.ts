// SPDX-License-Identifier: MIT
/** Methods beside each other: marks of factors, surfaces. */
import { describe, expect, it } from "vitest";

import type { Factor, Report } from "../contract";
import { chooseMagnification } from "../elements/ElementsFigure";
import { moveNodes } from "../elements/fields";
import { selectsMethod } from "../page/methods/settings";
import { listSections } from "../page/sections";
import { findDensity, formatShare } from "../sampling/probability";
import { report } from "../state";
import { findProven, isRuledOut, makeFactorScale, type Marked, markFactor, placeFactor } from "./FactorMark";
import { listSurfaces } from "./methodTable";

const row = (method: string, factor: number | null, lower: number | null = null, upper: number | null = null) =>
  ({ method, factor, lower, upper }) as Marked;

describe("marks of factors", () => {
  it("stand before what limit analysis proves of the soil of their method", () => {
    const rows = [row("lem", 1.19, 1.18, 1.22), row("bounds", null, 1.1, 1.12), row("fem", 1.11, 1.09, 1.13)];
    const scale = makeFactorScale(rows)!;
    expect(rows.map((r) => findProven(scale, r))).toEqual([
      [1.18, 1.22],
      [1.1, 1.12],
      [1.1, 1.12],
    ]);
    expect(findProven(makeFactorScale(rows.slice(0, 1))!, rows[2]!)).toEqual([1.18, 1.22]);
    expect(makeFactorScale([row("fem", 1.2, 1.15, 1.21)])?.proven).toEqual({ lem: null, others: null });
    expect(makeFactorScale([row("lem", null)])).toBeNull();
  });

  it("are hollow where that rules them out", () => {
    const proven = row("bounds", null, 1.1, 1.12);
    const judge = (own: Marked, name: string) => isRuledOut(makeFactorScale([own, proven])!, { ...own, name });
    expect(judge(row("lem", 1.08), "spencer")).toBe(true);
    expect(judge(row("lem", 1.11), "spencer")).toBe(false);
    expect(judge(row("fem", 1.08, 1.05, 1.11), "associated")).toBe(false);
    expect(judge(row("fem", 1.18, 1.15, 1.21), "associated")).toBe(true);
    expect(judge(row("fem", 1.05, 1.04, 1.06), "given")).toBe(false);
  });

  it("are never hollow with supports", () => {
    const rows = [row("lem", 1.08), row("bounds", null, 1.1, 1.12)];
    expect(isRuledOut(makeFactorScale(rows, false)!, { ...rows[0]!, name: "spencer" })).toBe(false);
  });

  it("have a common scale for near values, and stay at its border otherwise", () => {
    const scale = makeFactorScale([row("lem", 1.1, 1.0, 1.2), row("lem", 23.4), row("fem", 1.3, 1.25, 1.31)])!;
    expect(scale.low).toBeLessThan(1);
    expect(scale.high).toBeGreaterThan(1.31);
    expect(scale.high).toBeLessThan(1.4);
    expect(placeFactor(scale, 23.4)).toEqual({ at: 96, inside: false });
    expect(placeFactor(scale, 1.1).inside).toBe(true);
    expect(placeFactor(scale, 1.1).at).toBeLessThan(placeFactor(scale, 1.3).at);
  });

  it("of a later time are not judged by what is proven for the first one", () => {
    const least = { method: "lem", by: "spencer", name: "timeline.least", value: 0.885, lower: null, upper: null };
    const first = { method: "lem", by: "spencer", name: "lem.spencer", value: 1.083, lower: 1.05, upper: 1.072 };
    const rows = [least, first].map((factor) => markFactor(factor as Factor));
    const scale = makeFactorScale(rows)!;
    expect(rows.map((r) => findProven(scale, r))).toEqual([null, [1.05, 1.072]]);
    expect(rows.map((r) => isRuledOut(scale, r))).toEqual([false, true]);
    expect(placeFactor(scale, 1).inside).toBe(true);
  });
});

const points = [
  [0, 0],
  [1, 1],
];
const surfaces = [
  { name: "lem.bishop", title: "Bishop, critical circle", method: "lem", factor: 1.44, points },
  { name: "lem.spencer", title: "Spencer, critical circle", method: "lem", factor: 1.439, points },
  { name: "lem.janbu", title: "Janbu", method: "lem", factor: null, points: [] },
  { name: "fem.band", title: "Band", method: "fem", factor: 1.42, points },
];
const table = ["bishop", "spencer", "janbu"].map((name) => ({ name, surface: `lem.${name}`, source: "critical" }));
const bare = {
  kind: "run",
  sequences: [],
  tables: [],
  methods: [],
  result: { input: {}, comparisons: [] },
  model: { dimension: 2, materials: [], polygons: [] },
} as unknown as Report;

describe("surfaces over each other", () => {
  it("begin with those that are shown at first: the governing surface of LEM, all of other methods", () => {
    report.value = {
      ...bare,
      methods_read: { governing: "lem.spencer" },
      result: { methods: { surfaces, table } },
    } as unknown as Report;
    const listed = listSurfaces();
    expect(listed.map((s) => [s.name, s.first, s.look])).toEqual([
      ["lem.spencer", true, 0],
      ["fem.band", true, 1],
      ["lem.bishop", false, 2],
    ]);
    expect(listed[0]!.text).toBe("Spencer, critical circle: F = 1.439");
  });
});

describe("a run without MPM", () => {
  const lem = { ...bare, methods_read: {}, result: { ...bare.result, methods: { asked: ["lem"], surfaces }, lem: {} } } as unknown as Report;

  it("has a section, and no part of points", () => {
    const ids = listSections(lem).map((entry) => entry.id);
    expect(ids).toEqual(["answer", "section", "compared", "slices", "statement", "input", "provenance"]);
    expect(selectsMethod(lem, "mpm")).toBe(false);
  });

  it("is known by its input when it failed before it had a table", () => {
    const input = { analysis: { methods: { value: ["lem", "fem"], given: true } } };
    const failed = { ...bare, result: { input } } as unknown as Report;
    expect([selectsMethod(failed, "mpm"), selectsMethod(failed, "fem"), selectsMethod(bare, "mpm")]).toEqual([false, true, true]);
  });
});

describe("deformed elements", () => {
  it("are magnified by a round number that keeps the section readable", () => {
    expect(chooseMagnification(0.01, 10)).toBe(50);
    expect(chooseMagnification(0.03, 10)).toBe(10);
    expect(chooseMagnification(5, 10)).toBe(1);
    expect(chooseMagnification(0, 10)).toBe(1);
  });

  it("move by their displacement times the magnification", () => {
    const mesh = { nodes: Float64Array.from([0, 0, 1, 2]), elements: new Uint32Array() };
    const moves = Float32Array.from([0, 0, 0.5, -0.25]);
    expect(Array.from(moveNodes(mesh, moves, 4))).toEqual([0, 0, 3, 1]);
    expect(moveNodes(mesh, moves, 0)).toBe(mesh.nodes);
  });
});

describe("probabilities", () => {
  it.each(["normal", "lognormal"] as const)("the density of the %s distribution has its mean and deviation", (kind) => {
    let [area, mean, square] = [0, 0, 0];
    const [m, s, step] = [1.3, 0.2, 1e-4];
    for (let x = step; x < 4; x += step) {
      const p = findDensity(kind, m, s, x) * step;
      [area, mean, square] = [area + p, mean + p * x, square + p * x * x];
    }
    expect(area).toBeCloseTo(1, 6);
    expect(mean).toBeCloseTo(m, 5);
    expect(Math.sqrt(square - mean * mean)).toBeCloseTo(s, 4);
  });

  it("are in per cent until they are too small for it", () => {
    expect([0.068, 0.5, 0, 3.2e-7, null].map(formatShare)).toEqual(["6.8 %", "50 %", "0", "3.2×10⁻⁷", "–"]);
  });
});
