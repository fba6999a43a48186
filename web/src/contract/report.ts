// SPDX-License-Identifier: MIT
/**
 * The data contract between the program (src/report/) and this page: the results as they are, and beside them what the
 * report adds. The types of the results are generated from contract/results.schema.json (`npm run types`).
 *
 * `npm run schema` writes ReportDocument as JSON Schema to contract/report.schema.json; the C++ tests hold what they
 * write against both schemas, the tests of the page hold a real report against them too. Numbers are SI; `Unit.si`
 * converts for display.
 */
import type { Answer, InputTable, MethodsRead } from "./answer";
import type { BoundsDrawn, ElementsDrawn, ReductionSoFar, Slices, StagesDrawn } from "./drawn";
import type { Model, Water } from "./model";
import type { Calibration, Method, PointTests, RunResult, StudyResult, Unit } from "./results";
import type { Section, Sequence, StudyShown, Table, TimelineShown } from "./run";
import type { Column } from "./units";

/** What the program computed: the files of the results folder. */
export interface Results {
  /** summary.json; of a study what stands for all variants: the head of the first one. */
  result: Omit<RunResult, "input"> & { input: InputTable };
  study_result?: StudyResult;
  /** Absent where the folder holds no element tests. */
  point_tests?: PointTests;
  /** Of `talus calibrate`. */
  calibration?: Calibration;
}

/** What the report adds to the results: sentences, derived values and packed arrays. */
export interface ReportDocument {
  kind: "run" | "study" | "tests";
  title: string;
  /** Of the results, without its path. */
  folder: string;
  /** `line_force`, and in 2D `volume` and `flow` [m³/s]: per metre or foot of thickness. */
  units: {
    length: Unit;
    displacement: Unit;
    stress: Unit;
    line_force: Unit;
    volume: Unit;
    flow: Unit;
    speed: Unit;
  };
  /** Titles of the methods as headings: "LEM", "Limit analysis". */
  method_titles: Record<Method, string>;
  answer: Answer;
  warnings: string[];
  model: Model;
  sequences: Sequence[];
  tables: Table[];
  study?: StudyShown;
  /** What the diagrams of each element test show; the columns of a test have one length. */
  point_columns?: Column[][];
  /** Section with water, loads and conditions, as SVG; absent in 3D. */
  input_picture?: string;
  /** Of a run whose case has sections. */
  sections?: Section[];
  /** Absent where the ground is dry. */
  water?: Water;
  methods_read?: MethodsRead;
  slices?: Slices;
  finite_elements?: ElementsDrawn;
  proven_bounds?: BoundsDrawn;
  /** Of stages of construction. */
  construction_stages?: StagesDrawn;
  /** Of a run in progress. */
  reduction?: ReductionSoFar;
  /** Of a case with a timeline. */
  timeline?: TimelineShown;
  /** Sentences: what the numbers rest on, and where they end. */
  assumptions: string[];
  /** Names of the paragraphs of the methods section that apply. */
  methods: MethodParagraph[];
}

export type Report = ReportDocument & Results;

export type MethodParagraph =
  | "material_point_method"
  | "time_step"
  | "mixed_integration"
  | "point_integration"
  | "strain_smoothing"
  | "stable_smoothing"
  | "local_damping"
  | "mass_scaling"
  | "mohr_coulomb"
  | "drucker_prager"
  | "softening"
  | "bedding"
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
  | "seeping"
  | "soil_water"
  | "pressure_smoothing"
  | "hydraulic_conditions"
  | "steady_seepage"
  | "held_pressures"
  | "limit_equilibrium"
  | "slip_search"
  | "rapid_drawdown"
  | "fellenius"
  | "bishop"
  | "janbu"
  | "spencer"
  | "morgenstern_price"
  | "force_equilibrium"
  | "yield_acceleration"
  | "finite_elements"
  | "finite_element_reduction"
  | "limit_analysis"
  | "partial_factors"
  | "sampling";
