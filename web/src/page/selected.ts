// SPDX-License-Identifier: MIT
/** Methods that the case selects: LEM, FEM, MPM. */
import type { MethodName, Report } from "../contract";
import { findSetting } from "./methods/settings";

/** A report that names none is one of material points. */
export function selectsMethod(report: Report, method: MethodName): boolean {
  const given = findSetting(report.input, "analysis.methods");
  const asked = report.method_table?.asked ?? (Array.isArray(given) ? given : []);
  return asked.length > 0 ? asked.includes(method) : method === "mpm";
}
