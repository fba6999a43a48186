// SPDX-License-Identifier: MIT
/** Slices, finite elements and material points beside each other, and partial factors. */

import type { MethodName, SurfaceSource } from "./units";

/** Factors of safety by method, and the surfaces that the methods found. */
export interface MethodTable {
  /** As the case asks for them. */
  asked: MethodName[];
  rows: MethodRow[];
  surfaces: MethodSurface[];
  /** Surfaces of one method that slices were cut on. */
  handed: { from: string; to: string; title: string; factor: number | null; refusal: string }[];
  /** Where the methods differ, and why; "Slices", "Mechanism". */
  /** Name of the slip surface of the slices that governs; absent where they have no factor. */
  governing?: string;
  reading: { topic: string; sentences: string[] }[];
  partial_factors?: PartialFactors;
}

export interface MethodRow {
  method: MethodName;
  /** Word of the method of slices, the flow rule or the criterion: "spencer", "spencer_optimised". */
  name: string;
  title: string;
  /** "critical circle", "non-convergence". */
  criterion: string;
  /** Of `surfaces`; empty where there is none. */
  surface: string;
  /** Where that surface comes from. */
  source: SurfaceSource;
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
  method: MethodName;
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
