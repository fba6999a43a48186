// SPDX-License-Identifier: MIT
/** Slices as the figures and tables need them: titles, columns with their units, colours of the trials. */
import { computed } from "@preact/signals";

import type { CriticalSurface, DrawnSurface } from "../contract";
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

type MakeColumn = (
  name: string,
  title: string,
  symbol: string,
  unit: { name: string; si: number },
  values: (number | null)[],
  always?: boolean,
  digits?: number | "place",
) => SliceColumn[];

/** Columns on the strength after a rapid drawdown. */
const makeDrawdownColumns = (drawn: DrawnSurface, column: MakeColumn, stress: { name: string; si: number }) => [
  ...column("normal_before", "Effective normal stress before drawdown", "σ′_fc", stress, drawn.normal, false),
  ...column("shear_before", "Shear stress before drawdown", "τ_fc", stress, drawn.shear, false),
  ...column("undrained_strength", "Undrained strength after drawdown", "s_u", stress, drawn.strength, false),
];

/** The slice table; quantities that are zero everywhere are left out, but for those of every slice table. */
export function makeSliceTable(surface: CriticalSurface): SliceColumn[] {
  const s = surface.slices;
  const { length, stress, line_force: force } = report.value.units;
  const count = s.left.length;
  const effective = s.normal.map((n, i) => (n === null ? null : n - Math.max(0, s.pore_pressure[i]!) * s.length[i]!));
  const column: MakeColumn = (name, title, symbol, unit, values, always = true, digits = 4) =>
    !always && values.every((v) => !v)
      ? []
      : [
          {
            name,
            title,
            symbol,
            unit: unit.name,
            digits,
            values: values.map((v) => (v === null ? null : v / unit.si)),
          },
        ];
  const plain = { name: "", si: 1 };
  const degree = { name: "°", si: 1 / degrees };
  const middle = s.left.map((x, i) => (x + s.right[i]!) / 2);
  return [
    {
      name: "slice",
      title: "Slice, from left to right",
      symbol: "",
      unit: "",
      digits: 4,
      values: Array.from({ length: count }, (_, i) => i + 1),
    },
    ...column("x", "Middle of the slice", "x", length, middle, true, "place"),
    ...column(
      "width",
      "Width",
      "b",
      length,
      s.left.map((x, i) => s.right[i]! - x),
      true,
      3,
    ),
    ...(new Set(s.soil).size > 1
      ? [{ name: "soil", title: "Soil at the base", symbol: "soil", unit: "", digits: 0, values: s.soil }]
      : []),
    ...column("alpha", "Inclination of the base", "α", degree, s.alpha, true, 3),
    ...column("length", "Length of the base", "l", length, s.length, true, 3),
    ...column("weight", "Weight", "W", force, s.weight),
    ...column("surface_load", "Load on the ground", "Q", force, s.surface_load, false),
    ...column(
      "surface_thrust",
      "Horizontal load of ponded water, against the sliding",
      "Q_h",
      force,
      s.surface_thrust,
      false,
    ),
    ...column("earthquake", "Earthquake force", "F_h", force, s.earthquake, false),
    ...column("pore_pressure", "Pore pressure", "u", stress, s.pore_pressure),
    ...column("cohesion", "Cohesion, with roots and suction", "c", stress, s.cohesion, true, 3),
    ...column("root_cohesion", "Of it from roots", "c_r", stress, s.root_cohesion, false, 3),
    ...column("suction_strength", "Of it from suction", "c_s", stress, s.suction_strength, false, 3),
    ...column("friction", "Friction angle", "φ", degree, s.tan_friction.map(Math.atan), true, 3),
    ...column("normal", "Normal force", "N", force, s.normal),
    ...column("effective_normal", "Effective normal force, N − u l without suction", "N′", force, effective),
    ...column("shear", "Mobilised shear force", "T", force, s.shear),
    ...column("normal_right", "Force between slices on the right side, horizontal", "E", force, s.normal_right, false),
    ...column("shear_right", "Force between slices on the right side, vertical", "X", force, s.shear_right, false),
    ...column("thrust_right", "Elevation of E on the right side", "y_E", length, s.thrust_right, false, "place"),
    ...(surface.drawdown ? makeDrawdownColumns(surface.drawdown, column, stress) : []),
    ...column("m_alpha", "Denominator of the normal force", "m_α", plain, s.m_alpha, false, 3),
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

export function orderValues(values: readonly (number | string | null)[], down: boolean): number[] {
  const sign = down ? -1 : 1;
  return Array.from(values.keys()).sort((a, b) => {
    const [x, y] = [values[a] ?? null, values[b] ?? null];
    if (x === null || y === null) return Number(x === null) - Number(y === null) || a - b;
    const difference =
      typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y), "en");
    return sign * difference || a - b;
  });
}
