// SPDX-License-Identifier: MIT
/** The rain of a case as bars. */
import type { HydraulicCondition } from "../contract";

export interface RainBar {
  /** [s] */
  from: number;
  to: number;
  /** In the unit of its series. */
  rate: number;
}

/** The strongest rain series between 0 and `duration` [s]; rows that change linearly have their mean. */
export function listRain(conditions: HydraulicCondition[], duration: number): RainBar[] {
  const rains = conditions.filter((c) => c.condition === "rain" && c.series);
  const most = (c: HydraulicCondition) => Math.max(0, ...(c.series?.values ?? []));
  const series = rains.sort((a, b) => most(b) - most(a))[0]?.series;
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
