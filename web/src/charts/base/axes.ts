// SPDX-License-Identifier: MIT
/** Ticks of a linear axis: how many decimals they need, and which power of ten goes into the axis title. */
import { formatNumber, isPlain } from "./numbers";

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
  const factor =
    error >= Math.sqrt(50) ? 10
    : error >= Math.sqrt(10) ? 5
    : error >= Math.sqrt(2) ? 2
    : 1;
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
    power: exponent ? formatPower(exponent) : "",
  };
}

/** "10⁻³". */
export function formatPower(exponent: number): string {
  return `10${[...String(exponent)].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)]!)).join("")}`;
}

/** "Strain [10⁻³]", "Stress [10³ kPa]". */
export function titleWithPower(title: string, unit: string, power: string): string {
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
  if (Math.abs(exponent - whole) < 1e-6 && (whole < -2 || whole > 4)) return formatPower(whole);
  return formatNumber(value, 2);
}

/** The title of an abscissa is in the middle below its ticks. */
export const centred = { labelAnchor: "center", labelArrow: "none", labelOffset: 36 } as const;
