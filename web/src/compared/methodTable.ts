// SPDX-License-Identifier: MIT
/** The methods beside each other: the table of the results with its intervals as they are printed. */
import type { MethodComparison, MethodRow, Report } from "../contract";
import { roundDown, roundUp } from "../page/format";

/** Undefined for MPM alone. */
export const findMethods = (report: Report): MethodComparison | undefined =>
  report.methods_read && report.result.methods;

/** Intervals of limit analysis and FEM are rounded outward. */
export function listRows({ table }: MethodComparison): MethodRow[] {
  const isOutward = ({ method }: MethodRow) => method === "bounds" || method === "fem";
  return table.map((row) =>
    isOutward(row) ? { ...row, lower: roundDown(row.lower), upper: roundUp(row.upper) } : row,
  );
}
