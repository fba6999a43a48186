// SPDX-License-Identifier: MIT
/** Histories over time: the balance of energy, the approach to rest, momentum, and the monitors; one chart for the quantities of one unit. */
import * as Plot from "@observablehq/plot";
import { type Signal, signal } from "@preact/signals";
import { useMemo, useState } from "preact/hooks";

import type { Table } from "../../contract";
import { frameIndex, printing, report, sequence, sequenceIndex } from "../../state";
import { Chart } from "../base/Chart";
import { AxisChoice, CsvButton, Legend, Select, useSwitches } from "../base/Legend";
import { layOut, makeAxis } from "../base/axes";
import { type CsvColumn, findNearest, findNearestFrame, pickRows } from "../base/rows";
import { findLargest, formatNumber, formatQuantity, titleWithUnit } from "../base/numbers";
import { styleOf } from "../base/styles";
import { findRestLimits } from "../curve/curveData";
import {
  findEnergyBalance, findStageSpans, groupHistories, type HistoryGroup, makePanels, type Panel,
} from "./histories";

interface PanelProps {
  panel: Panel;
  /** Time under the crosshair [s]. */
  cross: Signal<number | null>;
  /** Id of the sequence that runs along the same time. */
  sequence: string;
  monitors: boolean;
}

/** In the plane energies and momenta are those of a slice of one metre. */
function nameUnit({ unit, extensive }: Panel): string {
  const shown = unit === "m3/s" ? "m³/s" : unit;
  return report.value.model.dimension === 2 && extensive ? `${shown} per m` : shown;
}

function HistoryPanel({ panel, cross, sequence: own, monitors }: PanelProps) {
  const [log, setLog] = useState(panel.log);
  const [hidden, toggle] = useSwitches();
  const unit = nameUnit(panel);
  const series = useMemo(() => panel.series.map((s, i) => ({ ...s, style: styleOf(i) })), [panel]);
  const single = series.length === 1 ? series[0] : undefined;
  const visible = series.filter((s) => !hidden.has(s.name));
  const times = useMemo(() => panel.x.values.map((t) => t ?? Number.NaN), [panel]);
  const limits = useMemo(
    () => findRestLimits(report.value.result.input, report.value.model.slope_height),
    [report.value],
  );
  const limit =
    panel.kind === "force_ratio" ? limits.forceRatio : panel.kind === "nodal_speed" ? limits.nodalSpeed : null;
  const shape = (v: number | null) => (v === null || !log ? v : Math.abs(v) > 0 ? Math.abs(v) : null);
  const drawn = visible.flatMap((s) => s.values.map(shape)).filter((v): v is number => Number.isFinite(v));
  const domain: [number, number] = drawn.length ? findDomain(drawn, log, limit) : [log ? 0.1 : 0, 1];
  const below = drawn.some((v) => v < domain[0]) ? "Smaller values lie below the axis; the CSV holds them." : undefined;
  const at = cross.value === null || printing.value ? -1 : findNearest(times, cross.value);
  // The title of the momentum already states that it is a magnitude.
  const signed = panel.series.some((s) => s.values.some((v) => (v ?? 0) < 0)) && panel.kind !== "momentum";
  const title = log && signed ? `${panel.title}, magnitude` : panel.title;

  const formatTime = (i: number) => `${panel.x.title} ${formatQuantity(times[i], panel.x.unit)}`;

  const draw = (width: number): Plot.PlotOptions => {
    const first = times[0] ?? 0;
    const last = times[times.length - 1] ?? 1;
    const axis = makeAxis({ title, unit, domain, log, count: log ? 6 : 5 });
    const stages = isOfStages(own) ? findStageSpans(report.value.model.stages) : [];
    return layOut({
      height: panel.kind === "energy" || monitors ? 250 : 200,
      margins: [26, 12, 44, 58],
      x: { domain: [first, last], label: titleWithUnit(panel.x.title, panel.x.unit), ticks: 6 },
      y: axis,
      marks: [
        log ? [] : Plot.ruleY([0], { stroke: "var(--muted)", strokeWidth: 1 }),
        stages.slice(1).map((s) => Plot.ruleX([s.start], { stroke: "var(--muted)", strokeDasharray: "1 3" })),
        Plot.text(
          stages.filter((s) => stages.length > 1 && (s.end - s.start) / (last - first) > findRoom(s.name) / width),
          {
            x: "start",
            text: "name",
            frameAnchor: "top",
            dx: 4,
            dy: 3,
            textAnchor: "start",
            lineAnchor: "top",
            fill: "var(--muted)",
          },
        ),
        visible.map((s) =>
          Plot.line(
            pickRows(s.values, width).map((i) => [times[i]!, shape(s.values[i] ?? null) ?? Number.NaN]),
            { stroke: s.style.colour, strokeWidth: 1.6, strokeDasharray: s.style.dash, clip: true },
          ),
        ),
        limit !== null && log
          ? [
              Plot.ruleY([limit], { stroke: "var(--ink)", strokeWidth: 1, strokeDasharray: "2 2" }),
              Plot.text([limit], {
                y: (d: number) => d,
                text: () => `rest: below ${formatNumber(limit, 2)}`,
                frameAnchor: "right",
                textAnchor: "end",
                dy: -7,
                fill: "var(--ink)",
                stroke: "var(--ground)",
                strokeWidth: 3,
              }),
            ]
          : [],
        Plot.ruleX([first], { stroke: "var(--muted)" }),
      ],
    });
  };

  const show = (stop: number) => {
    const index = report.value.sequences.findIndex((s) => s.id === own);
    const frame = findNearestFrame(report.value.sequences[index]?.frames ?? [], (f) => f.time, times[stop]!);
    if (index < 0 || frame < 0) return;
    sequenceIndex.value = index;
    frameIndex.value = frame;
  };

  return (
    <figure aria-label={panel.title}>
      <div class="chart-head">
        <h4>{panel.title}</h4>
        <AxisChoice
          short
          label={`Axis of ${panel.title}`}
          value={log ? "log" : "linear"}
          onChange={(v) => setLog(v === "log")}
        />
      </div>
      {!single && (
        <Legend
          hidden={hidden}
          onToggle={toggle}
          items={series.map((s) => ({
            id: s.name,
            title: s.title,
            style: s.style,
            value: at < 0 ? "" : formatNumber(s.values[at]),
          }))}
        />
      )}
      <Chart
        quiet
        label={panel.title}
        draw={draw}
        depends={[panel, log, hidden, report.value]}
        stops={times}
        cross={cross}
        printWidth={330}
        read={(i) => ({
          text: `${formatTime(i)}: ${visible.map((s) => `${s.title} ${formatQuantity(s.values[i], unit)}`).join(", ")}`,
          marks: visible.flatMap((s) => {
            const y = shape(s.values[i] ?? null);
            return y === null ? [] : [{ value: y, colour: s.style.colour }];
          }),
        })}
        onPick={own ? show : undefined}
        ruler={() => {
          const shown = sequence.value;
          return own && shown?.id === own ? (shown.frames[frameIndex.value]?.time ?? null) : null;
        }}
      />
      <p class="chart-note">
        {at < 0
          ? (panel.note ?? below ?? "\u00a0")
          : single
            ? `${formatTime(at)}: ${formatQuantity(single.values[at], unit)}`
            : formatTime(at)}
      </p>
    </figure>
  );
}

