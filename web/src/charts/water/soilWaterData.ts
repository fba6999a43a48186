// SPDX-License-Identifier: MIT
/** Numbers of the charts of soil water: curves in the units of the report, and the range of the model on them. */
import type { HydraulicCondition, SoilWater, Unit } from "../../contract";

export interface SoilWaterCurve {
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

export const toUnit = (values: readonly number[], unit: Unit): number[] => values.map((v) => v / unit.si);

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
