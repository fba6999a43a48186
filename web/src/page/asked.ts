/** Which methods the case asks for: slices, finite elements, material points. */
import type { InputTable, InputValue, Report } from "../contract";

/** A report that names none is one of material points. */
export function asksFor(report: Report, method: "lem" | "fem" | "mpm"): boolean {
  const analysis = report.input.analysis as InputTable | undefined;
  const given = (analysis?.methods as InputValue | undefined)?.value;
  const asked = report.method_table?.asked ?? (Array.isArray(given) ? given : []);
  return asked.length > 0 ? asked.includes(method) : method === "mpm";
}
