// SPDX-License-Identifier: MIT
/** Stages of construction as curves in time: settlement, excess pore pressure, and the factors at the ends of the stages. */
import type { ShownResult, Unit } from "../contract";
import type { Construction, ConstructionSupport } from "../contract/results";

/** The unit of a time axis: hours, days or years, so that its numbers have few digits. */
export function chooseTimeUnit(duration: number): Unit {
  if (duration > 3 * 365.25 * 86400) return { name: "year", si: 365.25 * 86400 };
  return duration > 2 * 86400 ? { name: "day", si: 86400 } : { name: "h", si: 3600 };
}

export interface StepPoint {
  time: number;
  settlement: number;
  heave: number;
  lateral: number;
  excess: number;
  /** Zero or negative; absent without pore water. */
  least_excess?: number;
}

/** The largest excess pore pressure or, of a cut, the least one, whichever is further from zero [Pa]. */
export function findFurthestExcess(step?: Pick<StepPoint, "excess" | "least_excess">): number | undefined {
  if (!step) return undefined;
  const least = step.least_excess ?? 0;
  return -least > step.excess ? least : step.excess;
}

/** All steps in order of time, from the start without movement on [s, m, Pa]. */
export function listSteps({ stages }: Construction): StepPoint[] {
  const first = { time: stages[0]?.from ?? 0, settlement: 0, heave: 0, lateral: 0, excess: 0 };
  return [first, ...stages.flatMap(({ steps }) => steps)];
}

export interface FactorPoint {
  time: number;
  stage: string;
  /** With "_undrained" for a failure without drainage. */
  method: string;
  title: string;
  factor: number;
}

/** The factors at the ends of the stages. */
export const listFactors = ({ stages }: Construction): FactorPoint[] =>
  stages.flatMap(({ name, to, factors }) =>
    factors.flatMap(({ method, title, factor, undrained }) =>
      factor === null ? [] : [{ time: to, stage: name, method: undrained ? `${method}_undrained` : method, title, factor }],
    ),
  );

/** Keeps the result of each quantity at the ends of stages that is furthest from zero, and all other results. */
export function keepFurthestOfStages(results: ShownResult[]): ShownResult[] {
  const ofStage = ({ name }: ShownResult) => name.startsWith("construction[");
  const furthest = new Map<string, ShownResult>();
  for (const result of results.filter(ofStage)) {
    const known = furthest.get(result.quantity);
    if (!known || Math.abs(result.value ?? 0) > Math.abs(known.value ?? 0)) furthest.set(result.quantity, result);
  }
  return results.filter((result) => !ofStage(result) || furthest.get(result.quantity) === result);
}

export interface SupportCurves {
  name: string;
  /** Distances from the head [m]. */
  at: number[];
  /** One for each stage that has the support, in SI. */
  curves: { title: string; values: number[] }[];
}

type Along = (support: ConstructionSupport) => { place: (number | null)[]; value: (number | null)[] };

/** Interpolates linearly between places that increase, constant beyond them. */
function interpolate(place: number[], value: number[], x: number): number {
  const after = place.findIndex((p) => p >= x);
  if (after <= 0) return value.at(after)!;
  const share = (x - place[after - 1]!) / (place[after]! - place[after - 1]!);
  return value[after - 1]! + share * (value[after]! - value[after - 1]!);
}

/** A quantity along each support at the ends of the stages, at the places of the last stage; supports without it are left out. */
export function listAlongSupports({ stages }: Construction, find: Along): SupportCurves[] {
  const found = new Map<string, SupportCurves>();
  const rows = stages.flatMap(({ supports }) => supports);
  for (const stage of [...stages].reverse())
    for (const support of stage.supports) {
      const { place, value } = find(support);
      if (value.length === 0) continue;
      const isOneOfRows = rows.some((r) => r.support === support.support && r.row !== support.row);
      const name = isOneOfRows ? `${support.support}, row ${support.row}` : support.support;
      const at = place.map((x) => x ?? 0);
      const values = value.map((v) => v ?? 0);
      const known = found.get(name) ?? { name, at, curves: [] };
      known.curves.unshift({ title: stage.name, values: known.at.map((x) => interpolate(at, values, x)) });
      found.set(name, known);
    }
  return [...found.values()];
}