/** Width that the name of a stage takes on a chart, with its gaps [px]; at most, for fonts differ. */
function findRoom(name: string): number {
  return name.length * 8 + 8;
}

function isOfStages(own: string): boolean {
  return report.value.sequences.some((s) => s.id === own && s.kind === "stages");
}

function findDomain(values: number[], log: boolean, limit: number | null): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (const v of values) {
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  if (log) {
    if (limit !== null) {
      low = Math.min(low, limit);
      high = Math.max(high, limit);
    }
    // Ten decades show all that is not round-off; what lies lower leaves the frame.
    return [Math.max(low / 1.5, high * 1e-10), high * 1.5];
  }
  // Zero belongs on the axis unless the values change little in comparison with their size, as the mass does.
  const spread = high - low;
  if (low > 0 && spread > 0.2 * high) low = 0;
  if (high < 0 && spread > 0.2 * -low) high = 0;
  const pad = 0.05 * (high - low) || 0.05 * findLargest(values) || 1;
  return [low === 0 ? 0 : low - pad, high === 0 ? 0 : high + pad];
}

/** The table as it is, and the residual of the energy balance where it can be formed. */
function makeColumns(table: Table): CsvColumn[] {
  const balance = findEnergyBalance(table);
  const columns: CsvColumn[] = [table.x, ...table.columns];
  return balance ? [...columns, { name: "energy_residual", unit: "J", values: balance.residual }] : columns;
}

export function HistorySection() {
  const groups = useMemo(() => groupHistories(report.value), [report.value]);
  const [chosen, setChosen] = useState(0);
  const group = groups[chosen];
  if (!group) return null;
  return (
    <section class="chart-section" aria-labelledby="chart-history-title">
      <div class="chart-head">
        <h3 id="chart-history-title">Histories</h3>
        <div class="chart-tools">
          {group.tables.map((t) => (
            <CsvButton
              key={t.id}
              part={t.id}
              what={t.kind === "monitors" ? "monitors" : "history"}
              columns={() => makeColumns(t)}
            />
          ))}
        </div>
      </div>
      {groups.length > 1 && <p class="chart-note chart-printed">Time of: {group.title}</p>}
      {groups.length > 1 && (
        <div class="chart-bar">
          <Select label="Time of" value={chosen} options={groups.map((g, i) => [i, g.title])} onChange={(value) => setChosen(Number(value))} />
        </div>
      )}
      <Panels key={chosen} group={group} />
      <p class="chart-note">{group.tables.map((t) => t.title).join("; ")}.</p>
    </section>
  );
}

function Panels({ group }: { group: HistoryGroup }) {
  const panels = useMemo(
    () => group.tables.flatMap((table) => makePanels(table).map((panel) => ({ panel, table }))),
    [group],
  );
  const [shown, toggle] = useSwitches(() => panels.filter((p) => p.panel.first).map((p) => p.panel.id));
  // One crosshair for all charts of the run.
  const cross = useMemo(() => signal<number | null>(null), [group]);
  return (
    <>
      {group.tables.map((t) => (
        <div class="chart-bar" key={t.id}>
          <fieldset>
            <legend>{t.kind === "monitors" ? "Monitors" : "Whole body"}</legend>
            {panels
              .filter((p) => p.table === t)
              .map(({ panel }) => (
                <label key={panel.id}>
                  <input type="checkbox" checked={shown.has(panel.id)} onChange={() => toggle(panel.id)} />
                  {panel.title}
                </label>
              ))}
          </fieldset>
        </div>
      ))}
      <div class="chart-grid">
        {panels
          .filter((p) => shown.has(p.panel.id))
          .map(({ panel, table }) => (
            <HistoryPanel
              key={panel.id}
              panel={panel}
              cross={cross}
              sequence={group.sequence}
              monitors={table.kind === "monitors"}
            />
          ))}
      </div>
    </>
  );
}
