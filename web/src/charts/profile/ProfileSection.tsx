// SPDX-License-Identifier: MIT
/** Profiles: a field over height along a vertical section, and the line of the ground before and after. */
import * as Plot from "@observablehq/plot";
import { useMemo } from "preact/hooks";

import type { Table } from "../../contract";
import { formatCoordinate } from "../../page/format";
import { report } from "../../state";
import { Chart } from "../base/Chart";
import { CsvButton, Legend } from "../base/Legend";
import { describeAxis, layOut, makeAxis } from "../base/axes";
import { titleWithUnit } from "../base/numbers";
import { styleOf } from "../base/styles";
import { SectionCharts } from "../sections/SectionCharts";
import { VerticalSection } from "./VerticalSection";

const margin = { left: 52, right: 16, top: 28, bottom: 46 };

function GroundChart({ table }: { table: Table }) {
  const x = useMemo(() => table.x.values.map((v) => v ?? Number.NaN), [table]);
  // The first line is the old ground: dashed and grey, the others are solid.
  const lines = table.columns.map((c, i) => ({
    ...c,
    style: i === 0 ? { ...styleOf(0), colour: "var(--muted)", dash: "5 3" } : styleOf(i - 1),
  }));
  const abscissa = table.x.title.length === 1 ? table.x.title.toLowerCase() : table.x.title;
  const unit = table.columns[0]?.unit ?? "m";
  const all = lines.flatMap((l) => l.values).filter((v): v is number => v !== null);
  const first = lines[0];
  const last = lines[lines.length - 1];
  if (!first || !last || all.length === 0) return null;
  const low = Math.min(...all);
  const high = Math.max(...all);
  const pad = 0.08 * (high - low) || 1;
  const length = (x[x.length - 1] ?? 1) - (x[0] ?? 0);

  /** Height of the frame that is true to scale [px], and the one that is taken. */
  const findHeight = (width: number) => {
    const scaled = ((width - margin.left - margin.right) * (high - low + 2 * pad)) / (length || 1);
    return { scaled, taken: Math.min(460, Math.max(140, scaled)) };
  };
  /** Both axes are in the unit of lengths. */
  const formatHere = (value: number | null | undefined) =>
    Number.isFinite(value) ? `${formatCoordinate(value! * report.value.units.length.si)} ${unit}` : "–";
  const change = x.map((at, i) => [at, first.values[i] ?? Number.NaN, last.values[i] ?? Number.NaN]);

  const draw = (width: number): Plot.PlotOptions => {
    const height = findHeight(width);
    const ticks = width < 480 ? 5 : 8;
    const along = describeAxis(x[0] ?? 0, x[x.length - 1] ?? 1, ticks);
    const exaggeration = height.taken / height.scaled;
    return layOut({
      height: height.taken + margin.top + margin.bottom,
      margins: [margin.top, margin.right, margin.bottom, margin.left],
      x: { label: titleWithUnit(abscissa, table.x.unit), ticks, tickFormat: along.format },
      y: makeAxis({ title: "Height", unit, domain: [low - pad, high + pad] }),
      marks: [
        Plot.areaY(change, { x: "0", y1: "1", y2: "2", fill: lines[1]?.style.colour ?? "none", fillOpacity: 0.12 }),
        lines.map((l) =>
          Plot.line(
            x.map((at, i) => [at, l.values[i] ?? Number.NaN]),
            { stroke: l.style.colour, strokeWidth: 1.8, strokeDasharray: l.style.dash },
          ),
        ),
        Plot.text([Math.abs(exaggeration - 1) < 0.01 ? "true to scale" : `heights × ${exaggeration.toPrecision(2)}`], {
          frameAnchor: "top-right",
          dy: 4,
          fill: "var(--muted)",
        }),
        Plot.ruleX([x[0] ?? 0], { stroke: "var(--muted)" }),
      ],
    });
  };

  return (
    <figure aria-label={table.title} class="chart-figure">
      <div class="chart-head">
        <h4>{table.title}</h4>
        <CsvButton part={table.id} columns={() => [table.x, ...table.columns]} />
      </div>
      <Legend items={lines.map((l) => ({ id: l.name, title: l.title, style: l.style }))} />
      <Chart
        label={table.title}
        draw={draw}
        depends={[table]}
        stops={x}
        hint="Point at the ground to read it."
        read={(i) => ({
          text: `${abscissa} = ${formatHere(x[i])}: ${lines
            .map((l) => `${l.title.toLowerCase()} ${formatHere(l.values[i])}`)
            .join(", ")}`,
          marks: lines.flatMap((l) => {
            const value = l.values[i] ?? null;
            return value === null ? [] : [{ value, colour: l.style.colour }];
          }),
        })}
      />
    </figure>
  );
}

export function ProfileSection() {
  const grounds = report.value.tables.filter((t) => t.kind === "ground");
  const named = (report.value.sections ?? []).length > 0;
  const sections = report.value.sequences.some((s) => s.frames.length > 0 && s.fields.length > 0);
  if (!named && !sections && grounds.length === 0) return null;
  return (
    <section class="chart-section" aria-labelledby="chart-profile-title">
      <h3 id="chart-profile-title">Profiles</h3>
      <SectionCharts />
      {sections && <VerticalSection />}
      {grounds.map((t) => (
        <GroundChart key={t.id} table={t} />
      ))}
    </section>
  );
}
