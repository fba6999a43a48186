// SPDX-License-Identifier: MIT
/** Which methods the case asks for: slices, finite elements, material points. */
import { findMethods } from "../compared/methodTable";
import type { Method, Report } from "../contract";
import { findSetting } from "./methods/settings";

/** A report that names none is one of material points. */
export function asksFor(report: Report, method: Method): boolean {
  const given = findSetting(report.result.input, "analysis.methods");
  const asked = findMethods(report)?.asked ?? (Array.isArray(given) ? given : []);
  return asked.length > 0 ? asked.includes(method) : method === "mpm";
}
