// SPDX-License-Identifier: MIT
/** The table of a study: order of its rows, and what of it can be drawn. */
import type { CsvColumn } from "../base/csv";
import type { Study } from "./shownStudy";

type StudyColumn = Study["columns"][number];

/** Row numbers ordered by a column; rows without a value come last in both directions. */
export function orderRows(column: StudyColumn | null, rows: number, descending: boolean): number[] {
  const order = Array.from({ length: rows }, (_, i) => i);
  if (!column) return descending ? order.reverse() : order;
  const numeric = column.values.some((v) => v !== null);
  const missing = (i: number) => (numeric ? (column.values[i] ?? null) === null : !column.shown[i]);
  const sign = descending ? -1 : 1;
  return order.sort((a, b) => {
    if (missing(a) || missing(b)) return Number(missing(a)) - Number(missing(b)) || a - b;
    const difference =
      numeric ?
        column.values[a]! - column.values[b]!
      : column.shown[a]!.localeCompare(column.shown[b]!, "en", { numeric: true });
    return sign * difference || a - b;
  });
}

/** The varied keys' columns, in the order of the study. */
export function findVaried(study: Study): StudyColumn[] {
  return study.vary.map((v) => study.columns.find((c) => c.name === v.key)).filter((c) => c !== undefined);
}

/** Columns of results that have at least one number. */
export function findNumeric(study: Study): StudyColumn[] {
  const varied = findVaried(study);
  return study.columns.filter((c) => !varied.includes(c) && c.values.some((v) => v !== null));
}

export function makeStudyColumns(study: Study): CsvColumn[] {
  const take = (c: StudyColumn): CsvColumn =>
    c.values.some((v) => v !== null) ?
      { name: c.title, unit: c.unit || "-", values: study.rows.map((_, i) => c.values[i] ?? null) }
    : { name: c.title, values: study.rows.map((_, i) => c.shown[i] ?? "") };
  return [
    { name: "variant", values: study.rows.map((r) => r.name) },
    ...study.columns.map(take),
    { name: "status", values: study.rows.map((r) => r.status) },
    { name: "reason", values: study.rows.map((r) => r.reason) },
  ];
}

/** Name of a row's group when the first key is on the axis: the values of the other varied keys. */
export function nameGroup(study: Study, row: number, onAxis: string): string {
  return findVaried(study)
    .filter((c) => c.name !== onAxis)
    .map((c) => `${c.title} ${c.shown[row] ?? ""}${c.unit && c.unit !== "-" ? ` ${c.unit}` : ""}`)
    .join(", ");
}

export interface StudyBar {
  key: string;
  title: string;
  /** The smallest and the largest of the values that have a result, as shown. */
  low: string;
  high: string;
  low_factor: number;
  high_factor: number;
}

/**
 * Of a study of one key at a time: the result at the smallest and at the largest value of each key, the longest bar
 * first, and that of the case itself, which is the first row. Keys whose values are no numbers are left out.
 */
export function findBars(study: Study, result: StudyColumn): { bars: StudyBar[]; base: number | null } {
  const base = result.values[0] ?? null;
  const bars = findVaried(study).flatMap((c): StudyBar[] => {
    const rows = study.rows.map((_, i) => i).filter((i) => c.values[i] !== null && result.values[i] !== null);
    const own = rows.filter((i) => i === 0 || c.values[i] !== c.values[0]);
    if (own.length < 2) return [];
    const order = own.sort((a, b) => c.values[a]! - c.values[b]!);
    const [low, high] = [order[0]!, order.at(-1)!];
    const show = (i: number) => `${c.shown[i]}${c.unit && c.unit !== "-" ? ` ${c.unit}` : ""}`;
    return [
      {
        key: c.name,
        title: c.title.replaceAll("_", " "),
        low: show(low),
        high: show(high),
        low_factor: result.values[low]!,
        high_factor: result.values[high]!,
      },
    ];
  });
  const length = (b: StudyBar) => Math.abs(b.high_factor - b.low_factor);
  return { bars: bars.sort((a, b) => length(b) - length(a)), base };
}
