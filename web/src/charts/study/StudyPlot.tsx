// SPDX-License-Identifier: MIT
/** A result of a study over one of its varied keys, one line for each combination of the others; or by variant. */
import * as Plot from "@observablehq/plot";
import { useState } from "preact/hooks";

import { findLogTicks, formatLogTick, layOut, makeAxis } from "../base/axes";
import { Chart } from "../base/Chart";
import { AxisChoice, type AxisKind, Legend } from "../base/Legend";
import { formatNumber, formatQuantity, titleWithUnit } from "../base/numbers";
import { styleOf } from "../base/styles";
import { findNumeric, findVaried, nameGroup } from "./studyData";
import type { Study } from "./shownStudy";
import { Select } from "../base/Select";

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

export function StudyPlot({ study }: { study: Study }) {
  const results = findNumeric(study);
  const keys = findVaried(study).filter((c) => c.values.filter((v) => v !== null).length > 1);
  const [resultName, setResult] = useState(results[0]?.name ?? "");
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

  const list = (columns: typeof keys) => columns.map((c): [string, string] => [c.name, titleWithUnit(c.title, c.unit)]);

  const draw = (width: number): Plot.PlotOptions => {
    const narrow = width < 560;
    const labels = !key;
    const low = Math.min(...points.map((p) => p.y));
    const high = Math.max(...points.map((p) => p.y));
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
        groups.map((g, i) => {
          const mine = points.filter((p) => p.group === g);
          const style = styleOf(i);
          const place = { x: "x", y: "y", stroke: style.colour };
          return [
            key ? Plot.line(mine, { ...place, strokeWidth: 1.5, strokeDasharray: style.dash }) : [],
            Plot.dot(mine, { ...place, strokeWidth: 1.6, fill: "var(--ground)", symbol: style.symbol, r: 4.2 }),
          ];
        }),
        groups.length === 1 && points.length <= 12 && !narrow
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
      {missing > 0 && (
        <p class="chart-note">
          {missing === 1 ? "One variant" : `${missing} variants`} without{" "}
          {key ? "this result or a number for this key" : "this result"} left out.
        </p>
      )}
    </figure>
  );
}
