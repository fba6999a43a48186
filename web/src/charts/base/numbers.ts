// SPDX-License-Identifier: MIT
/** Numbers for people: few digits, a true minus sign, powers of ten; and factors that keep axes readable. */

/** "⁻³". */
export const raise = (exponent: number) =>
  [...String(exponent)].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)]!)).join("");

/** `value` with `digits` significant digits: "1.593", "−392", "3.6×10⁻¹⁵"; "–" where there is none. */
export function formatNumber(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const sign = value < 0 ? "−" : "";
  if (size < 1e-3 || size >= 1e6) {
    const [mantissa, exponent] = size.toExponential(Math.min(digits, 3) - 1).split("e");
    return `${sign}${Number(mantissa)}×10${raise(Number(exponent))}`;
  }
  return sign + String(Number(size.toPrecision(size >= 10 ** digits ? Math.ceil(Math.log10(size + 1)) : digits)));
}

/** "82.9 mm"; a plain number where the unit is "-" or empty. */
export function formatQuantity(value: number | null | undefined, unit: string, digits = 4): string {
  const text = formatNumber(value, digits);
  return text === "–" || isPlain(unit) ? text : `${text} ${unit}`;
}

export function isPlain(unit: string): boolean {
  return unit === "" || unit === "-" || unit === "–";
}

/** Axis title as in papers: "Displacement [mm]". */
export function titleWithUnit(title: string, unit: string): string {
  return isPlain(unit) ? title : `${title} [${unit}]`;
}

/** Joules become kJ, MJ, … if the largest value is large; other units stay. Value shown = value × `factor`. */
export function scaleUnit(unit: string, largest: number): { unit: string; factor: number } {
  if (unit !== "J") return { unit, factor: 1 };
  if (largest >= 1e9) return { unit: "GJ", factor: 1e-9 };
  if (largest >= 1e6) return { unit: "MJ", factor: 1e-6 };
  if (largest >= 1e3) return { unit: "kJ", factor: 1e-3 };
  return { unit, factor: 1 };
}

/** Largest magnitude of the values that exist; 0 of none. */
export function findLargest(values: Iterable<number | null>): number {
  let largest = 0;
  for (const v of values) if (v !== null && Number.isFinite(v)) largest = Math.max(largest, Math.abs(v));
  return largest;
}
