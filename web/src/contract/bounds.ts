// SPDX-License-Identifier: MIT
/** The interval that limit analysis proves. */
import type { PackedArray, PackedPlaces } from "./units";

export interface ProvenBounds {
  /** Why there is no answer. */
  error?: string;
  /** null: none was proven, `no_lower` says why. */
  lower: number | null;
  upper: number | null;
  no_lower: string;
  no_upper: string;
  /** Width of the interval over its middle that was asked for. */
  asked_gap: number;
  /** Of soil with the strength of Davis for ψ < φ. */
  is_davis: boolean;
  /** Whether soils bear no more tension than given. */
  takes_tension: boolean;
  seconds: number;
  /** Nested, from coarse to fine, with what was proven up to each. */
  meshes: {
    triangles: number;
    lower: number | null;
    upper: number | null;
    programs: number;
    iterations: number;
    seconds: number;
  }[];
  /** Lines along which the mechanism slides [m]. */
  slip_lines: number[][][];
  /** The stress field of the lower bound; absent where there is none, and of a mesh too large to draw. */
  holds?: {
    nodes: PackedPlaces;
    triangles: PackedArray;
    /** [triangle][3] u16: effective xx, yy, xy in its middle, positive in tension [Pa]. */
    stress: PackedArray;
    /** [triangle] u16: how much of the strength is used. */
    utilisation: PackedArray;
  };
  /** The velocity field of the upper bound. */
  moves?: {
    nodes: PackedPlaces;
    /** [triangle][6]: corners, then middles of the sides. */
    triangles: PackedArray;
    /** [node][2] u16; the fastest has 1. */
    velocity: PackedArray;
    /** [triangle] u16: shear strain rate; the largest is 1. */
    shear_rate: PackedArray;
  };
}
