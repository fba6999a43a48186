// SPDX-License-Identifier: MIT
/** A study as its charts need it: study.json with the table and the results of the variants that the report adds. */
import { computed } from "@preact/signals";

import type {
  ExtrapolatedFactor, Sequence, SequenceField, StudyGoal, StudyResult, StudyShown, StudyVariant, VariantShown,
} from "../../contract";
import { report } from "../../state";
import type { CsvColumn } from "../base/rows";

export type StudyRow = StudyVariant & VariantShown;

export interface Study extends Pick<StudyResult, "vary" | "mode" | "reference" | "extrapolation"> {
  columns: StudyShown["columns"];
  rows: StudyRow[];
  goals?: StudyGoal[];
}

/** Factors of methods without a mesh do not vary with the size. */
const varies = ({ factors }: ExtrapolatedFactor) => factors.some((factor) => factor !== factors[0]);

/** Undefined for any other report. */
export const shownStudy = computed<Study | undefined>(() => {
  const { study_result: result, study: shown } = report.value;
  if (!result || !shown) return undefined;
  const { extrapolation, variants } = result;
  return {
    ...result,
    columns: shown.columns,
    goals: shown.goals,
    rows: variants.map((variant, i) => ({ ...variant, ...shown.rows[i]! })),
    extrapolation: extrapolation && {
      ...extrapolation,
      // The symbol of the page.
      factors: extrapolation.factors
        .filter(varies)
        .map((factor) => ({ ...factor, criterion: factor.criterion.replace(/^FoS/, "F") })),
    },
  };
});

type StudyColumn = Study["columns"][number];

/** What a column is ordered by: its numbers, or else its words. */
export const takeOrdered = (column: StudyColumn) =>
  column.values.some((v) => v !== null) ? column.values : column.shown.map((text) => text || null);

/** The varied keys' columns, in the order of the study. */
export function findVaried(study: Study): StudyColumn[] {
  return study.vary.map((v) => study.columns.find((c) => c.name === v.key)).filter((c) => c !== undefined);
}

/** The targets on the axes of a chart: those of its result and its key. */
export const findGoals = (study: Study, result: string, key: string | undefined): StudyGoal[] =>
  (study.goals ?? []).filter((goal) => goal.result === result && goal.key === key);

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

interface StudyBar {
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

interface MotionLine {
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
function listMoving(study: Study): { row: StudyRow; index: number; title: string }[] {
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

export interface PictureRow {
  row: StudyRow;
  sequence: Sequence;
  /** [frame] time on the clock [s]. */
  clock: number[];
  /** Frames shown side by side. */
  pictures: number[];
}

/** Rows with frames in the report. */
export function listPictures(study: Study, sequences: Sequence[]): PictureRow[] {
  return study.rows.flatMap((row) => {
    const sequence = sequences.find((s) => s.id === row.frames?.sequence);
    if (!row.frames || !sequence) return [];
    // A large run may show fewer frames than were chosen.
    const pictures = row.frames.pictures.filter((i) => i < sequence.frames.length);
    return [{ row, sequence, clock: row.frames.clock, pictures }];
  });
}

/** The widest of the scales, about zero when one of them is. */
export function joinScales(fields: SequenceField[]): [number, number] {
  const low = Math.min(...fields.map((f) => f.scale[0]));
  const high = Math.max(...fields.map((f) => f.scale[1]));
  if (!fields.some((f) => f.diverging)) return [low, high];
  const end = Math.max(-low, high);
  return [-end, end];
}
