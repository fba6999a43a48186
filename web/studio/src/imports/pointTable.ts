// SPDX-License-Identifier: MIT
/** Tables of points of a survey: rows of x and elevation, with or without headings, as exported by spreadsheets. */
import type { Point } from "../geometry/plane";

export type PointTable = { points: Point[]; note: string; fault: null } | { points: null; note: ""; fault: string };

const lengths: Record<string, number> = { m: 1, metre: 1, metres: 1, cm: 0.01, mm: 0.001, km: 1000, ft: 0.3048, feet: 0.3048, in: 0.0254, yd: 0.9144 };
/** Names of a column, the surest first. */
const along = [/^(distance|dist|chainage|station|ch)$/, /^x$/, /^(offset|position)$/];
const upward = [/^(z|elevation|elev|level|height|rl)$/, /^y$/];
const plans = [[/^(easting|east)$/, /^(northing|north)$/], [/^x$/, /^y$/]] as const;
/** Largest difference between a chainage and the length of its coordinates, as the program has it. */
const largestDifference = 0.01;

const refuse = (fault: string): PointTable => ({ points: null, note: "", fault });

/** Splits a row at semicolons or tabs, where commas may be decimal, else at commas, else at blanks. */
function splitRow(row: string): string[] {
  const separator = [";", "\t", ","].find((mark) => row.includes(mark)) ?? /\s+/;
  const cells = row.split(separator).map((cell) => cell.trim().replace(/^"(.*)"$/, "$1"));
  return separator === ";" || separator === "\t" ? cells.map((cell) => (/^[+-]?\d+,\d+$/.test(cell) ? cell.replace(",", ".") : cell)) : cells;
}

const isNumber = (cell: string | undefined) => cell !== undefined && cell !== "" && Number.isFinite(Number(cell));

/** The name of a heading such as "Elevation [ft]" and the length of its unit [m]; null for a unit that is no length. */
function readHeading(cell: string): { name: string; unit: number | null; shown: string } {
  const parts = /^(.*?)\s*(?:[[(]\s*([^\])]+?)\s*[\])])?$/.exec(cell.toLowerCase())!;
  const shown = parts[2] ?? "";
  return { name: parts[1]!.trim(), unit: shown === "" ? 1 : (lengths[shown] ?? null), shown };
}

const measure = (places: readonly Point[]) => places.reduce((sum, p, i) => (i === 0 ? 0 : sum + Math.hypot(p[0] - places[i - 1]![0], p[1] - places[i - 1]![1])), 0);

/** The reason to refuse a chainage whose length is not that of its coordinates; empty where both agree. */
function compareChainage(rows: readonly { chainage: number; at: Point }[]): string {
  const sorted = rows.filter(({ chainage, at }) => Number.isFinite(chainage + at[0] + at[1])).toSorted((a, b) => a.chainage - b.chainage);
  if (sorted.length < 2) return "";
  const [length, plan] = [sorted.at(-1)!.chainage - sorted[0]!.chainage, measure(sorted.map(({ at }) => at))];
  if (Math.abs(length - plan) <= largestDifference * Math.max(length, plan)) return "";
  return `it is ${Number(length.toPrecision(6))} m long by its chainage and ${Number(plan.toPrecision(6))} m by its positions in plan`;
}

/**
 * Reads points. Columns are taken by the names of their headings, or the table has exactly two. Tables of boreholes and
 * positions in plan are refused: the program reads them. Positions in plan beside a chainage must confirm it.
 */
export function readPointTable(text: string): PointTable {
  const rows = text.replace(/^\ufeff/, "").split(/\r?\n/).map((row) => row.trim()).filter((row) => row !== "" && !row.startsWith("#"));
  const cells = rows.map(splitRow);
  const first = cells.findIndex((row) => row.length > 1 && row.every((cell) => cell === "" || isNumber(cell)));
  if (first < 0) return refuse("it has no rows of numbers alone");
  const headings = first > 0 ? cells[first - 1]!.map(readHeading) : [];
  const find = (names: readonly RegExp[]) => names.map((name) => headings.findIndex((heading) => name.test(heading.name))).find((i) => i >= 0) ?? -1;
  let [x, y] = [find(along), find(upward)];
  const plan = plans.map((names) => names.map((name) => find([name]))).find(([east, north]) => east! >= 0 && north! >= 0 && north !== y);
  if (plan && (x < 0 || x === plan[0])) return refuse("it has positions in plan");
  // With x and y alone, y is the elevation, and x has to be the chainage.
  const own = plan ?? (headings[y]?.name === "y" ? [find([/^x$/]), -1] : [-1, -1]);
  if (x >= 0 && own[0]! >= 0 && own[0] !== x) {
    const value = (row: readonly string[], i: number) => (i < 0 ? 0 : isNumber(row[i]) ? Number(row[i]) * (headings[i]!.unit ?? Number.NaN) : Number.NaN);
    const fault = compareChainage(cells.slice(first).map((row) => ({ chainage: value(row, x), at: [value(row, own[0]!), value(row, own[1]!)] })));
    if (fault) return refuse(fault);
  }
  if (x < 0 || y < 0) {
    if (cells[first]!.length !== 2) return refuse(`it has ${cells[first]!.length} columns, and no headings such as x and y`);
    [x, y] = [0, 1];
  }
  const units = [headings[x]?.unit ?? 1, headings[y]?.unit ?? 1];
  const wrong = [headings[x], headings[y]].find((heading) => heading?.unit === null);
  if (wrong) return refuse(`“${wrong.shown}” is no unit of length that the page knows`);
  const points: Point[] = [];
  for (const [i, row] of cells.slice(first).entries()) {
    if (!isNumber(row[x]) || !isNumber(row[y])) return refuse(`its row ${first + i + 1}, “${rows[first + i]}”, has no two numbers`);
    points.push([Number(row[x]) * units[0]!, Number(row[y]) * units[1]!]);
  }
  if (points.length < 2) return refuse("it has a single point");
  const stated = headings[x]?.shown || headings[y]?.shown;
  return { points, note: stated ? `in ${stated}` : "taken as metres", fault: null };
}
