// SPDX-License-Identifier: MIT
/** The monitors of the variants of a study: one chart for each monitor, or one for each variant. */
import type { CsvColumn } from "../base/csv";
import { findVaried } from "./studyData";
import type { Study, StudyRow } from "./shownStudy";

export interface MotionLine {
  name: string;
  /** On the clock [s], ascending. */
  time: number[];
  /** [m] */
  displacement: (number | null)[];
  /** [s], null for a point that did not move. */
  onset: number | null;
}

export interface MotionChart {
  title: string;
  lines: MotionLine[];
}

/** "base (content = 0 %)": the base case with the value that it has, where only one key is varied. */
export function nameRow(study: Study, row: number): string {
  const { name } = study.rows[row]!;
  const varied = findVaried(study);
  const value = varied[0]?.shown[row];
  if (name !== "base" || varied.length !== 1 || !value) return name;
  const unit = varied[0]!.unit && varied[0]!.unit !== "-" ? ` ${varied[0]!.unit}` : "";
  return `base (${varied[0]!.title} = ${value}${unit})`;
}

/** Rows that monitors were recorded for, with their place in the table. */
export function listMoving(study: Study): { row: StudyRow; index: number; title: string }[] {
  return study.rows.flatMap((row, index) => (row.paths ? [{ row, index, title: nameRow(study, index) }] : []));
}

function makeLine(row: StudyRow, monitor: string, name: string): MotionLine | null {
  const path = row.paths?.paths.find((p) => p.name === monitor);
  if (!row.paths || !path) return null;
  const onset = row.motion?.monitors.find((m) => m.name === monitor)?.onset ?? null;
  return { name, time: row.paths.time, displacement: path.displacement, onset };
}

export function makeMotionCharts(study: Study, by: "monitor" | "variant"): MotionChart[] {
  const rows = listMoving(study);
  const monitors = [...new Set(rows.flatMap(({ row }) => row.paths!.paths.map((p) => p.name)))];
  const keep = (lines: (MotionLine | null)[]) => lines.filter((l) => l !== null);
  if (by === "variant") {
    return rows.map(({ row, title }) => ({ title, lines: keep(monitors.map((m) => makeLine(row, m, m))) }));
  }
  return monitors.map((m) => ({ title: m, lines: keep(rows.map(({ row, title }) => makeLine(row, m, title))) }));
}

/** Value at a time by linear interpolation; null outside of the times, and beside a gap. */
export function interpolate(times: ArrayLike<number>, values: ArrayLike<number | null>, t: number): number | null {
  let i = 0;
  while (i < times.length && times[i]! < t) ++i;
  if (i === times.length) return null;
  const here = values[i] ?? null;
  if (times[i] === t || i === 0) return times[i] === t ? here : null;
  const before = values[i - 1] ?? null;
  if (here === null || before === null) return null;
  return before + ((here - before) * (t - times[i - 1]!)) / (times[i]! - times[i - 1]!);
}

/** One row for each variant and time, a column for each monitor, in `unit`. */
export function makeMotionColumns(study: Study, unit: { name: string; si: number }): CsvColumn[] {
  const rows = listMoving(study);
  const monitors = makeMotionCharts(study, "monitor").map((c) => c.title);
  const all = rows.flatMap(({ row, title }) => row.paths!.time.map((t, i) => ({ row, title, t, i })));
  return [
    { name: "variant", values: all.map((r) => r.title) },
    { name: "time", unit: "s", values: all.map((r) => r.t) },
    ...monitors.map((m) => ({
      name: `displacement of ${m}`,
      unit: unit.name,
      values: all.map(({ row, i }) => {
        const u = row.paths!.paths.find((p) => p.name === m)?.displacement[i] ?? null;
        return u === null ? null : u / unit.si;
      }),
    })),
  ];
}
