// SPDX-License-Identifier: MIT
/** Tables of numbers as comma-separated values (RFC 4180). */
import type { RunResults } from "../engine/http";
import type { Point } from "../geometry/plane";

/** A text that a spreadsheet would take for a formula begins with a quote. */
function quote(text: string): string {
  const safe = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

const join = (rows: (string | number | null)[][]) =>
  `${rows.map((row) => row.map((cell) => (typeof cell === "number" ? String(cell) : quote(cell ?? ""))).join(",")).join("\r\n")}\r\n`;

/** The named results of a run. */
export function writeCsv({ values }: Pick<RunResults, "values">): string {
  return join([["name", "title", "value", "unit"], ...values.map(({ name, title, value, unit }) => [name, title, value, unit])]);
}

/** Points of the section [m]. */
export function writePoints(lines: { kind: string; name: string; points: readonly Point[] }[]): string {
  return join([["kind", "name", "x", "y"], ...lines.flatMap(({ kind, name, points }) => points.map(([x, y]) => [kind, name, x, y]))]);
}
