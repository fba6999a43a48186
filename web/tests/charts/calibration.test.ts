// SPDX-License-Identifier: MIT
/** Numbers of the charts of a calibration. */
import { describe, expect, it } from "vitest";

import { findRange, groupCurves, makeCurveCsv, makeParameterCsv, shortenKey } from "../../src/charts/laboratory/calibrationData";
import type { CalibratedCurve, Calibration } from "../../src/contract";

const quantity = (name: string, unit: string) =>
  ({ name, title: name, unit, kind: unit === "%" ? "strain" : unit === "kPa" ? "stress" : "other" }) as const;
const curve = (test: string, x: string, y: string, at: number[], measured: number[]): CalibratedCurve => ({
  test,
  x: quantity(x, x.endsWith("strain") ? "%" : "kPa"),
  y: quantity(y, y === "q" ? "kPa" : "-"),
  at,
  measured,
  before: measured.map((v) => v / 2),
  fitted: measured.map((v) => v + 1),
  line: at.map((v, i): [number, number] => [v, measured[i]! + 1]),
  line_before: [],
  deviation: 1,
  weight: 1,
  rms: 1,
  rms_before: 1,
  mean: 1,
  largest: 1,
  largest_at: at[0]!,
  missing: 0,
});

const curves = [
  curve("a", "axial_strain", "q", [1, 10], [50, 100]),
  curve("b", "axial_strain", "q", [1, 20], [60, 150]),
  curve("b", "p", "void_ratio", [50, 800, 100], [0.9, 0.7, 0.75]),
];

describe("curves of a calibration", () => {
  it("are grouped by what they show, and a test keeps its style", () => {
    const groups = groupCurves(curves);
    expect(groups.map((g) => [g.id, g.lines.length, g.logX])).toEqual([
      ["q_axial_strain", 2, false],
      ["void_ratio_p", 1, true],
    ]);
    expect(groups[1]!.lines[0]!.style).toEqual(groups[0]!.lines[1]!.style);
    expect(groups[0]!.lines[0]!.style).not.toEqual(groups[0]!.lines[1]!.style);
  });

  it("have axes that hold points and fitted lines", () => {
    const [first] = groupCurves(curves);
    expect(findRange(first!.lines, 0)).toEqual([1, 20]);
    expect(findRange(first!.lines, 1)).toEqual([50, 151]);
    const flat = groupCurves([curve("a", "axial_strain", "q", [5], [0])]);
    expect(findRange(flat[0]!.lines, 0)[0]).toBeLessThan(5);
  });

  it("are saved with every measured value", () => {
    const columns = makeCurveCsv(groupCurves(curves)[0]!.lines);
    expect(columns.map((c) => c.name)).toEqual(["test", "axial_strain", "measured q", "with start q", "fitted q"]);
    expect(columns[0]!.values).toEqual(["a", "a", "b", "b"]);
    expect(columns[4]!.values).toEqual([51, 101, 61, 151]);
  });

  it("leave a row for every parameter with its correlations", () => {
    const parameter = (key: string) => ({ key, unit: "", start: 1, value: 2, low: 0, high: 3, error: 0.1, limit: "no" });
    const calibration = {
      parameters: [parameter("materials.clay.kappa"), parameter("materials.clay.lambda")],
      correlation: [[1, 0.5], [0.5, null]],
    } as unknown as Calibration;
    const columns = makeParameterCsv(calibration);
    expect(columns.at(-1)).toEqual({ name: "correlation with materials.clay.lambda", values: [0.5, null] });
    expect(shortenKey("materials.clay.kappa")).toBe("clay.kappa");
  });
});
