// SPDX-License-Identifier: MIT
/** Typical values of soils with their source, and the user's own entries. */
export interface LibraryEntry {
  /** Symbol of the unified soil classification, or the name of an own entry. */
  symbol: string;
  name: string;
  /** Ranges in the units of the case file. */
  ranges: Record<string, readonly [number, number]>;
  note: string;
}

export const source =
  "NAVFAC DM-7.02 (1986), Foundations and Earth Structures, table 1, typical properties of compacted soils (standard Proctor); converted from pcf and psf";

const poundsPerCubicFoot = 0.157087;
const poundsPerSquareFoot = 0.0478803;

/** Maximum dry unit weight [pcf], optimum water content [%], saturated cohesion [psf], friction angle of effective stress [deg]. */
type Row = readonly [symbol: string, name: string, dry: readonly [number, number], water: readonly [number, number], cohesion: number | null, friction: number, above?: true];

const rows: readonly Row[] = [
  ["GW", "Well-graded gravel", [125, 135], [8, 11], 0, 38, true],
  ["GP", "Poorly graded gravel", [115, 125], [11, 14], 0, 37, true],
  ["GM", "Silty gravel", [120, 135], [8, 12], null, 34, true],
  ["GC", "Clayey gravel", [115, 130], [9, 14], null, 31, true],
  ["SW", "Well-graded sand", [110, 130], [9, 16], 0, 38],
  ["SP", "Poorly graded sand", [100, 120], [12, 21], 0, 37],
  ["SM", "Silty sand", [110, 125], [11, 16], 420, 34],
  ["SC", "Clayey sand", [105, 125], [11, 19], 230, 31],
  ["ML", "Silt", [95, 120], [12, 24], 190, 32],
  ["CL", "Clay of low plasticity", [95, 120], [12, 24], 270, 28],
  ["MH", "Elastic silt", [70, 95], [24, 40], 420, 25],
  ["CH", "Clay of high plasticity", [75, 105], [19, 36], 230, 19],
];

const round = (value: number, digits: number) => Number(value.toFixed(digits));

function readRow([symbol, name, dry, water, cohesion, friction, above]: Row): LibraryEntry {
  // Moist weight at the optimum: the heavier soil has the smaller water content.
  const weight = [dry[0] * (1 + water[1] / 100), dry[1] * (1 + water[0] / 100)].map((w) => round(w * poundsPerCubicFoot, 1));
  const ranges: Record<string, readonly [number, number]> = {
    unit_weight: [Math.min(...weight), Math.max(...weight)],
    friction_angle: [friction, friction],
  };
  if (cohesion !== null) {
    const c = round(cohesion * poundsPerSquareFoot, 1);
    ranges.cohesion = [c, c];
  }
  return { symbol, name, ranges, note: above ? `φ' is above ${friction}°` : "" };
}

export const entries: readonly LibraryEntry[] = rows.map(readRow);

const stored = "talus-studio-library";

/** The user's own entries, in this browser. */
export function readOwn(): LibraryEntry[] {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(stored) ?? "[]");
    return Array.isArray(found) ? (found as LibraryEntry[]).filter((entry) => typeof entry?.symbol === "string" && typeof entry.ranges === "object") : [];
  } catch {
    return [];
  }
}

export function writeOwn(own: readonly LibraryEntry[]): void {
  try {
    localStorage.setItem(stored, JSON.stringify(own));
  } catch {
    // Without storage own entries last as long as the page.
  }
}
