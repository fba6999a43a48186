// SPDX-License-Identifier: MIT
/** The calculation model: geometry, supports, loads, soils, stages, mesh. */
import type { PackedArray, PackedPlaces } from "./units";
import type { SoilWater, WaterMesh, WaterShown } from "./water";

export interface Model {
  dimension: 2 | 3;
  /** [min, max] corners of the box, [m]. */
  bounds: [number[], number[]];
  slope_height: number;
  polygons: { name: string; material: string; points: number[][] }[];
  /** Named lines of supports, each a list of polylines [m]; empty in 3D. */
  boundaries: { on: string; fix: string; text: string; lines: number[][][] }[];
  loads: { name: string; text: string }[];
  /** Vertical loads on the ground: x [m], and loads there [Pa]; linear between, down positive. */
  surcharges: { name: string; x: number[]; load: number[] }[];
  /** Vertical crack at the upper end of the surfaces of LEM: its depth, and that of the water in it [m]. */
  crack?: { depth: number; water: number };
  /** Of `water_states` of the results, in their order. */
  water: WaterShown[];
  /** The triangles of the fields of these states. */
  water_mesh?: WaterMesh;
  monitors: { name: string; at: number[]; id: number }[];
  materials: MaterialRow[];
  /** `time`: simulated time at the end [s]; `wall`: how long it took [s]. */
  stages: { name: string; text: string; end: string; time: number; steps: number; wall: number }[];
  mesh: {
    nodes: number;
    elements: number;
    points: number;
    mean_size: number;
    smallest_altitude: number;
    critical_time_step: number;
    /** [node][dimension] f32 [m] and [element][dimension + 1] u32; absent when the folder holds no mesh. */
    positions?: PackedPlaces;
    cells?: PackedArray;
  };
}

export interface MaterialRow {
  name: string;
  /** Number of the material in the points' `materials`. */
  index: number;
  /** "Mohr–Coulomb". */
  model: string;
  regions: string[];
  properties: {
    key: string;
    title: string;
    symbol: string;
    unit: string;
    characteristic: number | null;
    /** Divided by the strength factor of the last stage; only where that is not 1. */
    design: number | null;
    /** At the factor of safety: c/F, atan(tan φ/F). */
    at_failure: number | null;
  }[];
  /** Absent for dry soil. */
  water?: SoilWater;
}
