// SPDX-License-Identifier: MIT
/** The movement of the monitored points of all variants: displacements over time, onsets, and their order. */
import * as Plot from "@observablehq/plot";
import { type Signal, signal } from "@preact/signals";
import { useMemo, useState } from "preact/hooks";

import { report } from "../../state";
import { layOut, makeAxis } from "../base/axes";
import { Chart } from "../base/Chart";
import { Choice, CsvButton, Legend, useSwitches } from "../base/Legend";
import { interpolate, makeMotionCharts, makeMotionColumns, type MotionChart, type Study } from "./studyData";
import { formatNumber, formatQuantity } from "../base/numbers";
import { styleOf } from "../base/styles";

/** Times at which the crosshair stops. */
const stopCount = 201;

interface PanelProps {
  chart: MotionChart;
  /** Names of all lines of all charts in the order of their styles. */
  names: string[];
  hidden: ReadonlySet<string>;
  cross: Signal<number | null>;
  /** Ends of both axes: [s], in the unit of displacement. */
  ends: [number, number];
  threshold: number | null;
}

function MotionPanel({ chart, names, hidden, cross, ends, threshold }: PanelProps) {
  const unit = report.value.units.displacement;
  const [last, highest] = ends;
  const lines = chart.lines
    .filter((l) => !hidden.has(l.name))
    .map((l) => ({ ...l, style: styleOf(names.indexOf(l.name)) }));
  const stops = useMemo(() => Array.from({ length: stopCount }, (_, i) => (last * i) / (stopCount - 1)), [last]);
  const limit = threshold === null ? null : threshold / unit.si;
  const onsets = lines.flatMap((l) => (l.onset === null || limit === null ? [] : [{ x: l.onset, y: limit, l }]));

  const draw = (width: number) =>
    layOut({
      height: Math.max(230, Math.min(300, width * 0.6)),
      margins: [26, 14, 44, 58],
      x: { domain: [0, last], label: "Time [s]", ticks: 6 },
      y: makeAxis({ title: "Displacement", unit: unit.name, domain: [0, highest] }),
      marks: [
        Plot.ruleY([0], { stroke: "var(--muted)" }),
        Plot.ruleX([0], { stroke: "var(--muted)" }),
        limit === null ? [] : Plot.ruleY([limit], { stroke: "var(--muted)", strokeDasharray: "2 3" }),
        lines.map((l) =>
          Plot.line(
            l.time.map((t, i) => [t, l.displacement[i] === null ? Number.NaN : l.displacement[i]! / unit.si]),
            { stroke: l.style.colour, strokeWidth: 1.6, strokeDasharray: l.style.dash, clip: true },
          ),
        ),
        Plot.dot(onsets, {
          x: "x",
          y: "y",
          r: 4,
          symbol: (d: (typeof onsets)[number]) => d.l.style.symbol,
          stroke: (d: (typeof onsets)[number]) => d.l.style.colour,
          strokeWidth: 1.6,
          fill: "var(--ground)",
        }),
      ],
    });

  return (
    <figure aria-label={chart.title}>
      <h4>{chart.title}</h4>
      <Chart
        label={`Displacement over time: ${chart.title}`}
        draw={draw}
        depends={[chart, hidden, last, highest]}
        stops={stops}
        cross={cross}
        hint="Point at a time to read it; symbols mark the onset of movement."
        printWidth={330}
        read={(i) => {
          const t = stops[i]!;
          const here = lines.flatMap((l) => {
            const u = interpolate(l.time, l.displacement, t);
            return u === null ? [] : [{ l, u: u / unit.si }];
          });
          const values = here.map(({ l, u }) => `${l.name} ${formatQuantity(u, unit.name, 3)}`);
          return {
            text: `${formatNumber(t)} s: ${values.join(", ")}`,
            marks: here.map(({ l, u }) => ({ value: u, colour: l.style.colour })),
          };
        }}
      />
    </figure>
  );
}

export function StudyMotion({ study }: { study: Study }) {
  const [by, setBy] = useState<"monitor" | "variant">("monitor");
  const [hidden, toggle, showAll] = useSwitches();
  const cross = useMemo(() => signal<number | null>(null), [study]);
  const charts = useMemo(() => makeMotionCharts(study, by), [study, by]);
  const unit = report.value.units.displacement;
  if (charts.length === 0) return null;
  const names = [...new Set(charts.flatMap((c) => c.lines.map((l) => l.name)))];
  const lines = charts.flatMap((c) => c.lines);
  const last = Math.max(...lines.map((l) => l.time.at(-1) ?? 0)) || 1;
  const values = lines.flatMap((l) => l.displacement).filter((u) => u !== null);
  const highest = (Math.max(0, ...values) * 1.05) / unit.si || 1;
  const thresholds = study.rows.flatMap((r) => (r.motion ? [r.motion.threshold] : []));
  const threshold = thresholds.length > 0 && thresholds.every((t) => t === thresholds[0]) ? thresholds[0]! : null;
  const stage = study.rows.find((r) => r.motion)?.motion?.stage;
  return (
    <figure aria-label="Movement of the monitored points" class="chart-figure">
      <div class="chart-head">
        <h4>Movement of the monitored points</h4>
        <CsvButton part="study-displacements" what="displacements" columns={() => makeMotionColumns(study, unit)} />
      </div>
      <div class="chart-bar">
        <Choice
          label="One chart for each"
          value={by}
          options={[
            { value: "monitor", title: "by monitor" },
            { value: "variant", title: "by variant" },
          ]}
          onChange={(v) => {
            setBy(v);
            showAll();
          }}
        />
      </div>
      <Legend
        markers
        hidden={hidden}
        onToggle={toggle}
        items={names.map((n, i) => ({ id: n, title: n, style: styleOf(i) }))}
      />
      <div class="chart-grid">
        {charts.map((c) => (
          <MotionPanel
            key={`${by} ${c.title}`}
            chart={c}
            names={names}
            hidden={hidden}
            cross={cross}
            ends={[last, highest]}
            threshold={threshold}
          />
        ))}
      </div>
      <p class="chart-note">
        Magnitude of the displacement, from the start of {stage ? `“${stage}”` : "the count"} on.
        {threshold !== null &&
          ` Dashed: the displacement that counts as movement, ${formatQuantity(threshold / unit.si, unit.name)}.`}
      </p>
    </figure>
  );
}
