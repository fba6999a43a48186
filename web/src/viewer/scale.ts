// SPDX-License-Identifier: MIT
/** The scale of the colours: which value has which place between its ends, and the levels that bands end at; numbers as text. */
import type { Unit } from "../contract";

/** Three significant digits below 1 and four above: "12.35", "0.620", "1.20e−7". */
export function writeNumber(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e6)) return value.toExponential(2).replaceAll("-", "−");
  if (size === 0) return "0";
  return (size >= 1000 ? value.toFixed(0) : value.toPrecision(size < 1 ? 3 : 4)).replace("-", "−");
}

/** "" for a pure number. */
export function writeUnit(unit: Unit): string {
  return unit.name === "-" ? "" : unit.name;
}

/** "Stress xx [kPa]". */
export function writeTitle(title: string, unit: Unit): string {
  return writeUnit(unit) ? `${title} [${unit.name}]` : title;
}

/** Round numbers between two ends, about `count` of them, with texts that distinguish them. */
export function makeTicks(low: number, high: number, count: number): { value: number; text: string }[] {
  const span = high - low;
  if (!(span > 0)) return [{ value: low, text: writeNumber(low) }];
  const rough = span / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= rough * 0.999)!;
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-6); i * step <= high + 1e-6 * span; ++i) {
    const value = i * step;
    const text = digits > 4 || step >= 1e5 ? value.toExponential(1) : (value + 0).toFixed(digits);
    ticks.push({ value, text: text.replace(/^-(?=0(\.0*)?$)/, "").replace("-", "−") });
  }
  return ticks;
}

export interface Scale {
  /** Ends, in any unit. */
  low: number;
  high: number;
  logarithmic: boolean;
}

/** Decades that a logarithmic scale runs over at most when its lower end is 0. */
const decades = 3;

/** A scale between two limits; on a logarithmic one the lower end is moved up from 0. */
export function makeScale(low: number, high: number, logarithmic = false): Scale {
  if (!logarithmic || !(high > 0)) return { low, high: high > low ? high : low + 1e-9, logarithmic: false };
  const lowest = high * 10 ** -decades;
  return { low: low > 0 && low < high ? low : lowest, high, logarithmic: true };
}

/** Share, 0 to 1, of the way from the lower to the upper end; NaN for no value. */
export function findShare(value: number, { low, high, logarithmic }: Scale): number {
  if (Number.isNaN(value)) return NaN;
  const fraction = logarithmic
    ? Math.log(Math.max(value, 1e-30) / low) / Math.log(high / low)
    : (value - low) / (high - low || 1);
  return Math.min(1, Math.max(0, fraction));
}

export interface Level {
  value: number;
  text: string;
}

/** Round values within the scale, about `count` of them; on a logarithmic scale 1, 2 and 5 of each decade, or less. */
export function makeLevels(scale: Scale, count: number): Level[] {
  if (!scale.logarithmic) return makeTicks(scale.low, scale.high, count);
  const [first, last] = [Math.log10(scale.low), Math.log10(scale.high)];
  const mantissas = [[1, 2, 5], [1, 3], [1]].find((some) => some.length * (last - first) <= 1.6 * count) ?? [1];
  const levels: Level[] = [];
  for (let power = Math.floor(first); power <= Math.ceil(last); ++power) {
    for (const mantissa of mantissas) {
      const value = mantissa * 10 ** power;
      if (value < scale.low * 0.999 || value > scale.high * 1.001) continue;
      const plain = value >= 1e-3 && value < 1e5;
      const text = plain ? String(Number(value.toPrecision(3))) : writeNumber(value).replace(/\.00e/, "e");
      levels.push({ value, text });
    }
  }
  return levels;
}

/**
 * A table of 256 colours in bands: each entry has the colour of its band, whose ends are at the fractions `ends`
 * (increasing, within 0 and 1). The bands' colours run evenly over the whole table.
 */
export function bandColours(table: Uint8Array, ends: number[]): Uint8Array {
  const inner = ends.filter((fraction) => fraction > 0.004 && fraction < 0.996);
  const banded = new Uint8Array(table.length);
  for (let i = 0; i < 256; ++i) {
    const band = inner.filter((fraction) => fraction <= (i + 0.5) / 256).length;
    const from = Math.round((255 * band) / Math.max(1, inner.length));
    banded.set(table.subarray(4 * from, 4 * from + 4), 4 * i);
  }
  return banded;
}
