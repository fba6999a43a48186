/** The part of the data contract that slices, finite elements and their comparison with material points have. */
import type { PackedArray } from "./report";

/** Factors of safety by method, and the surfaces that the methods found. */
export interface MethodTable {
  /** "lem", "fem", "mpm", as the case asks for them. */
  asked: string[];
  rows: MethodRow[];
  surfaces: MethodSurface[];
  /** Surfaces of one method that slices were cut on. */
  handed: { from: string; to: string; title: string; factor: number | null; refusal: string }[];
  /** Where the methods differ, and why; "Slices", "Mechanism". */
  reading: { topic: string; sentences: string[] }[];
  partial_factors?: PartialFactors;
}

export interface MethodRow {
  /** "lem", "fem", "mpm". */
  method: string;
  /** "spencer". */
  name: string;
  title: string;
  /** "critical circle", "no equilibrium". */
  criterion: string;
  /** Of `surfaces`; empty where there is none. */
  surface: string;
  /** null: none was found, `note` says why. */
  factor: number | null;
  lower: number | null;
  upper: number | null;
  /** Computing time; null where it is not known by itself. */
  seconds: number | null;
  note: string;
}

export interface MethodSurface {
  /** "lem.spencer", "fem.band", "mpm.slip_line". */
  name: string;
  title: string;
  method: string;
  factor: number | null;
  /** [m] */
  points: number[][];
}

/** Design values after Eurocode 7, or by hand. */
export interface PartialFactors {
  /** "DA1-2". */
  set: string;
  values: { key: string; title: string; symbol: string; value: number }[];
  /** Characteristic and design values, in `unit`. */
  materials: {
    material: string;
    quantity: string;
    symbol: string;
    unit: string;
    characteristic: number;
    design: number;
  }[];
  /** Sentences. */
  notes: string[];
  /** Factor of safety with the design values; null where it is not known. */
  over_design: number | null;
  text: string;
}

/** Methods of slices: critical surfaces, and what was tried. */
export interface Slices {
  /** Why there is no answer. */
  error?: string;
  methods: { name: string; title: string }[];
  slice_count: number;
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
  kind: "circle" | "polyline" | "given";
  /** Of a given surface; empty otherwise. */
  name: string;
  method: string;
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
  checks: { smallest_m_alpha: number | null; tensile_share: number; thrust_outside: number; refusal: string };
  /** From left to right; absent where the surface could not be cut. */
  slices?: SliceColumns;
  warnings: string[];
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
  /** "entry_exit", "grid". */
  kind: string;
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
  circles: PackedArray;
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

/** Strength reduction with quadratic elements. */
export interface FiniteElements {
  /** Why there is no answer. */
  error?: string;
  /** "T6", "T10". */
  element: string;
  elements: number;
  nodes: number;
  unknowns: number;
  /** [m] */
  size: number;
  seconds: number;
  runs: FlowRun[];
  /** Absent in 3D, and of a mesh too large to draw. */
  mesh?: { nodes: PackedArray; elements: PackedArray };
}

/** One strength reduction: with the flow rule as given, or associated. */
export interface FlowRun {
  flow: string;
  title: string;
  /** Dilatancy angles [rad]: least, greatest. */
  psi: number[];
  /** Where equilibrium is lost: between `stable` and `failed`. */
  factor: number | null;
  stable: number | null;
  failed: number | null;
  /** Where the displacement runs away. */
  by_displacement: number | null;
  trials: {
    factor: number;
    converged: boolean;
    iterations: number;
    force_residual: number;
    displacement_residual: number;
    /** Largest, since the equilibrium at full strength [m]. */
    displacement: number;
    seconds: number;
  }[];
  /** [m] */
  slip_line: number[][];
  warnings: string[];
  fields?: {
    /** [node][2] u16 [m], at failure. */
    displacement: PackedArray;
    /** [node] u16 [-]. */
    shear_strain: PackedArray;
    /** Limits of a useful colour scale [-]. */
    strain_scale: [number, number];
    /** [element] u8: whether it yields. */
    yields: PackedArray;
  };
}
