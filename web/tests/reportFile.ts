// SPDX-License-Identifier: MIT
/** Reads a report.html and the results folder beside it, as the tests need them. */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";

import type { PackedArray, Report, ReportDocument } from "../src/contract";
import type { Source } from "../src/data";

export interface ReportFile {
  report: Report;
  /** What the report adds to the results. */
  document: ReportDocument;
  /** The texts of the packed arrays, by id. */
  arrays: Map<string, string>;
  /** Ids that occur more than once in the page. */
  doubled: string[];
  source: Source;
}

/** The scripts of a page that hold data. The browser finds them by id, so does this. */
export function readReportFile(path: string): ReportFile {
  const arrays = new Map<string, string>();
  const doubled: string[] = [];
  const documents = new Map<string, string>();
  for (const [, attributes, text] of readFileSync(path, "utf8").matchAll(/<script\b([^>]*)>([\s\S]*?)<\/script>/g)) {
    const id = /\bid="([^"]*)"/.exec(attributes!)?.[1];
    const type = /\btype="([^"]*)"/.exec(attributes!)?.[1];
    if (id === "talus-report" || id === "talus-results") {
      if (documents.has(id)) doubled.push(id);
      documents.set(id, text!);
    } else if (id !== undefined && type === "text/plain") {
      if (arrays.has(id)) doubled.push(id);
      arrays.set(id, text!);
    }
  }
  const read = (id: string) => {
    const text = documents.get(id);
    if (text === undefined) throw new Error(`${path} holds no report: a script with the id '${id}' was expected`);
    return JSON.parse(text) as Report;
  };
  const document = read("talus-report");
  const source: Source = (id) => {
    const text = arrays.get(id);
    if (text === undefined) throw new Error(`${path} holds no array '${id}'`);
    return text;
  };
  return { document, report: { ...document, ...read("talus-results") }, arrays, doubled, source };
}

/** All packed arrays that a document names, at any level. */
export function findPackedArrays(value: unknown): PackedArray[] {
  if (Array.isArray(value)) return value.flatMap(findPackedArrays);
  if (value === null || typeof value !== "object") return [];
  if ("id" in value && "planes" in value && "shape" in value) return [value as PackedArray];
  return Object.values(value).flatMap(findPackedArrays);
}

/** A CSV file of a results folder: columns by name, in SI where the unit in the header is known here. */
export function readColumns(path: string): Map<string, number[]> {
  const [header, ...rows] = readFileSync(path, "utf8").trim().split(/\r?\n/);
  const si: Record<string, number> = { mm: 1e-3, cm: 1e-2, m: 1, s: 1, kPa: 1e3, Pa: 1, J: 1, kg: 1, "-": 1 };
  const cells = rows.map((row) => row.split(","));
  return new Map(
    header!.split(",").map((title, column) => {
      const [, name, unit] = /^(.*?)(?: \[(.*)\])?$/.exec(title)!;
      const factor = si[unit ?? "-"] ?? Number.NaN;
      return [name!, cells.map((row) => (row[column] === "" ? Number.NaN : Number(row[column]) * factor))] as const;
    }),
  );
}

/** Reads a JSON file of a results folder. */
export function readJson(folder: string, name: string): any {
  return JSON.parse(readFileSync(join(folder, name), "utf8"));
}

/** The report and the results folder of the tests, or null: then the tests are skipped with a note. */
export function findGiven(): { page: string; results: string | null } | null {
  const page = process.env.TALUS_REPORT;
  const results = process.env.TALUS_RESULTS ?? null;
  if (!page) {
    process.stderr.write("\n*** NO REPORT GIVEN (TALUS_REPORT): the tests of a real report are SKIPPED ***\n");
    return null;
  }
  if (!existsSync(page)) throw new Error(`TALUS_REPORT names '${page}', which is not there`);
  if (!results)
    process.stderr.write("\n*** NO RESULTS GIVEN (TALUS_RESULTS): the comparison with summary.json is SKIPPED ***\n");
  else if (!existsSync(join(results, "summary.json")))
    throw new Error(`TALUS_RESULTS names '${results}', which holds no summary.json`);
  return { page, results };
}
