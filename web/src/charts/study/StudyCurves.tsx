// SPDX-License-Identifier: MIT
/** The displacement curves of all variants of a study over each other. */
import * as Plot from "@observablehq/plot";
import { useMemo, useState } from "preact/hooks";

import { report } from "../../state";
import { layOut, makeAxis } from "../base/axes";
import { Chart } from "../base/Chart";
import { makeCurveColumns } from "../curve/curveData";
import { AxisChoice, type AxisKind, CsvButton, Legend } from "../base/Legend";
import { formatNumber, formatQuantity, titleWithUnit } from "../base/numbers";
import { useSwitches } from "../base/useSwitches";
import { styleOf } from "../base/styles";
import type { Study } from "./shownStudy";

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
