// SPDX-License-Identifier: MIT
/** The rain of a case as bars, and the levels that change with time. */
import type { HydraulicCondition } from "../contract";
import { evaluateSeries } from "../viewer/symbols";

export interface RainBar {
  /** [s] */
  from: number;
  to: number;
  /** In the unit of its series. */
  rate: number;
}

/** The strongest rain series. */
export function findRain(conditions: HydraulicCondition[]): HydraulicCondition["series"] {
  const rains = conditions.filter((c) => c.condition === "rain" && c.series);
  const most = (c: HydraulicCondition) => Math.max(0, ...(c.series?.values ?? []));
  return rains.sort((a, b) => most(b) - most(a))[0]?.series;
}

/** The rain series between 0 and `duration` [s]; rows that change linearly have their mean. */
export function listRain(conditions: HydraulicCondition[], duration: number): RainBar[] {
  const series = findRain(conditions);
  if (!series) return [];
  const { time, values } = series;
  const bars: RainBar[] = [];
  const add = (from: number, to: number, rate: number) => {
    const [a, b] = [Math.max(0, from), Math.min(duration, to)];
    if (b > a && rate > 0) bars.push({ from: a, to: b, rate });
  };
  if (time.length > 0) add(0, time[0]!, values[0]!);
  for (let i = 1; i < time.length; ++i) add(time[i - 1]!, time[i]!, (values[i - 1]! + values[i]!) / 2);
  if (time.length > 0) add(time.at(-1)!, duration, values.at(-1)!);
  return bars;
}

export interface LevelLine {
  on: string;
  unit: string;
  /** Time [s] and level, from 0 to the duration; a jump has two points at one time. */
  points: [number, number][];
}

/** The total heads that change between 0 and `duration` [s]. */
export function listLevels(conditions: HydraulicCondition[], duration: number): LevelLine[] {
  return conditions.flatMap(({ condition, on, series }) => {
    if (condition !== "total_head" || !series || series.time.length === 0) return [];
    const { time, values } = series;
    const at = (t: number) => evaluateSeries({ series }, t);
    const inside = time.flatMap((t, i): [number, number][] => (t >= 0 && t <= duration ? [[t, values[i]!]] : []));
    const before: [number, number] = [0, inside.length && inside[0]![0] === 0 ? inside[0]![1] : at(0)];
    const points: [number, number][] = [before, ...inside, [duration, at(duration)]];
    return new Set(points.map(([, level]) => level)).size > 1 ? [{ on, unit: series.unit.name, points }] : [];
  });
}
