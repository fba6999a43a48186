// SPDX-License-Identifier: MIT
/** Strength reduction with quadratic finite elements. */
import type { Flow, PackedArray, PackedPlaces } from "./units";

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
  mesh?: { nodes: PackedPlaces; elements: PackedArray };
}

/** One strength reduction: with the flow rule as given, or associated. */
export interface FlowRun {
  flow: Flow;
  title: string;
  /** Dilatancy angles [rad]: least, greatest. */
  psi: number[];
  /** Where equilibrium is lost; of two meshes extrapolated to elements of size zero. */
  factor: number | null;
  /** Interval of mesh and search; null where there is one mesh, whose error is not known. */
  lower: number | null;
  upper: number | null;
  /** The last bracket of the search on the finer mesh. */
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
  /** One, or one of each side where the soil moves to both [m]. */
  slip_lines: number[][][];
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
