/**
 * The data contract between the C++ side (src/report/) and this page: what a report holds.
 *
 * `npm run schema` writes it as JSON Schema to contract/report.schema.json; the C++ tests hold what they write against
 * that schema, the tests of the page hold a real report against it too. Numbers are SI; `Unit.si` converts for display.
 */

import type { Calibration } from "./calibration";
import type { FiniteElements, MethodTable, Slices } from "./methods";
import type { Sampling } from "./sampling";
import type { SoilWater, Water } from "./water";

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

/** A report: of one run, of a study, or of element tests alone. */
export interface Report {
  format: 1;
  kind: "run" | "study" | "tests";
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
  /** Absent where the folder holds no element tests. */
  point_tests?: PointTests;
  /** Of `talus calibrate`. */
  calibration?: Calibration;
  /** Of a run with monitors. */
  motion?: Motion;
  /** Of a run whose case has sections. */
  sections?: Section[];
  /** Absent where the ground is dry. */
  water?: Water;
  /** Of a case that asks for several methods, or for others than material points. */
  method_table?: MethodTable;
  slices?: Slices;
  finite_elements?: FiniteElements;
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
  | "root_cohesion"
  | "modified_cam_clay"
  | "rooted_cam_clay"
  | "external_model"
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
  | "held_pressures"
  | "limit_equilibrium"
  | "slip_search"
  | "fellenius"
  | "bishop"
  | "janbu"
  | "spencer"
  | "morgenstern_price"
  | "yield_acceleration"
  | "finite_elements"
  | "finite_element_reduction"
  | "partial_factors"
  | "sampling";

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
  /** Vertical loads on the ground: x [m], and loads there [Pa]; linear between, down positive. */
  surcharges: { name: string; x: number[]; load: number[] }[];
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

/** When the monitored points began to move. */
export interface Motion {
  stage: string;
  /** Where the clock of onset and sections starts, in the time of the run [s]. */
  start: number;
  /** Displacement beyond which a point has begun to move [m]. */
  threshold: number;
  /** Onset on that clock [s], null for a point that did not move; displacement at the end [m]. */
  monitors: { name: string; onset: number | null; displacement: number | null }[];
  pattern: "none" | "single" | "together" | "upwards" | "downwards" | "mixed";
  sentence: string;
}

/** The fields along a line of the case at some of its stored frames. */
export interface Section {
  name: string;
  /** Ends of the line [m]. */
  from: number[];
  to: number[];
  /** Width of the band around the line whose points count [m]. */
  width: number;
  fields: { name: string; title: string; unit: Unit }[];
  profiles: {
    /** On the clock [s]. */
    time: number;
    /** From `from` [m]. */
    distance: number[];
    /** [field][row], SI; null where there is no value. */
    values: (number | null)[][];
  }[];
}

/** Displacement of each monitor [m] over time on the clock [s]. */
export interface MonitorPaths {
  time: number[];
  paths: { name: string; displacement: (number | null)[] }[];
}

/** Element tests: one point of soil each, without a mesh. */
export interface PointTests {
  tests: PointTest[];
  groups: PointGroup[];
}

export interface PointTest {
  name: string;
  material: string;
  /** "drained triaxial compression". */
  kind: string;
  /** "from 100 kPa all round to an axial strain of 25 %, strain-controlled". */
  path: string;
  /** What the test changes of its material: "root_content = 0.44". */
  set: string;
  /** Why it ended before its goal; empty when it did not. */
  stopped: string;
  /** Largest deviatoric stress [Pa], and the axial (of simple shear: shear) strain there [-]. */
  peak_q: number;
  peak_q_strain: number;
  /** Of the last row: stresses [Pa]. */
  end: { q: number; p: number; volumetric_strain: number; void_ratio: number; preconsolidation: number };
  /** What the diagrams show; all of one length. */
  columns: Column[];
}

/** Tests of one kind of apparatus, and the diagrams that show them. */
export interface PointGroup {
  id: string;
  title: string;
  /** Names of columns. */
  panels: { x: string; y: string; log_x: boolean }[];
  /** Numbers of its tests, and of each the number of its colour and of its dashes. */
  tests: number[];
  colour: number[];
  dash: number[];
}

export interface Study {
  /** Keys that are varied, with the values' texts. */
  vary: { key: string; values: string[] }[];
  mode: string;
  columns: { name: string; title: string; unit: string; shown: string[]; values: (number | null)[] }[];
  /** Of mode "sample". */
  sampling?: Sampling;
  /** Factors over a size, and at size zero. */
  extrapolation?: {
    key: string;
    unit: string;
    factors: {
      /** "FoS, frozen". */
      criterion: string;
      /** The other keys: "smoothing = stable"; empty when there are none. */
      variant: string;
      /** From coarse to fine. */
      sizes: number[];
      factors: number[];
      /** Of the line through all, of that through the finest two, and with the order that fits best. */
      linear: number;
      standard_error: number | null;
      finest_pair: number;
      order: number | null;
      by_order: number | null;
    }[];
  };
  /** Name of the variant that displacements are divided by; empty where nothing is. */
  reference: string;
  rows: StudyRow[];
}

export interface StudyRow {
  name: string;
  status: string;
  reason: string;
  warnings: string[];
  curve?: Curve;
  motion?: Motion;
  paths?: MonitorPaths;
  sections?: Section[];
  /** Its frames in the report's sequences, their times on the clock; `pictures` are those that stand side by side. */
  frames?: { sequence: string; clock: number[]; pictures: number[] };
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
