// SPDX-License-Identifier: MIT
/** Sections that the case names: a field along a line at chosen times, of one run or of the variants of a study. */
import * as Plot from "@observablehq/plot";
import { type Signal, signal } from "@preact/signals";
import { useMemo, useState } from "preact/hooks";

import type { Section } from "../../contract";
import { formatPlace } from "../../page/format";
import { report } from "../../state";
import { Chart } from "../base/Chart";
import { Choice, CsvButton, Legend, Select, useSwitches } from "../base/Legend";
import { layOut, makeAxis } from "../base/axes";
import type { CsvColumn } from "../base/rows";
import { formatQuantity, titleWithUnit } from "../base/numbers";
import { styleOf } from "../base/styles";
import { interpolate, nameRow, type Study } from "../study/studyData";

/** A section of one run. */
interface SectionOfRun {
  title: string;
  section: Section;
}

interface SectionLine {
  name: string;
  /** [m] along the axis that `findAxis` chose. */
  place: number[];
  /** SI; null where there is no value. */
  values: (number | null)[];
}

interface SectionChart {
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

function makeSectionColumns(runs: SectionOfRun[]): CsvColumn[] {
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

const stopCount = 81;

interface PanelProps {
  chart: SectionChart;
  names: string[];
  hidden: ReadonlySet<string>;
  field: { title: string; unit: { name: string; si: number } };
  axis: { title: string; steep: boolean };
  /** Ends of the place [length unit] and of the value [unit of the field]. */
  ends: { place: [number, number]; value: [number, number] };
  cross: Signal<number | null>;
}

function SectionPanel({ chart, names, hidden, field, axis, ends, cross }: PanelProps) {
  const length = report.value.units.length;
  const { unit } = field;
  const lines = chart.lines
    .filter((l) => !hidden.has(l.name))
    .map((l) => ({
      ...l,
      style: styleOf(names.indexOf(l.name)),
      // Ascending for reading.
      points: l.place
        .map((s, i) => ({ s: s / length.si, v: l.values[i] === null ? null : l.values[i]! / unit.si }))
        .sort((a, b) => a.s - b.s),
    }));
  const [first, last] = ends.place;
  const stops = useMemo(
    () => Array.from({ length: stopCount }, (_, i) => first + ((last - first) * i) / (stopCount - 1)),
    [first, last],
  );
  const value = makeAxis({ title: field.title, unit: unit.name, domain: ends.value });
  const place = { domain: ends.place, label: titleWithUnit(axis.title, length.name), ticks: 6 };
  const rule = axis.steep ? Plot.ruleX : Plot.ruleY;
  const draw = (width: number) =>
    layOut({
      height: axis.steep ? Math.max(280, Math.min(380, width * 0.8)) : Math.max(230, Math.min(300, width * 0.6)),
      margins: [26, 18, 46, 58],
      x: axis.steep ? value : place,
      y: axis.steep ? place : value,
      grid: axis.steep ? "x" : "y",
      marks: [
        rule([0], { stroke: "var(--muted)" }),
        lines.map((l) =>
          Plot.line(
            l.points.map((p) => {
              const v = p.v ?? Number.NaN;
              return axis.steep ? [v, p.s] : [p.s, v];
            }),
            { stroke: l.style.colour, strokeWidth: 1.6, strokeDasharray: l.style.dash },
          ),
        ),
      ],
    });
  return (
    <figure aria-label={chart.title}>
      {chart.title && <h4>{chart.title}</h4>}
      <Chart
        along={axis.steep ? "y" : "x"}
        label={`${field.title} along the section${chart.title && `: ${chart.title}`}`}
        draw={draw}
        depends={[chart, hidden, field, ends]}
        stops={stops}
        cross={cross}
        hint={axis.steep ? "Point at a height to read it." : "Point at a place to read it."}
        printWidth={330}
        read={(i) => {
          const at = stops[i]!;
          const here = lines.flatMap((l) => {
            const v = interpolate(
              l.points.map((p) => p.s),
              l.points.map((p) => p.v),
              at,
            );
            return v === null ? [] : [{ l, v }];
          });
          return {
            text: `${axis.title} ${formatQuantity(at, length.name, 3)}: ${here
              .map(({ l, v }) => `${l.name} ${formatQuantity(v, unit.name, 3)}`)
              .join(", ")}`,
            marks: here.map(({ l, v }) => ({ value: v, at, colour: l.style.colour })),
          };
        }}
      />
    </figure>
  );
}

/** One section: of one run, or of several side by side. */
export function SectionFigure({ runs }: { runs: SectionOfRun[] }) {
  const section = runs[0]!.section;
  const [name, setName] = useState(() => chooseField(section));
  const [by, setBy] = useState<"run" | "time">("run");
  const [hidden, toggle, showAll] = useSwitches();
  const cross = useMemo(() => signal<number | null>(null), [section]);
  const charts = useMemo(() => makeSectionCharts(runs, name, by), [runs, name, by]);
  const field = section.fields.find((f) => f.name === name) ?? section.fields[0];
  const length = report.value.units.length;
  if (!field) return null;
  const axis = findAxis(section);
  const names = [...new Set(charts.flatMap((c) => c.lines.map((l) => l.name)))];
  const lines = charts.flatMap((c) => c.lines);
  const places = lines.flatMap((l) => l.place).map((s) => s / length.si);
  const values = lines
    .flatMap((l) => l.values)
    .filter((v) => v !== null)
    .map((v) => v / field.unit.si);
  // Zero is on the axis unless the values change little in comparison with their size, as a porosity does.
  let [low, high] = [Math.min(...values), Math.max(...values)];
  if (!(low <= high)) [low, high] = [0, 1];
  const pad = 0.05 * (high - low) || 0.05 * Math.abs(high) || 1;
  const near = high - low < 0.2 * Math.max(Math.abs(low), Math.abs(high));
  const value: [number, number] = near
    ? [low - pad, high + pad]
    : [low >= 0 ? 0 : low - pad, high <= 0 ? 0 : high + pad];
  const ends = { place: [Math.min(...places), Math.max(...places)] as [number, number], value };
  const formatHere = (p: number[]) => formatPlace(p.slice(0, report.value.model.dimension));
  return (
    <figure aria-label={`Section ${section.name}`} class="chart-figure section-figure">
      <div class="chart-head">
        <h4>Section {section.name}</h4>
        <CsvButton part={`section-${section.name}`} columns={() => makeSectionColumns(runs)} />
      </div>
      <div class="chart-bar">
        <Select label="Field" value={field.name} options={section.fields.map((f) => [f.name, titleWithUnit(f.title, f.unit.name)])} onChange={setName} />
        {runs.length > 1 && (
          <Choice
            label="One chart for each"
            value={by}
            options={[
              { value: "run", title: "by variant" },
              { value: "time", title: "by time" },
            ]}
            onChange={(v) => {
              setBy(v);
              showAll();
            }}
          />
        )}
      </div>
      <Legend hidden={hidden} onToggle={toggle} items={names.map((n, i) => ({ id: n, title: n, style: styleOf(i) }))} />
      <div class="chart-grid">
        {charts.map((c) => (
          <SectionPanel
            key={`${by} ${c.title}`}
            chart={c}
            names={names}
            hidden={hidden}
            field={field}
            axis={axis}
            ends={ends}
            cross={cross}
          />
        ))}
      </div>
      <p class="chart-note">
        Means over the points within {formatQuantity((0.5 * section.width) / length.si, length.name, 3)} of the line
        from {formatHere(section.from)} to {formatHere(section.to)} {length.name}, in parts of{" "}
        {formatQuantity(section.width / length.si, length.name, 3)}.
      </p>
    </figure>
  );
}

/** The sections of a run. */
export function SectionCharts() {
  const sections = report.value.sections ?? [];
  if (sections.length === 0) return null;
  return (
    <>
      {sections.map((s) => (
        <SectionFigure key={s.name} runs={[{ title: "", section: s }]} />
      ))}
    </>
  );
}
