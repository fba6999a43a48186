// SPDX-License-Identifier: MIT
/** A result of a study over one of its varied keys, one line for each combination of the others; and the displacement curves of all variants. */
import * as Plot from "@observablehq/plot";
import { useMemo, useState } from "preact/hooks";

import type { StudyGoal } from "../../contract";
import { report } from "../../state";
import { Chart } from "../base/Chart";
import { AxisChoice, type AxisKind, CsvButton, Legend, Select, useSwitches } from "../base/Legend";
import { findLogTicks, formatLogTick, layOut, makeAxis } from "../base/axes";
import { formatNumber, formatQuantity, titleWithUnit } from "../base/numbers";
import { styleOf } from "../base/styles";
import { makeCurveColumns } from "../curve/curveData";
import { ChartTable } from "../../page/DataTable";
import { findGoals, findNumeric, findVaried, nameGroup, type Study } from "./studyData";

const byVariant = "";

/** Times and rates over two decades or more are read on a logarithmic axis. */
function spansDecades(values: number[]): boolean {
  const low = Math.min(...values);
  return low > 0 && Math.max(...values) >= 100 * low;
}

function logTicks(values: number[]) {
  const ends = [Math.min(...values), Math.max(...values)] as const;
  return { type: "log" as const, ticks: findLogTicks(ends, 6), tickFormat: formatLogTick };
}

/** The target, the interval of the value as a band, and the value. An unknown end of the band is that of the chart. */
function markGoal(goal: StudyGoal, stops: number[]) {
  const band = { x1: goal.low ?? stops[0]!, x2: goal.high ?? stops.at(-1)! };
  return [
    goal.low !== null || goal.high !== null ?
      Plot.rectX([band], { x1: "x1", x2: "x2", fill: "var(--ink)", fillOpacity: 0.08 })
    : [],
    Plot.ruleY([goal.target], { stroke: "var(--ink)", strokeDasharray: "6 4" }),
    goal.value === null ? [] : Plot.ruleX([goal.value], { stroke: "var(--ink)", strokeWidth: 1.5 }),
  ];
}

/** All targets of a back-analysis, with the values that reach them. */
function GoalTable({ study }: { study: Study }) {
  const find = (name: string) => study.columns.find((c) => c.name === name);
  return (
    <ChartTable
      label="Targets and values found"
      rows={study.goals ?? []}
      columns={[
        ["Result", (g) => find(g.result)?.title ?? g.result, "name"],
        ["Target", (g) => formatQuantity(g.target, find(g.result)?.unit ?? ""), "number"],
        ["Value found", (g) => (g.value === null ? "–" : formatQuantity(g.value, find(g.key)?.unit ?? "")), "number"],
      ]}
    />
  );
}

