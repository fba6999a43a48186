// SPDX-License-Identifier: MIT
/** Names and units of sampled numbers as they are read. */
import { formatUnit } from "../page/format";
import { formatNumber } from "../charts/base/numbers";

/** "friction_angle" → "friction angle". */
export const showName = (name: string) => name.replaceAll("_", " ");

/** "27.61°", "18.54 kN/m³". */
export function showValue(value: number | null, unit: string): string {
  const shown = formatUnit(unit);
  const number = formatNumber(value, 4);
  return shown === "°" ? `${number}°` : shown ? `${number} ${shown}` : number;
}
