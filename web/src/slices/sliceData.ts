// SPDX-License-Identifier: MIT
/** Slices as the figures and tables need them: titles, columns with their units, colours of the trials. */
import { computed } from "@preact/signals";

import type { CriticalSurface } from "../contract";
import { report } from "../state";
import { tabulateColours } from "../viewer/colours";

/** A surface that one method gives a factor for, and where it comes from. */
export interface SlicedSurface extends CriticalSurface {
  kind: "circle" | "polyline" | "given" | "optimised";
  /** Its factor is that of the slices. */
  governs: boolean;
}

export const slicedSurfaces = computed<SlicedSurface[]>(() => {
  const { result, slices } = report.value;
  const { lem, methods } = result;
  const lists = [lem?.critical, lem?.noncircular, lem?.given, methods?.optimised];
  const kinds = ["circle", "polyline", "given", "optimised"] as const;
  return lists
    .flatMap((list, k) => (list ?? []).map((surface) => ({ ...surface, kind: kinds[k]! })))
    .map((surface, i) => ({ ...surface, governs: i === slices?.governing }));
});

export const hasSlices = ({ slices }: CriticalSurface) => slices.left.length > 0;

/** "Spencer: the critical circle …". */
export const listLimits = () => (report.value.result.lem?.search?.limits ?? []).map((hit) => `${hit.method}: ${hit.limit}`);

export const nameReason = (reason: string) => reason.replaceAll("m_alpha", "m_α");

/** "Spencer, circle", "Bishop, polyline", "Bishop, surface ‘toe’". */
export function nameSurface(surface: SlicedSurface): string {
  if (surface.kind === "given") return `${surface.title}, surface “${surface.name}”`;
  if (surface.kind === "optimised") return `${surface.title}, optimised from another method’s surface`;
  return `${surface.title}, ${surface.kind === "circle" ? "critical circle" : "polyline"}`;
}

export const titleMethod = (name: string) => slicedSurfaces.value.find((s) => s.method === name)?.title ?? name;

interface SliceColumn {
  name: string;
  title: string;
  /** Text for the head of the table, with subscripts. */
  symbol: string;
  unit: string;
  values: (number | string | null)[];
  /** Significant ones; "place": a coordinate. */
  digits: number | "place";
}

const degrees = 180 / Math.PI;

type Unit = { name: string; si: number };
/** `digits` as in SliceColumn, 4 where it is left out. */
type Described = [name: string, title: string, symbol: string, unit: Unit, values: (number | null)[], digits?: 3 | "place"];

/** The slice table; quantities that are zero everywhere are left out, but for those of every slice table. */
export function makeSliceTable(surface: CriticalSurface): SliceColumn[] {
  const s = surface.slices;
  const { length, stress, line_force: force } = report.value.units;
  const count = s.left.length;
  const effective = s.normal.map((n, i) => (n === null ? null : n - Math.max(0, s.pore_pressure[i]!) * s.length[i]!));
  const take = (rows: Described[]): SliceColumn[] =>
    rows.map(([name, title, symbol, unit, values, digits = 4]) => {
      const shown = values.map((v) => (v === null ? null : v / unit.si));
      return { name, title, symbol, unit: unit.name, digits, values: shown };
    });
  /** Without those that are zero everywhere. */
  const takeUsed = (rows: Described[]) => take(rows.filter(([, , , , values]) => values.some((v) => v)));
  const plain = { name: "", si: 1 };
  const degree = { name: "°", si: 1 / degrees };
  const middle = s.left.map((x, i) => (x + s.right[i]!) / 2);
  const width = s.left.map((x, i) => s.right[i]! - x);
  const drawn: Described[] = surface.drawdown
    ? [
        ["normal_before", "Effective normal stress before drawdown", "σ′_fc", stress, surface.drawdown.normal],
        ["shear_before", "Shear stress before drawdown", "τ_fc", stress, surface.drawdown.shear],
        ["undrained_strength", "Undrained strength after drawdown", "s_u", stress, surface.drawdown.strength],
      ]
    : [];
  return [
    ...take([
      ["slice", "Slice, from left to right", "", plain, Array.from({ length: count }, (_, i) => i + 1)],
      ["x", "Middle of the slice", "x", length, middle, "place"],
      ["width", "Width", "b", length, width, 3],
    ]),
    ...(new Set(s.soil).size > 1
      ? [{ name: "soil", title: "Soil at the base", symbol: "soil", unit: "", digits: 0, values: s.soil }]
      : []),
    ...take([
      ["alpha", "Inclination of the base", "α", degree, s.alpha, 3],
      ["length", "Length of the base", "l", length, s.length, 3],
      ["weight", "Weight", "W", force, s.weight],
    ]),
    ...takeUsed([
      ["surface_load", "Load on the ground", "Q", force, s.surface_load],
      ["surface_thrust", "Horizontal load of ponded water, against the sliding", "Q_h", force, s.surface_thrust],
      ["earthquake", "Earthquake force", "F_h", force, s.earthquake],
    ]),
    ...take([
      ["pore_pressure", "Pore pressure", "u", stress, s.pore_pressure],
      ["cohesion", "Cohesion, with roots and suction", "c", stress, s.cohesion, 3],
    ]),
    ...takeUsed([
      ["root_cohesion", "Of it from roots", "c_r", stress, s.root_cohesion, 3],
      ["suction_strength", "Of it from suction", "c_s", stress, s.suction_strength, 3],
    ]),
    ...take([
      ["friction", "Friction angle", "φ", degree, s.tan_friction.map(Math.atan), 3],
      ["normal", "Normal force", "N", force, s.normal],
      ["effective_normal", "Effective normal force, N − u l without suction", "N′", force, effective],
      ["shear", "Mobilised shear force", "T", force, s.shear],
    ]),
    ...takeUsed([
      ["normal_right", "Force between slices on the right side, horizontal", "E", force, s.normal_right],
      ["shear_right", "Force between slices on the right side, vertical", "X", force, s.shear_right],
      ["thrust_right", "Elevation of E on the right side", "y_E", length, s.thrust_right, "place"],
      ...drawn,
      ["m_alpha", "Denominator of the normal force", "m_α", plain, s.m_alpha, 3],
    ]),
  ];
}

/** Trials of one method that are drawn, from the safest to the weakest, and the limits of their colours. */
export interface RankedTrials {
  order: Uint32Array;
  factors: Float32Array;
  low: number;
  high: number;
}

export function rankTrials(all: ArrayLike<number>, methods: number, method: number): RankedTrials | null {
  const count = all.length / methods;
  const factors = Float32Array.from({ length: count }, (_, i) => all[i * methods + method]!);
  const order = Uint32Array.from(factors.keys()).filter((i) => factors[i]! > 0);
  if (!order.length) return null;
  order.sort((a, b) => factors[b]! - factors[a]!);
  const low = factors[order.at(-1)!]!;
  // Outliers do not stretch the colours: the safest fifth has one colour.
  const high = factors[order[Math.floor(order.length / 5)]!]!;
  return { order, factors, low, high: Math.max(high, low * 1.05) };
}

/** Weak surfaces contrast with the background of the page: dark on light, light on dark. */
export function chooseColours(dark: boolean): Uint8Array {
  const table = tabulateColours("viridis");
  if (dark) {
    const reversed = new Uint8Array(table.length);
    for (let i = 0; i < 256; ++i) reversed.set(table.subarray(4 * (255 - i), 4 * (256 - i)), 4 * i);
    return reversed;
  }
  return table;
}
