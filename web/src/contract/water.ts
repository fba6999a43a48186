// SPDX-License-Identifier: MIT
/** Pore water: soils, conditions, start, weather before the run, budget. */
import type { Unit } from "./results";
import type { PackedArray, PackedPlaces } from "./units";

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
  /** Absent while the run has not ended. */
  budget?: WaterBudget;
  /** Absent where the pore pressures did not begin in steady seepage. */
  seepage?: SteadySeepage;
  /** Absent without weather before the run. */
  season?: Season;
}

/** The weather before the run, in soil at rest; volumes [m³], in 2D per metre of thickness, since its start. */
export interface Season {
  /** [s] */
  duration: number;
  inflow: number;
  outflow: number;
  runoff: number;
  /** What the plants asked for, and what they got. */
  potential: number;
  transpired: number;
  /** Of the water in the soil. */
  growth: number;
  /** What the sum does not explain, over the greatest of its parts [-]. */
  error: number;
  /** Down to `depth` [m] under the ground from the layer before: suction [Pa] at the start (mean) and at the end. */
  layers: { depth: number; initial: number; mean: number; least: number; greatest: number; driest: number }[];
}

/** What water meets on a side. */
export interface HydraulicCondition {
  on: string;
  condition: "total_head" | "pressure" | "seepage_face" | "rain" | "flux" | "no_flow";
  title: string;
  /** What happens there, in words. */
  text: string;
  /** Over time [s], in `unit`; a constant has one row, and a jump two rows at one time. */
  series?: { title: string; unit: Unit; time: number[]; values: number[] };
  /** Where it lies at the start, each a polyline [m]; empty in 3D. */
  lines: number[][][];
}

/** Masses of water [kg], in 2D per metre of thickness, over the stages. */
export interface WaterBudget {
  surfaces: {
    name: string;
    condition: string;
    entered: number;
    left: number;
    /** Of rain: what was offered, and what of it ran off. */
    supplied: number;
    runoff: number;
  }[];
  initial: number;
  stored: number;
  entered: number;
  left: number;
  runoff: number;
  /** With soil that left the grid. */
  left_grid: number;
  /** At frozen geometry: what straining pores would have pressed out. */
  pressed_in: number;
  /** Between elements that are integrated differently. */
  lost_between: number;
  /** Drawn by roots; absent where nothing transpires. */
  transpired?: number;
  /** What the sum does not explain, over the water in the model [-]. */
  error: number;
  /** [kg/m³]: makes volumes of the masses. */
  density: number;
  /** At the end [Pa]. */
  largest_pressure: number;
  largest_suction: number;
}

/** Where the water stood at one time before the first stage or trial, and what passed each side then. */
export interface WaterState {
  flow: "hydrostatic" | "steady" | "transient" | "lowered";
  /** "steady seepage", "1.5 days before the start", "start, after 3 days of transient seepage". */
  title: string;
  /** The methods begin at 0 [s]. */
  time: number;
  /** Rates [m³/s], in 2D per metre; all 0 where water is at rest. */
  inflow: number;
  outflow: number;
  storage_rate: number;
  discharges: { name: string; inflow: number; outflow: number; runoff: number }[];
  /** Where water leaves seepage faces [m]. */
  exits: { name: string; lowest: number[]; highest: number[] }[];
  /** Lines of zero pressure [m]; empty in 3D. */
  tables: number[][][];
  /** Water on the ground between two places of it, and its level at both [m]. */
  ponds: { from: number[]; to: number[]; level_from: number; level_to: number }[];
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

/** Steady flow before the first stage; rates [m³/s], in 2D per metre. */
export interface SteadySeepage {
  discharges: { name: string; inflow: number; outflow: number; runoff: number }[];
  inflow: number;
  outflow: number;
  balance_error: number;
  iterations: number;
  /** Nodes of surfaces whose state was not settled. */
  undecided: number;
  /** [Pa], and where [m]. */
  largest_suction: number;
  largest_suction_at: number[];
  /** Where water leaves seepage faces [m]. */
  exits: { name: string; lowest: number[]; highest: number[] }[];
}
