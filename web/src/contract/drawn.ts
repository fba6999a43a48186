// SPDX-License-Identifier: MIT
/** What the report adds to `lem`, `fem` and `bounds` of the results: which surface governs, and the packed trials and fields. */
import type { ElementTrial } from "./results";
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

/** Stages of construction: their mesh of triangles and the fields at their ends. */
export interface StagesDrawn {
  nodes: PackedPlaces;
  /** [element][3]. */
  elements: PackedArray;
  /** Of the stages in their order; stages that were not calculated are absent. */
  stages: PackedStageFields[];
}

export interface PackedStageFields {
  stage: string;
  /** [element] u8: 0 without soil, 1 with soil, 2 where most of it yields. */
  state: PackedArray;
  /** [node][2] u16 [m], since the start of the stages. */
  displacement: PackedArray;
  /** [node] u16, pore pressure and excess pore pressure [Pa]; absent in dry ground. */
  pressure?: PackedArray;
  excess?: PackedArray;
}

/** A strength reduction by FEM in progress, with the fields of its last trial. */
export interface ReductionSoFar {
  /** Flow rule and mesh. */
  title: string;
  /** Largest factor with equilibrium, smallest one without. */
  stable?: number;
  failed?: number;
  trials: ElementTrial[];
  /** Absent as in ElementsDrawn. */
  mesh?: ElementsDrawn["mesh"];
  fields?: PackedElementFields;
}

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
