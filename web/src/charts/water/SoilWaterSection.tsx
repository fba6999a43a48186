// SPDX-License-Identifier: MIT
/** Soil water: retention and conductivity of each soil, and the conditions at the boundary that change with time. */
import * as Plot from "@observablehq/plot";

import type { HydraulicCondition, MaterialRow, SoilWater, Unit } from "../../contract";
import { SymbolText } from "../../page/DataTable";
import { writeCondition } from "../../page/format";
import { report } from "../../state";
import { Chart } from "../base/Chart";
import { CsvButton } from "../base/Legend";
import { layOut, makeAxis } from "../base/axes";
import { formatQuantity, titleWithUnit } from "../base/numbers";

interface SoilWaterCurve {
  title: string;
  unit: string;
  log: boolean;
  values: number[];
  domain: [number, number];
}

/** S and k over suction; k is absent where no saturated conductivity is known. */
export function makeCurves(water: SoilWater, speed: Unit): SoilWaterCurve[] {
  const { saturation } = water.curves;
  const conductivity = toUnit(water.curves.conductivity, speed);
  const curves: SoilWaterCurve[] = [
    { title: "Degree of saturation S", unit: "-", log: false, values: saturation, domain: [0, 1] },
  ];
  const largest = Math.max(...conductivity);
  if (conductivity.length === 0 || !(largest > 0)) return curves;
  // Below a billionth of the saturated conductivity the flow is negligible.
  const low = Math.max(Math.min(...conductivity), 1e-9 * largest);
  const domain: [number, number] = [
    10 ** Math.floor(Math.log10(low / 1.5)),
    10 ** Math.ceil(Math.log10(largest * 1.5)),
  ];
  return [...curves, { title: "Conductivity k", unit: speed.name, log: true, values: conductivity, domain }];
}

const toUnit = (values: readonly number[], unit: Unit): number[] => values.map((v) => v / unit.si);

/** A unit of time in which a span is read well. */
export function chooseTimeUnit(span: number): Unit {
  if (span >= 5 * 86400) return { name: "d", si: 86400 };
  if (span >= 2 * 3600) return { name: "h", si: 3600 };
  return span >= 300 ? { name: "min", si: 60 } : { name: "s", si: 1 };
}

/** Conditions whose value changes with time: a constant needs no chart. */
export function findChanging(conditions: readonly HydraulicCondition[]): HydraulicCondition[] {
  return conditions.filter((c) => c.series && new Set(c.series.values).size > 1);
}

const margins: [number, number, number, number] = [26, 14, 44, 58];

function CurveChart({ name, curve, water }: { name: string; curve: SoilWaterCurve; water: SoilWater }) {
  const { stress } = report.value.units;
  const suction = toUnit(water.curves.suction, stress);
  const most = water.curves.largest_suction === null ? null : water.curves.largest_suction / stress.si;
  const domain: [number, number] = [suction[0] ?? 1, suction.at(-1) ?? 10];
  const draw = () =>
    layOut({
      height: 210,
      margins,
      x: makeAxis({ title: "Suction s", unit: stress.name, domain, log: true, count: 6 }),
      y: makeAxis({ title: curve.title, unit: curve.unit, domain: curve.domain, log: curve.log }),
      marks: [
        most === null
          ? []
          : [
              Plot.ruleX([most], { stroke: "var(--muted)", strokeDasharray: "3 3" }),
              Plot.text([most], {
                x: (d: number) => d,
                text: () => "largest in the model",
                frameAnchor: "bottom",
                textAnchor: "end",
                dx: -5,
                dy: -4,
                fill: "var(--muted)",
              }),
            ],
        Plot.line(
          suction.map((s, i) => [s, curve.values[i] ?? Number.NaN]),
          { stroke: "var(--series-1)", strokeWidth: 1.8, clip: true },
        ),
      ],
    });
  return (
    <Chart
      label={`${name}: ${curve.title.toLowerCase()} over suction`}
      draw={draw}
      depends={[curve, water]}
      stops={suction}
      printWidth={320}
      hint="Point at the curve to read it."
      read={(i) => ({
        text: `s = ${formatQuantity(suction[i], stress.name)}: ${formatQuantity(curve.values[i], curve.unit)}`,
        marks: [{ value: curve.values[i]!, colour: "var(--series-1)" }],
      })}
    />
  );
}

