// SPDX-License-Identifier: MIT
/** Sections of a case as lines of a chart: which field, which times, along which axis. */
import type { Section } from "../../contract";
import type { CsvColumn } from "../base/csv";
import { nameRow } from "../study/motionData";
import type { Study } from "../study/shownStudy";

/** A section of one run. */
export interface SectionOfRun {
  title: string;
  section: Section;
}

export interface SectionLine {
  name: string;
  /** [m] along the axis that `findAxis` chose. */
  place: number[];
  /** SI; null where there is no value. */
  values: (number | null)[];
}

export interface SectionChart {
  title: string;
  lines: SectionLine[];
}

/** Fields that a reader looks for first. */
const wanted = ["preconsolidation_pressure", "pore_pressure", "deviatoric_strain"];

export function chooseField(section: Section): string {
  const has = (name: string) => section.fields.some((f) => f.name === name);
  return wanted.find(has) ?? section.fields[0]?.name ?? "";
}

/** The axis that a section runs along when it is steep: places are then heights; else distances along the line. */
export function findAxis(section: Section): { title: string; steep: boolean } {
  const along = section.to.map((x, d) => x - section.from[d]!);
  const steep = Math.abs(along[1] ?? 0) > Math.hypot(along[0] ?? 0, along[2] ?? 0);
  return steep ? { title: "Height y", steep } : { title: "Distance along the section", steep };
}

function findPlaces(section: Section, distance: number[]): number[] {
  if (!findAxis(section).steep) return distance;
  const along = section.to.map((x, d) => x - section.from[d]!);
  const length = Math.hypot(...along);
  return distance.map((s) => section.from[1]! + (along[1]! * s) / length);
}

/** "40 s": to about a hundredth of the longest time, because stored frames lie a step beside the given times. */
export function nameTime(time: number, longest: number): string {
  const decimals = Math.max(0, 2 - Math.floor(Math.log10(longest > 0 ? longest : 1)));
  return `${Number(time.toFixed(decimals)) + 0} s`;
}

/** Lines of `field`: a chart for each run with a line for each time, or the other way round. */
export function makeSectionCharts(runs: SectionOfRun[], field: string, by: "run" | "time"): SectionChart[] {
  const longest = Math.max(0, ...runs.flatMap((r) => r.section.profiles.map((p) => p.time)));
  const charts: SectionChart[] = runs.map(({ title, section }) => {
    const k = section.fields.findIndex((f) => f.name === field);
    const lines = section.profiles.map((p) => ({
      name: nameTime(p.time, longest),
      place: findPlaces(section, p.distance),
      values: k < 0 ? [] : p.values[k]!,
    }));
    return { title, lines };
  });
  if (by === "run") return charts;
  // Stored frames of different runs lie at nearly the same times: what has one place in the list is shown as one.
  const count = Math.max(0, ...charts.map((c) => c.lines.length));
  return Array.from({ length: count }, (_, i) => ({
    title: [...new Set(charts.flatMap((c) => (c.lines[i] ? [c.lines[i]!.name] : [])))].join(" / "),
    lines: charts.flatMap((c) => (c.lines[i] ? [{ ...c.lines[i]!, name: c.title }] : [])),
  }));
}

/** The sections called `name` of all variants that have it. */
export function listSectionsOf(study: Study, name: string): SectionOfRun[] {
  return study.rows.flatMap((row, i) => {
    const section = row.sections?.find((s) => s.name === name);
    return section ? [{ title: nameRow(study, i), section }] : [];
  });
}

export function makeSectionColumns(runs: SectionOfRun[]): CsvColumn[] {
  const fields = runs[0]?.section.fields ?? [];
  const rows = runs.flatMap(({ title, section }) =>
    section.profiles.flatMap((p) => p.distance.map((s, i) => ({ title, time: p.time, s, i, p }))),
  );
  return [
    { name: "run", values: rows.map((r) => r.title) },
    { name: "time", unit: "s", values: rows.map((r) => r.time) },
    { name: "distance", unit: "m", values: rows.map((r) => r.s) },
    ...fields.map((f, k) => ({
      name: f.name,
      unit: f.unit.name,
      values: rows.map((r) => {
        const v = r.p.values[k]?.[r.i] ?? null;
        return v === null ? null : v / f.unit.si;
      }),
    })),
  ];
}
