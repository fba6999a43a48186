// SPDX-License-Identifier: MIT
/** What all parts of the contract share: kinds of methods and factors, units, packed arrays, columns. */

/**
 * An array kept outside the JSON document, in a `<script type="text/plain" id="...">`: base64 of a zlib stream of the
 * numbers, little endian. With `planes` the bytes stand as planes (all lowest bytes first, then all next ones); with
 * `delta` each row along the first axis holds the differences (modulo the type's range) to the row before it.
 * (never of an `f32`). `u16` with `range`: value = min + q / 65534 × (max - min); q = 65535 stands for "no value".
 */
export interface PackedArray {
  id: string;
  type: "u8" | "u16" | "u32" | "f32";
  shape: number[];
  delta: boolean;
  planes: boolean;
  range?: [number, number];
}

/**
 * Coordinates [m], of which the last axis counts the components: value = origin + step × number, each component with its
 * own, in double precision; q = 65535 of an `u16` stands for "no value".
 */
export interface PackedPlaces extends PackedArray {
  origin: number[];
  step: number[];
}

export interface Column {
  name: string;
  title: string;
  /** Unit as written; values are already in it. */
  unit: string;
  /** null where there is no value. */
  values: (number | null)[];
}

/** A column of a history, of monitors, or of the ground. */
export interface TableColumn extends Column {
  quantity: HistoryQuantity;
  /** Of energy: what goes into the body, and what it becomes. */
  part?: "external" | "kinetic" | "elastic" | "plastic" | "damping" | "walls" | "mapping" | "drag" | "pore_water" | "supports";
  /** Monitor, or side that water passes; empty: the whole body. */
  of: string;
  /** Of all points. */
  largest: boolean;
  /** Absent for a scalar, and the length of a vector. */
  component?: "x" | "y" | "z";
  /** Whether it is per metre of thickness in plane strain. */
  extensive: boolean;
}

/** "energy" is what the balance of energy adds up, "state" another variable of a soil model. */
export type HistoryQuantity =
  | "time"
  | "time_step"
  | "count"
  | "energy"
  | "potential_energy"
  | "force_ratio"
  | "nodal_speed"
  | "mass"
  | "momentum"
  | "position"
  | "displacement"
  | "front"
  | "velocity"
  | "stress"
  | "strain"
  | "pore_pressure"
  | "suction"
  | "saturation"
  | "water_mass"
  | "water_flow"
  | "transpiration"
  | "state";
