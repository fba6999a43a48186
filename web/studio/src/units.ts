// SPDX-License-Identifier: MIT
/** Units of display: SI, or those of practice in the United States. The text of the case keeps the units in which it is written. */
import { computed, signal } from "@preact/signals";

export type UnitSystem = "si" | "us";
export const system = signal<UnitSystem>("si");

interface Shown {
  /** As the case file writes it. */
  name: string;
  /** In the unit of plain numbers of the case file. */
  size: number;
}

const foot = 0.3048;
/** [kN] */
const poundForce = 4.4482216152605e-3;

/** Units by those of plain numbers in the case file. */
const american: Record<string, Shown> = {
  m: { name: "ft", size: foot },
  mm: { name: "in", size: 25.4 },
  m2: { name: "ft2", size: foot ** 2 },
  kPa: { name: "psf", size: poundForce / foot ** 2 },
  MPa: { name: "psi", size: (poundForce / 0.0254 ** 2) * 1e-3 },
  "kN/m3": { name: "pcf", size: poundForce / foot ** 3 },
  "kg/m3": { name: "lb/ft3", size: 0.45359237 / foot ** 3 },
  kN: { name: "lbf", size: poundForce },
  "kN/m": { name: "lbf/ft", size: poundForce / foot },
  "kN.m": { name: "lbf.ft", size: poundForce * foot },
  "mm/h": { name: "in/h", size: 25.4 },
  "mm/day": { name: "in/day", size: 25.4 },
  "m/s": { name: "ft/s", size: foot },
};

/** Lengths of the canvas: name and size [m]. */
export const length = computed<Shown>(() => (system.value === "us" ? american.m! : { name: "m", size: 1 }));
export const stress = computed<Shown>(() => (system.value === "us" ? american.kPa! : { name: "kPa", size: 1 }));

/** The unit in which values of a unit of the case file are shown; null where it is the same. */
export const findShown = (unit: string): Shown | null => (system.value === "us" ? (american[unit] ?? null) : null);

/** At most six digits, without an exponent where one is not needed. */
export const formatShown = (value: number): string => String(Number(value.toPrecision(6)));
export const toShownLength = (metres: number): number => metres / length.value.size;
export const fromShownLength = (shown: number): number => shown * length.value.size;
/** A length with its unit: "12.5 m", "41.01 ft". */
export const writeLengthShown = (metres: number, digits = 2): string => `${toShownLength(metres).toFixed(digits)} ${length.value.name}`;

/** Sizes of units that texts of a quantity may have, in the unit of plain numbers. */
const known: Record<string, Record<string, number>> = {
  m: { m: 1, cm: 0.01, mm: 0.001, km: 1000, ft: foot, in: 0.0254, yd: 0.9144 },
  mm: { mm: 1, cm: 10, m: 1000, in: 25.4, ft: 304.8 },
  kPa: { Pa: 1e-3, kPa: 1, MPa: 1e3, GPa: 1e6, "kN/m2": 1, psf: american.kPa!.size, ksf: 1e3 * american.kPa!.size, psi: 1e3 * american.MPa!.size, tsf: 2e3 * american.kPa!.size },
  "kN/m3": { "kN/m3": 1, "N/m3": 1e-3, pcf: american["kN/m3"]!.size },
  deg: { deg: 1, rad: 180 / Math.PI },
};

/** Splits "500 psf" for a quantity whose plain numbers have `unit`: the value in that unit, and what the text has. */
export function readQuantity(text: string, unit: string): { value: number; name: string; size: number } | null {
  const parts = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([A-Za-z][\w./^-]*)\s*$/.exec(text);
  const size = parts ? (known[unit]?.[parts[2]!] ?? (american[unit]?.name === parts[2] ? american[unit]!.size : undefined)) : undefined;
  return parts && size !== undefined ? { value: Number(parts[1]) * size, name: parts[2]!, size } : null;
}

/** The value of a quantity as it is shown, with its unit of display: of a plain number, or of a text with a known unit. */
export function showQuantity(value: string | number | boolean, unit: string): { text: string; converted: boolean } {
  const shown = findShown(unit);
  if (!shown) return { text: String(value), converted: false };
  const plain = typeof value === "number" ? value : readQuantity(String(value), unit)?.value;
  return plain === undefined || typeof value === "boolean" ? { text: String(value), converted: false } : { text: formatShown(plain / shown.size), converted: true };
}

/**
 * Converts a typed number in the unit of display into the text of the file: in the unit in which the value was written before; with
 * the unit of display where there was none, or a plain number where texts are not allowed.
 */
export function writeQuantity(typed: string, unit: string, before: string | number | boolean | null, takesText: boolean): string {
  const shown = findShown(unit);
  const number = Number(typed.replace("−", "-"));
  if (!shown || typed.trim() === "" || Number.isNaN(number)) return typed;
  const plain = number * shown.size;
  const written = typeof before === "string" ? readQuantity(before, unit) : null;
  if (written) return `${Number((plain / written.size).toPrecision(10))} ${written.name}`;
  if (before === null && takesText) return `${number} ${shown.name}`;
  return String(Number(plain.toPrecision(10)));
}

/** Ranges such as "10 to 28 kN/m3" in the unit of display. */
export function showRange(text: string, unit: string): string {
  const shown = findShown(unit);
  const clean = (written: string) => written.replace("kN/m3", "kN/m³").replace(/ deg\b/, "°");
  // "0.01 to 500 kPa, or 0": the numbers before the unit.
  const at = text.indexOf(` ${unit}`);
  if (!shown || at < 0) return clean(text);
  const body = text.slice(0, at).replace(/[+-]?\d+\.?\d*(?:e[+-]?\d+)?/g, (number) => String(Number((Number(number) / shown.size).toPrecision(3))));
  return `${body} ${shown.name}${text.slice(at + 1 + unit.length)}`;
}
