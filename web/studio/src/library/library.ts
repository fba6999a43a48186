// SPDX-License-Identifier: MIT
/** Typical values of soils with their source, and the user's own entries. */
import { effect, signal } from "@preact/signals";

import { setting } from "../session";
import * as state from "../state";

export interface LibraryEntry {
  /** Symbol of the unified soil classification, or the name of an own entry. */
  symbol: string;
  name: string;
  /** Ranges in the units of the case file. */
  ranges: Record<string, readonly [number, number]>;
  note: string;
  /** Constitutive law; of own entries only. */
  model?: string;
}

export const source =
  "U.S. Bureau of Reclamation, average effective shear strength of compacted soils (standard Proctor), as in Huang (1983), Stability analysis of earth slopes, table 3.1; ± are its 90 % limits, converted from pcf and tsf. Strengths were read in a copy; unit weights are remembered, as the copy is illegible there";

const poundsPerCubicFoot = 0.157087;
const tonsPerSquareFoot = 95.7605;

type Mean = readonly [mean: number, plusMinus: number];
/** Dry unit weight [pcf], optimum water content [%], saturated cohesion [tsf], friction angle [deg]; null: not in the table. */
type Row = readonly [symbol: string, name: string, dry: Mean, water: Mean, cohesion: Mean | null, friction: Mean];
/** Lower limits only: of clean and silty gravels. */
const above: readonly (readonly [symbol: string, name: string, friction: number])[] = [
  ["GW", "Well-graded gravel", 38],
  ["GP", "Poorly graded gravel", 37],
  ["GM", "Silty gravel", 34],
  ["GC", "Clayey gravel", 31],
];

const rows: readonly Row[] = [
  ["SW", "Well-graded sand", [119, 5], [13.3, 2.5], null, [38, 1]],
  ["SP", "Poorly graded sand", [110, 2], [12.4, 1.0], null, [37, 1]],
  ["SM", "Silty sand", [114, 1], [14.5, 0.4], [0.21, 0.07], [34, 1]],
  ["SC", "Clayey sand", [115, 1], [14.7, 0.4], [0.12, 0.06], [31, 3]],
  ["ML", "Silt of low plasticity", [103, 1], [19.2, 0.7], [0.09, 0], [32, 2]],
  ["CL", "Clay of low plasticity", [108, 1], [17.3, 0.3], [0.14, 0.02], [28, 2]],
  ["MH", "Silt of high plasticity", [82, 4], [36.3, 3.2], [0.21, 0.09], [25, 3]],
  ["CH", "Clay of high plasticity", [94, 2], [25.5, 1.2], [0.12, 0.06], [19, 5]],
];

const round = (value: number) => Number(value.toFixed(1));
const limits = ([mean, plusMinus]: Mean, unit: number): [number, number] => [round((mean - plusMinus) * unit), round((mean + plusMinus) * unit)];

function readRow([symbol, name, dry, water, cohesion, friction]: Row): LibraryEntry {
  // Moist weight at the optimum.
  const weight = (sign: -1 | 1) => round((dry[0] + sign * dry[1]) * (1 + (water[0] + sign * water[1]) / 100) * poundsPerCubicFoot);
  const ranges: Record<string, readonly [number, number]> = { unit_weight: [weight(-1), weight(1)], friction_angle: limits(friction, 1) };
  if (cohesion) ranges.cohesion = limits(cohesion, tonsPerSquareFoot);
  return { symbol, name, ranges, note: cohesion ? "c' of the saturated soil" : "" };
}

export const entries: readonly LibraryEntry[] = [
  ...above.map(([symbol, name, friction]) => ({ symbol, name, ranges: { friction_angle: [friction, friction] as const }, note: `φ' is above ${friction}°` })),
  ...rows.map(readRow),
];

const browserKey = "talus-studio-library";

/** The user's own entries. */
export const own = signal<readonly LibraryEntry[]>([]);

const isRange = (range: unknown): range is [number, number] => Array.isArray(range) && range.length === 2 && range.every((value) => Number.isFinite(value));

/** Entries of a JSON text or value; what is none is left out. */
export function readEntries(found: unknown): LibraryEntry[] {
  if (!Array.isArray(found)) return [];
  return found.flatMap((entry: Partial<LibraryEntry> | null) => {
    if (typeof entry?.symbol !== "string" || entry.symbol === "" || typeof entry.ranges !== "object" || entry.ranges === null) return [];
    const ranges = Object.fromEntries(Object.entries(entry.ranges).filter(([, range]) => isRange(range)));
    const model = typeof entry.model === "string" && entry.model ? { model: entry.model } : {};
    return [{ symbol: entry.symbol, name: "own entry", ranges, note: typeof entry.note === "string" ? entry.note : "", ...model }];
  });
}

/** Own entries by their names; those of `more` replace others of the same name. */
export const mergeEntries = (known: readonly LibraryEntry[], more: readonly LibraryEntry[]): LibraryEntry[] => [
  ...known.filter(({ symbol }) => !more.some((other) => other.symbol === symbol)),
  ...more,
];

/** Own entries are a note of the folder of the program; without a program they are kept by the browser. */
export function keepLibrary(): void {
  const workspace = setting.value?.workspace;
  let stored: readonly LibraryEntry[] = own.value;
  const fail = (error: Error) => (state.notice.value = { text: `The material library is not stored: ${error.message}`, bad: true });
  if (workspace)
    workspace
      .readNote<unknown>("library")
      .then((found) => {
        stored = mergeEntries(readEntries(found), own.peek());
        own.value = stored;
      })
      .catch(() => undefined);
  else
    try {
      stored = readEntries(JSON.parse(localStorage.getItem(browserKey) ?? "[]"));
      own.value = stored;
    } catch {
      // Without storage own entries last as long as the page.
    }
  effect(() => {
    const now = own.value;
    if (now === stored) return;
    stored = now;
    if (workspace) workspace.writeNote("library", now).catch(fail);
    else
      try {
        localStorage.setItem(browserKey, JSON.stringify(now));
      } catch {
        // Likewise.
      }
  });
}
