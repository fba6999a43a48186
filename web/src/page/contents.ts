// SPDX-License-Identifier: MIT
/** Which parts this report has, in the order of the page. */
import { listComparisons } from "../charts/compare/differences";
import { findMethods } from "../compared/methodTable";
import type { Report } from "../contract";

export interface Entry {
  id: string;
  /** In the contents, short. */
  label: string;
}

export function listContents(report: Report): Entry[] {
  const isStudy = report.kind === "study";
  const has = (kind: string) => report.tables.some((table) => table.kind === kind);
  const surfaces = report.model.dimension === 2 && (findMethods(report)?.surfaces.length ?? 0) > 0;
  const hasSoil = report.model.dimension === 2 && report.model.polygons.length > 0;
  const entries: [boolean, string, string][] = [
    [true, "answer", "Answer"],
    // Of a study the section of its case, without surfaces.
    [report.sequences.length > 0 || surfaces || (isStudy && hasSoil), "section", report.model.dimension === 3 ? "View" : "Section"],
    [isStudy && report.study_result?.sampling !== undefined, "sampling", "Sampling"],
    [isStudy && (report.study?.rows.length ?? 0) > 0, "study", "Study"],
    [isStudy && (report.study?.rows.length ?? 0) > 0, "variants", "Variants"],
    [report.timeline !== undefined, "timeline", "Timeline"],
    [report.methods_read !== undefined, "compared", "Compared"],
    [report.result.lem !== undefined, "slices", "Slices"],
    [report.result.fem !== undefined, "elements", "Elements"],
    [report.result.bounds !== undefined, "bounds", "Bounds"],
    [report.result.curve !== undefined, "curve", "Curve"],
    [has("history") || has("monitors"), "histories", "Histories"],
    [
      !isStudy && (report.sequences.length > 0 || has("ground") || (report.sections ?? []).length > 0),
      "profiles",
      "Profiles",
    ],
    // Without material points the section itself shows it.
    [report.model.water_mesh !== undefined && report.sequences.length > 0, "pore-water", "Pore water"],
    [report.water !== undefined && report.model.materials.some((m) => m.water), "water", "Water"],
    [report.calibration !== undefined, "calibration", "Calibration"],
    [report.point_tests !== undefined, "tests", "Tests"],
    [listComparisons(report).length > 0, "comparison", "Comparison"],
    [true, "statement", "Report"],
    [report.methods.length > 0, "methods", "Methods"],
    [true, "input", "Input"],
    [true, "provenance", "Provenance"],
  ];
  return entries.filter(([present]) => present).map(([, id, label]) => ({ id, label }));
}