export function StudyPlot({ study }: { study: Study }) {
  const results = findNumeric(study);
  const keys = findVaried(study).filter((c) => c.values.filter((v) => v !== null).length > 1);
  const [resultName, setResult] = useState(study.goals?.[0]?.result ?? results[0]?.name ?? "");
  const [keyName, setKey] = useState(keys[0]?.name ?? byVariant);
  const [axisKind, setAxisKind] = useState<AxisKind>("log");
  const result = results.find((c) => c.name === resultName);
  if (!result) return null;
  const key = keys.find((c) => c.name === keyName) ?? null;

  const points = study.rows.flatMap((r, row) => {
    const y = result.values[row] ?? null;
    const x = key ? (key.values[row] ?? null) : row;
    const group = key ? nameGroup(study, row, key.name) : "";
    return y === null || x === null ? [] : [{ x, y, name: r.name, group }];
  });
  points.sort((a, b) => a.x - b.x);
  const groups = [...new Set(points.map((p) => p.group))];
  const stops = [...new Set(points.map((p) => p.x))];
  const missing = study.rows.length - points.length;
  const logX = key !== null && spansDecades(points.map((p) => p.x));
  const canLog = spansDecades(points.map((p) => p.y));
  const logY = canLog && axisKind === "log";

  // Marks of a back-analysis, on its own axes only.
  const goals = findGoals(study, result.name, key?.name);

  const list = (columns: typeof keys) => columns.map((c): [string, string] => [c.name, titleWithUnit(c.title, c.unit)]);

  const draw = (width: number): Plot.PlotOptions => {
    const narrow = width < 560;
    const labels = !key;
    const shown = [...points.map((p) => p.y), ...goals.map((g) => g.target)];
    const low = Math.min(...shown);
    const high = Math.max(...shown);
    const pad = (high - low) * 0.1 || Math.abs(high) * 0.1 || 1;
    return layOut({
      height: labels && narrow ? 420 : 360,
      margins: [28, 20, labels ? 34 + 3.8 * Math.max(...study.rows.map((r) => r.name.length)) : 48, 62],
      x: key
        ? {
            label: titleWithUnit(key.title, key.unit),
            inset: 14,
            ...(logX ? logTicks(points.map((p) => p.x)) : { ticks: narrow ? 5 : 8 }),
          }
        : {
            domain: [-0.5, study.rows.length - 0.5],
            label: null,
            ticks: study.rows.map((_, i) => i),
            tickFormat: (i: number) => study.rows[i]?.name ?? "",
            tickRotate: -35,
          },
      y: logY
        ? { label: titleWithUnit(result.title, result.unit), inset: 12, ...logTicks([low, high]) }
        : makeAxis({ title: result.title, unit: result.unit, domain: [low - pad, high + pad], count: 6 }),
      grid: "none",
      marks: [
        Plot.gridY({ ...(logY ? {} : { ticks: 6 }), stroke: "var(--line)", strokeOpacity: 1 }),
        Plot.ruleX(key ? [] : points, { x: "x", stroke: "var(--line)" }),
        goals.map((g) => markGoal(g, stops)),
        groups.map((g, i) => {
          const mine = points.filter((p) => p.group === g);
          const style = styleOf(i);
          const place = { x: "x", y: "y", stroke: style.colour };
          return [
            key ? Plot.line(mine, { ...place, strokeWidth: 1.5, strokeDasharray: style.dash }) : [],
            Plot.dot(mine, { ...place, strokeWidth: 1.6, fill: "var(--ground)", symbol: style.symbol, r: 4.2 }),
          ];
        }),
        groups.length === 1 && points.length <= 12 && !narrow && goals.length === 0
          ? Plot.text(points, { x: "x", y: "y", text: (p) => formatNumber(p.y), dy: -12, fill: "var(--ink)" })
          : [],
      ],
    });
  };

  return (
    <figure aria-label={`${result.title} of the variants`} class="chart-figure">
      <h4>
        {result.title}
        {key ? ` over ${key.title}` : " by variant"}
      </h4>
      <div class="chart-bar">
        <Select label="Result" value={result.name} options={list(results)} onChange={setResult} />
        <Select
          label="over"
          value={key?.name ?? byVariant}
          options={[...list(keys), [byVariant, "variant"]]}
          onChange={setKey}
        />
        {canLog && <AxisChoice label="Axis of the result" value={axisKind} onChange={setAxisKind} />}
      </div>
      {groups.length > 1 && <Legend markers items={groups.map((g, i) => ({ id: g, title: g, style: styleOf(i) }))} />}
      <Chart
        label={`${result.title} of the variants`}
        draw={draw}
        depends={[study, resultName, keyName, axisKind]}
        stops={stops}
        hint="Point at a variant to read it."
        read={(i) => {
          const here = points.filter((p) => p.x === stops[i]);
          return {
            text: here.map((p) => `${p.name}: ${formatQuantity(p.y, result.unit)}`).join("; "),
            marks: here.map((p) => ({ value: p.y, colour: styleOf(groups.indexOf(p.group)).colour })),
          };
        }}
      />
      {goals.map((g) => (
        <p class="chart-note" key={g.target}>
          Dashed: the target, {formatQuantity(g.target, result.unit)}.
          {g.value !== null && key && ` Line: the value found, ${formatQuantity(g.value, key.unit)}.`}
          {g.value === null && " No value was found."}
          {(g.low !== null || g.high !== null) && " Grey: values that the interval of the result allows."}
        </p>
      ))}
      {(study.goals?.length ?? 0) > 1 && <GoalTable study={study} />}
      {missing > 0 && (
        <p class="chart-note">
          {missing === 1 ? "One variant" : `${missing} variants`} without{" "}
          {key ? "this result or a number for this key" : "this result"} left out.
        </p>
      )}
    </figure>
  );
}

