// SPDX-License-Identifier: MIT
/** What the report adds to `fem` of the results: the packed mesh and fields. */
import type { PackedArray, PackedPlaces } from "./units";

/** Absent in 3D, and of a mesh too large to draw. */
export interface ElementsDrawn {
  mesh: { nodes: PackedPlaces; elements: PackedArray };
  /** Of each strength reduction; null where the file has none. */
  fields: (PackedElementFields | null)[];
}

export interface PackedElementFields {
  /** [node][2] u16 [m], at failure. */
  displacement: PackedArray;
  /** [node] u16 [-]. */
  shear_strain: PackedArray;
  /** Limits of a useful colour scale [-]. */
  strain_scale: [number, number];
  /** [element] u8: whether it yields. */
  yields: PackedArray;
}
