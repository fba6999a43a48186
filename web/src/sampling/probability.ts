// SPDX-License-Identifier: MIT
/** Probabilities and sampled numbers as text, and the curves that are laid over a histogram. */
import { formatNumber } from "../charts/base/numbers";
import { formatUnit } from "../page/format";

/** "2.4 %", "0.031 %", "3.2×10⁻⁶"; "0" for none. */
export function formatShare(share: number | null): string {
  if (share === null || !Number.isFinite(share)) return "–";
  if (share === 0) return "0";
  return share < 1e-5 ? formatNumber(share, 2) : `${formatNumber(100 * share, share > 0.1 ? 3 : 2)} %`;
}

/** Density of the normal and of the lognormal distribution with a mean and a deviation, at x. */
export function findDensity(kind: "normal" | "lognormal", mean: number, deviation: number, x: number): number {
  if (!(deviation > 0)) return 0;
  if (kind === "normal") return Math.exp(-0.5 * ((x - mean) / deviation) ** 2) / (deviation * Math.sqrt(2 * Math.PI));
  if (!(x > 0) || !(mean > 0)) return 0;
  const variance = Math.log1p((deviation / mean) ** 2);
  const middle = Math.log(mean) - variance / 2;
  return Math.exp((-0.5 * (Math.log(x) - middle) ** 2) / variance) / (x * Math.sqrt(2 * Math.PI * variance));
}

/** "friction_angle" → "friction angle". */
export const showName = (name: string) => name.replaceAll("_", " ");

/** "27.61°", "18.54 kN/m³". */
export function showValue(value: number | null, unit: string): string {
  const shown = formatUnit(unit);
  const number = formatNumber(value, 4);
  return shown === "°" ? `${number}°` : shown ? `${number} ${shown}` : number;
}
