// SPDX-License-Identifier: MIT
/** What the report adds to `lem` of the results: which surface governs, and the packed trials. */
import type { PackedArray, PackedPlaces } from "./units";

export interface Slices {
  /** Method of rapid drawdown, for people; absent without one. Factors are those after it. */
  drawdown?: string;
  /** Number of the surface that governs among the critical, noncircular, given and optimised ones, in this order. */
  governing?: number;
  trials?: SliceTrials;
  maps: FactorMap[];
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
