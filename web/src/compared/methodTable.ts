// SPDX-License-Identifier: MIT
/** The methods beside each other: the table of the results with its intervals as they are printed, and the slip surfaces drawn together. */
import type { Method, MethodComparison, MethodRow, MethodSurface, Report } from "../contract";
import { roundDown, roundUp } from "../page/format";
import { report } from "../state";

/** Undefined for MPM alone. */
export const findMethods = (given: Report): MethodComparison | undefined =>
  given.methods_read && given.result.methods;

/** Intervals of limit analysis and FEM are rounded outward. */
export function listRows({ table }: MethodComparison): MethodRow[] {
  const isOutward = ({ method }: MethodRow) => method === "bounds" || method === "fem";
  return table.map((row) =>
    isOutward(row) ? { ...row, lower: roundDown(row.lower), upper: roundUp(row.upper) } : row,
  );
}

export interface NamedSurface {
  name: string;
  /** "Spencer, critical circle: F = 1.442". */
  text: string;
  /** null where the line has none, as a band of strain. */
  factor: number | null;
  method: Method;
  points: number[][];
  /** Number of its colour and dashes. */
  look: number;
  /** True for surfaces shown at first: of LEM the governing one and the circle of its method. */
  first: boolean;
}

export function listSurfaces(): NamedSurface[] {
  const { surfaces = [], table: rows = [] } = findMethods(report.value) ?? {};
  const governing = report.value.methods_read?.governing;
  const all = surfaces.filter((s) => s.points.length > 1);
  const slices = all.filter((s) => s.method === "lem");
  const leading = slices.find((s) => s.name === governing) ?? slices[0];
  const method = rows.find((row) => row.surface === leading?.name)?.name;
  const isCircle = (s: MethodSurface) =>
    rows.some((row) => row.surface === s.name && row.name === method && row.source === "critical");
  const named = all.map((s) => ({
    name: s.name,
    text: s.factor === null ? s.title : `${s.title}: F = ${s.factor.toFixed(3)}`,
    factor: s.factor,
    method: s.method,
    points: s.points,
    first: s.method !== "lem" || s === leading || isCircle(s),
  }));
  // Surfaces shown at first have the first colours.
  return [...named.filter((s) => s.first), ...named.filter((s) => !s.first)].map((s, look) => ({ ...s, look }));
}
