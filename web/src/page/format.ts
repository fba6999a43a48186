// SPDX-License-Identifier: MIT
/** Writes numbers as engineers read them: few digits, real minus signs, SI names. */
import { raise } from "../charts/base/numbers";
import type { HydraulicCondition, Unit } from "../contract";
import { report } from "../state";

/** 12345.6 → "12 345.6" with narrow spaces that do not break; four digits stay together. */
function groupDigits(text: string): string {
  const [whole = "", fraction] = text.split(".");
  const digits = whole.replace("-", "");
  const grouped = digits.length > 4 ? digits.replace(/\B(?=(\d{3})+$)/g, "\u202f") : digits;
  return (whole.startsWith("-") ? "−" : "") + grouped + (fraction === undefined ? "" : `.${fraction}`);
}

/**
 * A number with `digits` significant ones; whole numbers below a million stay whole. No number: a dash.
 * `keepZeros` keeps the precision of a result: 2.80 and not 2.8.
 */
export function formatNumber(value: number | null | undefined, digits = 4, keepZeros = false): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  if (Number.isInteger(value) && Math.abs(value) < 1e6) return groupDigits(String(value));
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e7) {
    const [mantissa = "", exponent = ""] = value.toExponential(digits - 1).split("e");
    return `${groupDigits(String(Number(mantissa)))} × 10${raise(Number(exponent))}`;
  }
  // Digits before the point are never rounded away: 123 456.7 is not 123 500.
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  const text = value.toFixed(decimals);
  return groupDigits(decimals > 0 && !keepZeros ? text.replace(/\.?0+$/, "") : text);
}

/** The ends of an interval as printed with three decimals. Rounding is outward, so that the printed interval also holds. */
export const roundDown = (lower: number | null) => (lower === null ? null : Math.floor(1e3 * lower) / 1e3);
export const roundUp = (upper: number | null) => (upper === null ? null : Math.ceil(1e3 * upper) / 1e3);

/** A factor of safety: three decimals, always; `none` where there is none. */
export function formatFactor(value: number | null | undefined, none = "–"): string {
  return value === null || value === undefined ? none : value.toFixed(3).replace("-", "−");
}

/** Both ends of an interval, or the one that there is: "1.379 – 1.409", "≤ 1.114". */
export function formatInterval({ lower, upper }: { lower: number | null; upper: number | null }): string {
  if (lower === null) return upper === null ? "–" : `≤ ${formatFactor(upper)}`;
  return upper === null ? `≥ ${formatFactor(lower)}` : `${formatFactor(lower)} – ${formatFactor(upper)}`;
}

/** The name of a unit as it follows a number; quantities without one show nothing. */
export function formatUnit(name: string): string {
  const shown =
    name === "-" || name === "1" ? "" : name.replace(/m2\b/, "m²").replace(/m3\b/, "m³").replace(/s2\b/, "s²");
  return shown === "deg" ? "°" : shown;
}

/** A value in SI, in its unit: "5.454 m". */
export function formatQuantity(value: number | null | undefined, unit: Unit, digits = 4, keepZeros = false): string {
  const number = formatNumber(value === null || value === undefined ? value : value / unit.si, digits, keepZeros);
  const name = formatUnit(unit.name);
  return number === "–" || !name ? number : name === "°" ? `${number}°` : `${number}\u00a0${name}`;
}

/** A value that is in its unit already: "5.454 m", "32°". */
export const formatValue = (value: number, unit: string, digits = 4): string =>
  formatQuantity(value, { name: unit, si: 1 }, digits);

/** Duration in usual units: "16.9 s", "4 min 05 s", "2 h 10 min". */
export function formatDuration(seconds: number): string {
  if (seconds < 120) return `${formatNumber(seconds, 3)}\u00a0s`;
  const whole = Math.round(seconds);
  const pad = (n: number) => String(n).padStart(2, "0");
  if (whole < 7200) return `${Math.floor(whole / 60)}\u00a0min ${pad(whole % 60)}\u00a0s`;
  return `${Math.floor(whole / 3600)}\u00a0h ${pad(Math.floor((whole % 3600) / 60))}\u00a0min`;
}

/** ISO 8601 → "20 November 2026, 07:47 UTC"; a text that is no date stays as it is. */
export function formatDate(iso: string): string {
  const date = new Date(iso);
  if (!iso || Number.isNaN(date.getTime())) return iso || "–";
  const day = date.toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric", timeZone: "UTC" });
  return iso.includes("T") ? `${day}, ${date.toISOString().slice(11, 16)} UTC` : day;
}

/** "3 warnings", "1 warning". */
export function formatCount(count: number, one: string, many = `${one}s`): string {
  return `${formatNumber(count)} ${count === 1 ? one : many}`;
}

/** A sentence of the results starts with a capital and ends with a full stop. */
export function formatSentence(text: string): string {
  const trimmed = text.trim();
  if (!trimmed) return "";
  // Symbols stay as they are: "λ = 0.45".
  return trimmed.replace(/^[a-z](?=[a-z\s])/, (first) => first.toUpperCase()) + (/[.!?]$/.test(trimmed) ? "" : ".");
}

/** "It fails at 8 h. It is least at 16 h." → both sentences. A full stop between digits or after a symbol ends none. */
export function splitSentences(text: string): string[] {
  return formatSentence(text)
    .split(/(?<=[\p{L}\p{N})%'][.!?])\s+(?=\p{Lu}\p{L}+[ ,])/u)
    .map(formatSentence);
}

/** A relative difference: "+1.6 %", "±0.0 %". */
export function formatDifference(share: number): string {
  const size = Math.abs(100 * share).toFixed(1);
  return `${Number(size) === 0 ? "±" : share > 0 ? "+" : "−"}${size}\u00a0%`;
}

/** A coordinate [m] in the unit of lengths: with decimals for a ten-thousandth of the model, whatever its origin. */
export function formatCoordinate(value: number): string {
  const { model, units } = report.value;
  const { si } = units.length;
  const size = Math.max(...model.bounds[1].map((high, k) => high - model.bounds[0][k]!)) / si || 1;
  const text = (value / si).toFixed(Math.min(6, Math.max(0, 4 - Math.floor(Math.log10(size)))));
  return groupDigits(text.includes(".") ? text.replace(/\.?0+$/, "") : text).replace(/^−0$/, "0");
}

/** [x, y] [m] → "(12, 15) m". */
export function formatPlace(place: readonly number[]): string {
  return `(${place.map(formatCoordinate).join(", ")})\u00a0${report.value.units.length.name}`;
}

/** The value of a hydraulic condition in its unit, "2 mm/h"; a head is a level, and has all digits of a coordinate. */
export function writeCondition({ condition, series }: HydraulicCondition, value: number): string {
  if (!series) return "";
  const { name, si } = series.unit;
  return condition === "total_head" ? `${formatCoordinate(value * si)}\u00a0${name}` : formatQuantity(value, { name, si: 1 });
}
