// SPDX-License-Identifier: MIT
/** Numbers of the charts of a calibration. */
import type { CalibratedCurve, Calibration } from "../../contract";
import type { CsvColumn } from "../base/rows";
import { type SeriesStyle, styleOf } from "../base/styles";

export interface CurveLine {
  curve: CalibratedCurve;
  style: SeriesStyle;
}

/** Curves of the same two quantities, in one diagram. */
export interface CurveGroup {
  id: string;
  lines: CurveLine[];
  /** Stresses over more than a power of ten are read on a logarithmic axis. */
  logX: boolean;
}

/** A test has one style in all diagrams. */
export function groupCurves(curves: readonly CalibratedCurve[]): CurveGroup[] {
  const tests = [...new Set(curves.map((curve) => curve.test))];
  const groups = new Map<string, CurveGroup>();
  for (const curve of curves) {
    const id = `${curve.y.name}_${curve.x.name}`;
    const group = groups.get(id) ?? { id, lines: [], logX: false };
    group.lines.push({ curve, style: styleOf(tests.indexOf(curve.test)) });
    groups.set(id, group);
  }
  for (const group of groups.values()) {
    const [low, high] = findRange(group.lines, 0);
    group.logX = !group.lines[0]!.curve.x.name.endsWith("_strain") && low > 0 && high >= 8 * low;
  }
  return [...groups.values()];
}

/** Smallest and largest abscissa (0) or ordinate (1) of points and fitted lines. */
export function findRange(lines: readonly CurveLine[], axis: 0 | 1): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (const { curve } of lines)
    for (const v of [...(axis === 0 ? curve.at : curve.measured), ...curve.line.map((row) => row[axis])]) {
      low = Math.min(low, v);
      high = Math.max(high, v);
    }
  if (high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high))) return [low, high];
  const room = Math.max(0.05 * Math.abs(high), 0.01);
  return [low - room, high + room];
}

/** "materials.loess.kappa" without its first word, which is the same for all. */
export function shortenKey(key: string): string {
  return key.replace(/^materials\./, "");
}

export function makeParameterCsv({ parameters, correlation }: Calibration): CsvColumn[] {
  return [
    { name: "parameter", values: parameters.map((p) => p.key) },
    { name: "unit", values: parameters.map((p) => p.unit || "-") },
    { name: "start", values: parameters.map((p) => p.start) },
    { name: "fitted", values: parameters.map((p) => p.value) },
    { name: "standard_error", values: parameters.map((p) => p.error) },
    { name: "min", values: parameters.map((p) => p.low) },
    { name: "max", values: parameters.map((p) => p.high) },
    ...parameters.map((p, j) => ({
      name: `correlation with ${p.key}`,
      values: correlation.map((row) => row[j] ?? null),
    })),
  ];
}

/** Every measured value below the other. */
export function makeCurveCsv(lines: readonly CurveLine[]): CsvColumn[] {
  const first = lines[0]?.curve;
  if (!first) return [];
  const all = (values: (curve: CalibratedCurve) => readonly (number | string)[]) =>
    lines.flatMap(({ curve }) => values(curve));
  return [
    { name: "test", values: all((c) => c.at.map(() => c.test)) },
    { name: first.x.name, unit: first.x.unit, values: all((c) => c.at) },
    { name: `measured ${first.y.name}`, unit: first.y.unit, values: all((c) => c.measured) },
    { name: `with start ${first.y.name}`, unit: first.y.unit, values: all((c) => c.before) },
    { name: `fitted ${first.y.name}`, unit: first.y.unit, values: all((c) => c.fitted) },
  ];
}
