// SPDX-License-Identifier: MIT
/** LEM and FEM of a real report (TALUS_REPORT) against its results folder (TALUS_RESULTS). */
import { describe, expect, it } from "vitest";

import { findMethods } from "../src/compared/methodTable";
import { readIntegers, readPlaces, readValues } from "../src/data";
import { flowRuns } from "../src/elements/fields";
import { hasSlices, slicedSurfaces } from "../src/slices/sliceData";
import * as state from "../src/state";
import { findGiven, readJson, readReportFile } from "./reportFile";

const given = findGiven();
const folder = given?.results ?? "";
const summary = folder ? readJson(folder, "summary.json") : null;
const { report, source } = given ? readReportFile(given.page) : ({} as never);
state.report.value = report;

describe.skipIf(!summary?.methods)("the methods of a report", () => {
  it("names one factor of each method, all of them of the results' table", () => {
    const methods = findMethods(report);
    if (!methods) return expect(summary.methods.asked).toEqual(["mpm"]);
    for (const method of ["lem", "fem"]) {
      const factors = report.answer.factors.filter((f) => f.method === method);
      const found = factors.filter((f) => f.value !== null);
      expect(factors.filter((f) => f.main).length, method).toBe(found.length > 0 ? 1 : 0);
      for (const main of factors.filter((f) => f.main))
        expect(report.answer.sentences.join(" ")).toContain(main.value!.toFixed(3));
    }
    for (const f of report.answer.factors.filter((factor) => factor.method !== "mpm")) {
      const alike = methods.table.filter((r) => r.method === f.method && r.source === f.source && r.factor === f.value);
      expect(alike.map((row) => row.name), f.name).toContain(f.by);
    }
    const names = report.answer.factors.map((f) => `${f.name} ${f.title}`);
    expect(new Set(names).size).toBe(names.length);
  });

  it("draws surfaces that lie in the model", () => {
    const [low, high] = report.model.bounds;
    for (const { name, points } of findMethods(report)?.surfaces ?? [])
      for (const point of points)
        for (const k of [0, 1]) {
          expect(point[k]!, name).toBeGreaterThanOrEqual(low[k]! - 1e-6);
          expect(point[k]!, name).toBeLessThanOrEqual(high[k]! + 1e-6);
        }
  });

  it("has slices that fill the sliding mass", () => {
    for (const surface of slicedSurfaces.value.filter(hasSlices)) {
      const s = surface.slices;
      const area = s.left.reduce((sum, x, i) => {
        const [left, right] = [s.top_left[i]! - s.base_left[i]![1]!, s.top_right[i]! - s.base_right[i]![1]!];
        return sum + 0.5 * (s.right[i]! - x) * (left + right);
      }, 0);
      // The base of a slice is straight: a circle's mass is a little larger.
      expect(area / surface.area, `${surface.method} ${surface.kind}`).toBeCloseTo(1, 2);
    }
  });

  it("has every trial, and none that is weaker than the critical circle of its method", async () => {
    const trials = report.slices?.trials;
    if (!trials) return;
    const file = readJson(folder, summary.lem.trials_file);
    const factors = await readValues(trials.factors, source);
    const circles = await readPlaces(trials.circles, source);
    expect(trials.count).toBe(file.trials.length);
    for (const i of [0, trials.count >> 1, trials.count - 1]) {
      const row = file.trials[i];
      // Places are floats about the middle of all: off by half of their last bit, far below the file's 1e-4 m.
      circles.slice(5 * i, 5 * i + 5).forEach((x, k) => expect(x).toBeCloseTo(row[k]!, 4));
      const own = factors.slice(i * trials.methods.length, (i + 1) * trials.methods.length);
      expect(Array.from(own)).toEqual(row.slice(5).map(Math.fround));
    }
    trials.methods.forEach((method, m) => {
      const critical = slicedSurfaces.value.find((s) => s.kind === "circle" && s.method === method);
      if (!critical?.factor) return;
      const least = factors.reduce((a, f, i) => (i % trials.methods.length === m && f > 0 && f < a ? f : a), Infinity);
      expect(least, method).toBeGreaterThanOrEqual(critical.factor - 1e-3);
    });
  });

  it("has the fields of FEM at every node", async () => {
    const elements = report.finite_elements;
    if (!elements) return;
    const file = readJson(folder, summary.fem.fields_file);
    const cells = await readIntegers(elements.mesh.elements, source);
    expect(cells.length).toBe(6 * file.elements.length);
    expect(Array.from(cells.slice(-6))).toEqual(file.elements.at(-1));
    for (const run of flowRuns.value) {
      const stored = file.runs.find((r: any) => r.flow === run.flow);
      const strain = await readValues(run.fields!.shear_strain, source);
      const { range } = run.fields!.shear_strain;
      const step = (range![1] - range![0]) / 65534;
      stored.shear_strain.forEach((value: number, i: number) =>
        expect(Math.abs(strain[i]! - value)).toBeLessThanOrEqual(step + 1e-9),
      );
      expect(run.trials.every((t, i) => i === 0 || t.factor >= run.trials[i - 1]!.factor)).toBe(true);
      // With one mesh the factor is the middle of the last bracket; extrapolated from two it lies inside the interval.
      if (!run.interval) expect(run.factor).toBeCloseTo((run.stable + run.failed) / 2, 9);
      else expect(run.interval.lower <= run.factor && run.factor <= run.interval.upper).toBe(true);
    }
  });
});
