// SPDX-License-Identifier: MIT
/** The calculation model: geometry, supports, loads, soils, stages, mesh; pore water: soils, conditions, start, weather before the run, budget. */
import type { Unit } from "./results";
import type { PackedArray, PackedPlaces } from "./units";

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
  /** Straight bars of the supports [m]; `bonded`: distance from the head from which on they have bond. */
  bars: { support: string; row: number; head: number[]; end: number[]; bonded: number }[];
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
  /** Absent for soil without a strength on a plane. */
  strength?: SoilStrength;
  /** Absent for dry soil. */
  water?: SoilWater;
}

/** The τ–σ diagram of a soil. */
export interface SoilStrength {
  /** Title of the axis of the stresses. */
  stress: string;
  /** [Pa], rising from 0. */
  normal: number[];
  /** Shear strengths at these stresses [Pa], of planes or places with a name; one line without a name where there is only one. */
  lines: { name: string; shear: number[] }[];
}

/** The triangles that fields of pore water lie on. */
export interface WaterMesh {
  /** Of water [N/m³]. */
  unit_weight: number;
  /** [node][2] f32 [m], [element][3] u32. */
  nodes: PackedPlaces;
  elements: PackedArray;
}

/** What a soil does with water: the laws in words, their parameters, and their curves. */
export interface SoilWater {
  /** "van Genuchten", and its formula in words. */
  retention: string;
  conductivity: string;
  /** Of Bishop's effective stress. */
  chi: string;
  parameters: { key: string; title: string; symbol: string; unit: string; value: number }[];
  curves: {
    /** [Pa], rising, above 0. */
    suction: number[];
    /** S [-]. */
    saturation: number[];
    /** k [m/s]; empty where no saturated conductivity is known. */
    conductivity: number[];
    /** Largest suction of the results [Pa]; null when unknown or none. */
    largest_suction: number | null;
  };
}

/** Pore water of the case and of its results. */
export interface Water {
  /** "saturated and unsaturated soil, at the start in steady seepage", ... */
  state: string;
  /** How the pore pressures began, in one sentence. */
  initial: string;
  properties: { key: string; title: string; symbol: string; unit: string; value: number }[];
  conditions: HydraulicCondition[];
}

/** What water meets on a side. */
export interface HydraulicCondition {
  on: string;
  condition: "total_head" | "pressure" | "seepage_face" | "rain" | "flux" | "no_flow" | "free_drainage";
  title: string;
  /** What happens there, in words. */
  text: string;
  /** Over time [s], in `unit`; a constant has one row, and a jump two rows at one time. */
  series?: { title: string; unit: Unit; time: number[]; values: number[] };
  /** Where it lies at the start, each a polyline [m]; empty in 3D. */
  lines: number[][][];
}

/** What the report adds to a state of the water. */
export interface WaterShown {
  /** "steady seepage", "1.5 days before the start", "start, after 3 days of transient seepage". */
  title: string;
  /** Absent in 3D, and on a mesh too large to draw. */
  fields?: {
    /** [node] u16, compression positive [Pa]. */
    pressure: PackedArray;
    /** [element] u16 [-]. */
    saturation?: PackedArray;
    /** Darcy's, [element][2] f32 [m/s]. */
    velocity?: PackedArray;
  };
}
