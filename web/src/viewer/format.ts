// SPDX-License-Identifier: MIT
/** Numbers and units as text. */
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
