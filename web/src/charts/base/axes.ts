// SPDX-License-Identifier: MIT
/** Axes and margins of a chart; ticks of a linear axis: how many decimals they need, and which power of ten goes into the axis title. */
import * as Plot from "@observablehq/plot";

import { formatNumber, isPlain, raise } from "./numbers";

export interface AxisText {
  /** Text of a tick. */
  format: (value: number) => string;
  /** Goes in front of the unit: "10⁻³", or nothing. */
  power: string;
}

/** Distance of the ticks that d3 (and so Plot) chooses for about `count` of them between `low` and `high`. */
export function findStep(low: number, high: number, count: number): number {
  const raw = (high - low) / Math.max(1, count);
  if (!(raw > 0)) return 0;
  const power = 10 ** Math.floor(Math.log10(raw));
  const error = raw / power;
  const factor = error >= Math.sqrt(50) ? 10 : error >= Math.sqrt(10) ? 5 : error >= Math.sqrt(2) ? 2 : 1;
  return factor * power;
}

/**
 * All ticks with the same decimals; numbers below 0.01 or from 1e5 on have a common power of ten (a multiple of three), but
 * where they differ by little, as coordinates of a map do: a power would hide their difference.
 */
export function describeAxis(low: number, high: number, count: number): AxisText {
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const tenth = largest > 0 ? Math.log10(largest) : 0;
  const isFar = tenth >= 5 && high - low < largest / 100;
  const exponent = !isFar && (tenth < -2 || tenth >= 5) ? 3 * Math.floor(tenth / 3) : 0;
  const step = findStep(low, high, count) / 10 ** exponent;
  const decimals = step > 0 ? Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) : 0;
  return {
    // Adding zero turns -0 into 0.
    format: (value) => (Number((value / 10 ** exponent).toFixed(decimals)) + 0).toFixed(decimals).replace("-", "−"),
    power: exponent ? `10${raise(exponent)}` : "",
  };
}

/** "Strain [10⁻³]", "Stress [10³ kPa]". */
function titleWithPower(title: string, unit: string, power: string): string {
  const inside = [power, isPlain(unit) ? "" : unit].filter(Boolean).join(" ");
  return inside ? `${title} [${inside}]` : title;
}

/** Ticks of a logarithmic axis: powers of ten, at most about `count`; 1, 2 and 5 times them when there are few. */
export function findLogTicks([low, high]: readonly [number, number], count: number): number[] {
  if (!(low > 0) || !(high > low)) return [];
  const first = Math.ceil(Math.log10(low) - 1e-9);
  const last = Math.floor(Math.log10(high) + 1e-9);
  const ticks: number[] = [];
  if (last - first >= 2) {
    const stride = Math.ceil((last - first + 1) / count);
    for (let k = first; k <= last; ++k) if ((last - k) % stride === 0) ticks.push(10 ** k);
  } else {
    for (let k = first - 1; k <= last; ++k)
      for (const m of [1, 2, 5]) if (m * 10 ** k >= low && m * 10 ** k <= high) ticks.push(m * 10 ** k);
  }
  return ticks;
}

/** Text of a tick of a logarithmic axis: powers of ten far from one as such. */
export function formatLogTick(value: number): string {
  const exponent = Math.log10(value);
  const whole = Math.round(exponent);
  if (Math.abs(exponent - whole) < 1e-6 && (whole < -2 || whole > 4)) return `10${raise(whole)}`;
  return formatNumber(value, 2);
}

interface AxisProps {
  title: string;
  unit?: string;
  domain: readonly [number, number];
  log?: boolean;
  /** About how many ticks. */
  count?: number;
  inset?: number;
}

/** An axis of values: ticks of a linear one share the decimals and a power of ten, which is in the title. */
export function makeAxis({ title, unit = "", domain, log = false, count = 5, inset }: AxisProps) {
  const text = describeAxis(domain[0], domain[1], count);
  return {
    type: log ? ("log" as const) : ("linear" as const),
    domain,
    label: titleWithPower(title, unit, log ? "" : text.power),
    ticks: log ? findLogTicks(domain, count) : count,
    tickFormat: log ? formatLogTick : text.format,
    inset,
  };
}

interface Layout {
  height: number;
  /** [px] above, right, below, left. */
  margins: [number, number, number, number];
  x: Plot.ScaleOptions;
  y: Plot.ScaleOptions;
  marks: Plot.Markish[];
  /** Axis whose ticks have lines across the chart. */
  grid?: "x" | "y" | "none";
}

/** Options of a chart as all have them: the title of the abscissa in the middle below its ticks, colours as they are given. */
export function layOut({ height, margins, x, y, marks, grid = "y" }: Layout): Plot.PlotOptions {
  const [marginTop, marginRight, marginBottom, marginLeft] = margins;
  const line = { stroke: "var(--line)", strokeOpacity: 1 };
  return {
    height,
    marginTop,
    marginRight,
    marginBottom,
    marginLeft,
    x: { labelAnchor: "center", labelArrow: "none", labelOffset: 36, ...x },
    y: { labelArrow: "none", ...y },
    symbol: { type: "identity" },
    color: { type: "identity" },
    marks: [
      grid === "y" ? Plot.gridY({ ticks: y.ticks, ...line }) : [],
      grid === "x" ? Plot.gridX({ ticks: x.ticks, ...line }) : [],
      marks,
    ],
  };
}
