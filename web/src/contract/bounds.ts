// SPDX-License-Identifier: MIT
/** What the report adds to `bounds` of the results: the packed fields. */
import type { PackedArray, PackedPlaces } from "./units";

export interface BoundsDrawn {
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
