// SPDX-License-Identifier: MIT
/** The history of a point as a table. */
import { makeFileName, writeCsv, type CsvColumn } from "../charts/base/csv";
import { report } from "../state";
import type { Shown } from "./shown";

/** Frames, coordinates and all fields of a point, in the report's units. `series`: field → value per frame [SI]. */
export function tabulatePoint(now: Shown, point: number, series: Map<string, ArrayLike<number>>): CsvColumn[] {
  const { sequence, positions } = now;
  const { model, units } = report.value;
  const { frames, point_count: count } = sequence;
  const round = (value: number) => Number(value.toPrecision(7));
  const columns: CsvColumn[] = [
    { name: "time", unit: "s", values: frames.map((f) => round(f.time - frames[0]!.time)) },
    { name: "strength reduction factor", values: frames.map((f) => f.factor) },
    { name: "frame", values: frames.map((f) => f.label) },
  ];
  for (let k = 0; k < model.dimension; ++k) {
    const at = (f: number) => positions[(f * count + point) * model.dimension + k]!;
    // A micrometre is finer than the page stores, and all digits of a map are kept.
    const values = frames.map((_, f) => Number((at(f) / units.length.si).toFixed(6)));
    columns.push({ name: "xyz"[k]!, unit: units.length.name, values });
  }
  for (const field of sequence.fields) {
    const values = Array.from(series.get(field.name) ?? [], (value) => round(value / field.unit.si));
    columns.push({ name: field.title, unit: field.unit.name, values });
  }
  return columns;
}

/** Name and content of the file. */
export function writePointCsv(now: Shown, point: number, series: Map<string, ArrayLike<number>>): [string, Blob] {
  const name = makeFileName(report.value.title, `${now.sequence.id} point ${now.ids[point]}`);
  return [name, new Blob([writeCsv(tabulatePoint(now, point, series))], { type: "text/csv" })];
}
