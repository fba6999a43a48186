/**
 * The data contract between the C++ side (src/report/) and this page: what a report holds.
 *
 * `npm run schema` writes it as JSON Schema to contract/report.schema.json; the C++ tests hold what they write against
 * that schema, the tests of the page hold a real report against it too. Numbers are SI; `Unit.si` converts for display.
 */

/** How a quantity is shown: value in SI = value shown × si. */
export interface Unit {
  name: string;
  si: number;
}

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

/** A report: of one run, or of a study. */
export interface Report {
  format: 1;
  kind: "run" | "study";
  project: Project;
  status: "finished" | "interrupted" | "unstable" | "failed" | "unfinished";
  /** Why the run did not finish. */
  error?: string;
  units: { length: Unit; displacement: Unit; stress: Unit };
  answer: Answer;
  warnings: string[];
  model: Model;
  sequences: Sequence[];
  curve?: Curve;
  tables: Table[];
  comparisons: Comparison[];
  study?: Study;
  /** Absent where the ground is dry. */
  water?: Water;
  /** Sentences: what the numbers rest on, and where they end. */
  assumptions: string[];
  /** Names of the paragraphs of the methods section that apply. */
  methods: Method[];
  /** The case as it was understood: nested tables whose leaves are InputValue. */
  input: InputTable;
  provenance: Provenance;
  timing: Timing;
}

/** The title block. Empty texts are left out. */
export interface Project {
  title: string;
  project: string;
  client: string;
  author: string;
  checked_by: string;
  revision: string;
  notes: string;
  /** ISO 8601, when the run was started. */
  date: string;
}

export type Method =
  | "material_point_method"
  | "time_step"
  | "mixed_integration"
  | "point_integration"
  | "strain_smoothing"
  | "stable_smoothing"
  | "local_damping"
  | "mass_scaling"
  | "mohr_coulomb"
  | "linear_elastic"
  | "strength_reduction"
  | "displacement_curve"
  | "frozen_factor"
  | "runout"
  | "two_phase"
  | "water_storage"
  | "soil_water"
  | "pressure_smoothing"
  | "hydraulic_conditions"
  | "steady_seepage"
  | "held_pressures";

export interface Answer {
  /** The answer in words, the most important sentence first. */
  sentences: string[];
  factors: Factor[];
  results: NamedResult[];
}

/** A factor of safety by one method and criterion. */
export interface Factor {
  /** "mpm", "lem", "fem". */
  method: string;
  /** As in results: "factor_of_safety.frozen". */
  name: string;
  /** "rest or run-away at frozen geometry". */
  title: string;
  /** null: this criterion found none, `note` says why. */
  value: number | null;
  lower: number | null;
  upper: number | null;
  note: string;
  /** The one that the first sentence names. */
  main: boolean;
  /** What pore water did in the trials: absent where the ground is dry. */
  water?: "flows" | "held";
}

/** A number that a [[compare]] of the case may name. */
export interface NamedResult {
  name: string;
  title: string;
  value: number;
  unit: Unit;
}

/** A [[compare]] of the case. */
export interface Comparison {
  name: string;
  title: string;
  unit: Unit;
  /** null: the run has no such result. */
  computed: number | null;
  published: number;
  /** Largest difference that passes: absolute [SI]. */
  tolerance: number;
  /** As the case states it: "5 %", "0.02". */
  tolerance_text: string;
  source: string;
  passes: boolean;
  note: string;
}

export interface Model {
  dimension: 2 | 3;
  /** [min, max] corners of the box, [m]. */
  bounds: [number[], number[]];
  slope_height: number;
  polygons: { name: string; material: string; points: number[][] }[];
  /** Named lines of supports, each a list of polylines [m]; empty in 3D. */
  boundaries: { on: string; fix: string; text: string; lines: number[][][] }[];
  loads: { name: string; text: string }[];
  /** Water tables at the start [m]; empty where none is known, and in 3D. */
  water: { name: string; points: number[][] }[];
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
    positions?: PackedArray;
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
}

/** What water meets on a side. */
export interface HydraulicCondition {
  on: string;
  /** "total_head", "pressure", "seepage_face", "rain", "flux", "no_flow". */
  condition: string;
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
  /** What the sum does not explain, over the water in the model [-]. */
  error: number;
  /** [kg/m³]: makes volumes of the masses. */
  density: number;
  /** At the end [Pa]. */
  largest_pressure: number;
  largest_suction: number;
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

/** Frames that belong together: the stages, the trials of the curve, one runout. */
export interface Sequence {
  /** "stages", "curve", "runout_1.75". */
  id: string;
  title: string;
  /** What runs along the frames: simulated time, or the strength reduction factor. */
  axis: "time" | "factor";
  frames: { time: number; factor: number | null; stage: string; label: string }[];
  /** One sentence: which frames and points of the results are shown here. */
  thinning: string;
  point_count: number;
  /** [point] u32: number of each point, as in the results file. */
  ids: PackedArray;
  /** [point] u8. */
  materials: PackedArray;
  /** [frame][point][dimension] u16 with range, one range for all axes [m]. */
  positions: PackedArray;
  fields: SequenceField[];
}

export interface SequenceField {
  /** "deviatoric_strain", "displacement", "displacement_x", "stress_xx". */
  name: string;
  title: string;
  unit: Unit;
  /** [frame][point] u16 with range. */
  values: PackedArray;
  /** Limits of a useful colour scale over all frames (SI): outliers do not stretch it. */
  scale: [number, number];
  /** Whether the colours should run from one end, or from the middle (signed quantities). */
  diverging: boolean;
}

export interface Curve {
  points: { srf: number; displacement: number; end: string; force_ratio: number; nodal_speed: number }[];
  bilinear?: { first: Branch; last: Branch; factor: number | null };
  criteria: { name: string; factor: number | null; lower: number | null; upper: number | null; note: string }[];
}

/** displacement = slope × SRF + intercept [m]. */
export interface Branch {
  slope: number;
  intercept: number;
  /** The factors that the line was fitted to. */
  factors: number[];
}

/** A table with a common abscissa: a history, a profile. */
export interface Table {
  /** "history", "monitors", "history_runout_1.75", "profile_runout_1.75". */
  id: string;
  title: string;
  kind: "history" | "monitors" | "ground";
  x: Column;
  columns: Column[];
}

export interface Column {
  name: string;
  title: string;
  /** Unit as written; values are already in it. */
  unit: string;
  /** null where there is no value. */
  values: (number | null)[];
}

export interface Study {
  /** Keys that are varied, with the values' texts. */
  vary: { key: string; values: string[] }[];
  mode: string;
  columns: { name: string; title: string; unit: string; shown: string[]; values: (number | null)[] }[];
  rows: { name: string; status: string; reason: string; warnings: string[]; curve?: Curve }[];
}

export interface InputValue {
  value: unknown;
  given: boolean;
  unit?: string;
}
export type InputTable = { [key: string]: InputTable | InputTable[] | InputValue };

export interface Provenance {
  program: string;
  version: string;
  commit: string;
  compiler: string;
  build_type: string;
  architecture: string;
  lane_width: number;
  machine: string;
  threads: number;
  started: string;
  case_file: string;
  input_hash: string;
  /** Of the results folder, without its path. */
  folder: string;
}

/** Seconds. */
export interface Timing {
  wall: number;
  cpu: number;
  /** Sum over all threads. */
  parts: { name: string; title: string; seconds: number }[];
}
