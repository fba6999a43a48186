// SPDX-License-Identifier: MIT
/** Methods that the case selects: LEM, FEM, MPM. */
import { findMethods } from "../compared/methodTable";
import type { Method, Report } from "../contract";
import { findSetting } from "./methods/settings";

/** A report that names none is one of MPM. */
export function selectsMethod(report: Report, method: Method): boolean {
  const given = findSetting(report.result.input, "analysis.methods");
  const asked = findMethods(report)?.asked ?? (Array.isArray(given) ? given : []);
  return asked.length > 0 ? asked.includes(method) : method === "mpm";
}
