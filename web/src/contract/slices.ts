// SPDX-License-Identifier: MIT
/** Methods of slices: critical surfaces, and what was tried. */
import type { PackedArray, PackedPlaces, SliceMethod } from "./units";

/** Methods of slices: critical surfaces, and what was tried. */
export interface Slices {
  /** Why there is no answer. */
  error?: string;
  methods: { name: SliceMethod; title: string }[];
  slice_count: number;
  /** Method of rapid drawdown, for people; absent without one. Factors are those after it. */
  drawdown?: string;
  seconds: number;
  surfaces: SlicedSurface[];
  minima: LocalMinimum[];
  search?: SliceSearch;
  trials?: SliceTrials;
  maps: FactorMap[];
}

export interface Circle {
  /** [m] */
  centre: number[];
  radius: number;
}

/** A surface that one method gives a factor for, with its slices. */
export interface SlicedSurface {
  kind: "circle" | "polyline" | "given" | "optimised";
  /** Of a given surface, and of one that was optimised from another method's; empty otherwise. */
  name: string;
  method: SliceMethod;
  title: string;
  /** null: refused, `checks.refusal` says why. */
  factor: number | null;
  /** λ of Spencer and Morgenstern–Price; null where the method has none. */
  lambda: number | null;
  /** Janbu's f₀; 1 of other methods. */
  correction: number;
  circle?: Circle;
  /** From left to right [m]. */
  points: number[][];
  /** Of the sliding mass [m²], its greatest depth [m]. */
  area: number;
  depth: number;
  /** k_y [-]; null where it was not asked for, or the slope fails without any. */
  yield_acceleration: number | null;
  /** Absent without a rapid drawdown: `factor` is after it. */
  drawdown?: DrawnSurface;
  checks: { smallest_m_alpha: number | null; tensile_share: number; thrust_outside: number; refusal: string };
  /** From left to right; absent where the surface could not be cut. */
  slices?: SliceColumns;
  warnings: string[];
  /** Its factor is that of the slices. */
  governs: boolean;
}

/** The stages of a rapid drawdown on one surface. */
export interface DrawnSurface {
  /** null: none was found. */
  factor_before: number | null;
  /** Of the second stage of three; null by other methods. */
  undrained_factor: number | null;
  /** Of each slice's base before drawdown, effective normal stress and shear stress [Pa]; empty by effective stresses. */
  normal: number[];
  shear: number[];
  /** Undrained [Pa]; null in soil that drains. */
  strength: (number | null)[];
}

/** Lists of one length; SI, forces per metre of thickness; null where a method has no such quantity. */
export interface SliceColumns {
  soil: string[];
  /** [m] */
  left: number[];
  right: number[];
  base_left: number[][];
  base_right: number[][];
  top_left: number[];
  top_right: number[];
  /** Angle of the base, positive where it falls in the direction of sliding [rad]. */
  alpha: number[];
  /** [m] */
  length: number[];
  weight: number[];
  surface_load: number[];
  /** Horizontal, of ponded water; against the sliding positive. */
  surface_thrust: number[];
  earthquake: number[];
  /** Compression positive [Pa]. */
  pore_pressure: number[];
  /** With roots and suction, which are given as parts of it [Pa]. */
  cohesion: number[];
  root_cohesion: number[];
  suction_strength: number[];
  tan_friction: number[];
  /** Total N, mobilised T. */
  normal: (number | null)[];
  shear: (number | null)[];
  m_alpha: (number | null)[];
  /** E and X on the right side, and the elevation of E [m]. */
  normal_right: (number | null)[];
  shear_right: (number | null)[];
  thrust_right: (number | null)[];
}

export interface LocalMinimum {
  method: string;
  factor: number;
  circle?: Circle;
  points: number[][];
}

export interface SliceSearch {
  kind: "entry_exit" | "grid";
  tried: number;
  /** Surfaces that gave no factor, by method and reason. */
  refused: { method: string; reasons: { reason: string; count: number }[] }[];
  /** Sentences. */
  limit_hits: string[];
  /** Of x along the ground [m], at the toe and at the crest; of the grid of centres [m]. */
  exit?: number[];
  entry?: number[];
  grid?: number[][];
  circles_per_second: number | null;
}

/** Every trial circle. */
export interface SliceTrials {
  count: number;
  /** Of the columns of `factors`. */
  methods: string[];
  /** [circle][x and y of the centre, radius, x where the arc begins and ends] f32 [m]. */
  circles: PackedPlaces;
  /** [circle][method] f32; 0: refused. */
  factors: PackedArray;
}

/** The smallest factor over the centres of the circles. */
export interface FactorMap {
  method: string;
  /** Outer corners [m]. */
  from: number[];
  to: number[];
  columns: number;
  rows: number;
  /** [row][column] from the lower left, f32; 0: none. */
  factor: PackedArray;
}