/** Laws of the curves in words, with their parameters. */
function Laws({ water }: { water: SoilWater }) {
  return (
    <p class="chart-note">
      Retention: {water.retention}. Conductivity: {water.conductivity}.{" "}
      {water.parameters.map((p, i) => (
        <span key={p.key}>
          {i > 0 && ", "}
          <SymbolText text={p.symbol} /> = {formatQuantity(p.value, p.unit)}
        </span>
      ))}
    </p>
  );
}

function SoilCharts({ material, water }: { material: MaterialRow; water: SoilWater }) {
  const { stress } = report.value.units;
  const curves = makeCurves(water, report.value.units.speed);
  const columns = () => [
    { name: "suction", unit: stress.name, values: toUnit(water.curves.suction, stress) },
    ...curves.map((c, i) => ({ name: i ? "conductivity" : "saturation", unit: c.unit, values: c.values })),
  ];
  return (
    <figure class="chart-figure" aria-label={`Soil water of ${material.name}`}>
      <div class="chart-head">
        <h4>{material.name}</h4>
        <CsvButton part={`soil_water_${material.name}`} what={`curves of ${material.name}`} columns={columns} />
      </div>
      <Laws water={water} />
      <div class="chart-grid">
        {curves.map((curve) => (
          <CurveChart key={curve.title} name={material.name} curve={curve} water={water} />
        ))}
      </div>
    </figure>
  );
}

function SeriesChart({ condition }: { condition: HydraulicCondition }) {
  const series = condition.series!;
  const span = series.time.at(-1)! - series.time[0]!;
  const unit = chooseTimeUnit(span);
  const time = toUnit(series.time, unit);
  const low = Math.min(0, ...series.values);
  const high = Math.max(...series.values, low + 1e-12);
  const title = `${condition.on}: ${series.title}`;
  const fromZero = condition.condition === "rain" || condition.condition === "flux";
  const domain: [number, number] = fromZero ? [low, high * 1.05] : padded(Math.min(...series.values), high);
  const formatTime = (i: number) => formatQuantity(time[i], unit.name);
  const draw = () =>
    layOut({
      height: 190,
      margins,
      x: { label: titleWithUnit("Time", unit.name), ticks: 6 },
      y: makeAxis({ title, unit: series.unit.name, domain }),
      marks: [
        fromZero
          ? Plot.areaY(
              time.map((t, i) => [t, series.values[i]!]),
              { x: "0", y: "1", fill: "var(--series-1)", fillOpacity: 0.18 },
            )
          : [],
        Plot.line(
          time.map((t, i) => [t, series.values[i]!]),
          { stroke: "var(--series-1)", strokeWidth: 1.8 },
        ),
      ],
    });
  return (
    <Chart
      label={`${title} over time`}
      draw={draw}
      depends={[condition]}
      stops={time}
      printWidth={320}
      hint={`${title}.`}
      read={(i) => ({
        text: `${title} at ${formatTime(i)}: ${writeCondition(condition, series.values[i]!)}`,
        marks: [{ value: series.values[i]!, colour: "var(--series-1)" }],
      })}
    />
  );
}

function padded(low: number, high: number): [number, number] {
  const pad = 0.08 * (high - low) || 1;
  return [low - pad, high + pad];
}

export function SoilWaterSection() {
  const { model, water } = report.value;
  const changing = findChanging(water?.conditions ?? []);
  return (
    <section class="chart-section" aria-labelledby="chart-water-title">
      <h3 id="chart-water-title">Soil water</h3>
      {model.materials.map((m) => m.water && <SoilCharts key={m.name} material={m} water={m.water} />)}
      {changing.length > 0 && (
        <figure class="chart-figure" aria-label="Hydraulic conditions over time">
          <div class="chart-head">
            <h4>Hydraulic conditions over time</h4>
          </div>
          <div class="chart-grid">
            {changing.map((condition, i) => (
              <SeriesChart key={i} condition={condition} />
            ))}
          </div>
        </figure>
      )}
    </section>
  );
}