export function StudyCurves({ study }: { study: Study }) {
  const unit = report.value.units.displacement;
  const [scale, setScale] = useState<AxisKind>("linear");
  const [hidden, toggle] = useSwitches();
  const curves = useMemo(
    () =>
      study.rows
        .filter((r) => r.curve)
        .map((r, i) => ({
          name: r.name,
          curve: r.curve!,
          style: styleOf(i),
          points: r.curve!.points.map((p) => ({ x: p.srf, y: p.displacement / unit.si })).sort((a, b) => a.x - b.x),
        })),
    [study, unit],
  );
  const log = scale === "log";
  const visible = curves
    .filter((c) => !hidden.has(c.name))
    .map((c) => ({ ...c, points: log ? c.points.filter((p) => p.y > 0) : c.points }));
  const stops = [...new Set(visible.flatMap((c) => c.points.map((p) => p.x)))].sort((a, b) => a - b);

  const shown = visible.flatMap((c) => c.points.map((p) => p.y));
  const low = Math.min(...shown);
  const high = Math.max(...shown);

  const columns = () => {
    const parts = curves.map((c) => makeCurveColumns(c.curve));
    const names = curves.flatMap((c) => c.curve.points.map(() => c.name));
    const joined = (parts[0] ?? []).map((c, k) => ({ ...c, values: parts.flatMap((p) => p[k]!.values) }));
    return [{ name: "variant", values: names }, ...joined];
  };

  const axis = makeAxis({
    title: "Largest displacement",
    unit: unit.name,
    domain: log ? [low, high] : [0, high],
    log,
    count: 6,
    inset: 6,
  });
  const draw = (width: number) =>
    layOut({
      height: Math.max(300, Math.min(440, width * 0.55)),
      margins: [28, 16, 48, 62],
      x: { label: "Strength reduction factor SRF", ticks: width < 480 ? 5 : 8, inset: 6 },
      y: { ...axis, domain: undefined, label: titleWithUnit("Largest displacement", unit.name) },
      marks: visible.map(({ points, style }) => {
        const place = { x: "x", y: "y", stroke: style.colour };
        return [
          Plot.line(points, { ...place, strokeWidth: 1.5, strokeDasharray: style.dash }),
          Plot.dot(points, { ...place, symbol: style.symbol, r: 2.8, fill: "var(--ground)" }),
        ];
      }),
    });

  return (
    <figure aria-label="Displacement curves of the variants" class="chart-figure">
      <div class="chart-head">
        <h4>Displacement curves of the variants</h4>
        <CsvButton part="study-curves" what="curves" columns={columns} />
      </div>
      <div class="chart-bar">
        <AxisChoice label="Axis of displacement" value={scale} onChange={setScale} />
      </div>
      <Legend
        markers
        hidden={hidden}
        onToggle={toggle}
        items={curves.map((c) => ({ id: c.name, title: c.name, style: c.style }))}
      />
      <Chart
        label="Displacement curves of the variants"
        draw={draw}
        depends={[study, scale, hidden]}
        stops={stops}
        hint="Point at a factor to read all curves."
        read={(i) => {
          const here = visible.flatMap((c) => {
            const p = c.points.find((q) => q.x === stops[i]);
            return p ? [{ c, p }] : [];
          });
          const values = here.map(({ c, p }) => `${c.name} ${formatQuantity(p.y, unit.name)}`);
          return {
            text: `SRF ${formatNumber(stops[i], 5)}: ${values.join(", ")}`,
            marks: here.map(({ c, p }) => ({ value: p.y, colour: c.style.colour })),
          };
        }}
      />
    </figure>
  );
}
