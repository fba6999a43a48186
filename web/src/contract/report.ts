// SPDX-License-Identifier: MIT
/**
 * The data contract between the C++ side (src/report/) and this page: what a report holds.
 *
 * `npm run schema` writes it as JSON Schema to contract/report.schema.json; the C++ tests hold what they write against
 * that schema, the tests of the page hold a real report against it too. Numbers are SI; `Unit.si` converts for display.
 */
import type { Answer, Comparison } from "./answer";
import type { BoundsDrawn } from "./bounds";
import type { ElementsDrawn } from "./elements";
import type { InputTable, Project, Provenance, Timing } from "./head";
import type { Calibration, PointTests } from "./laboratory";
import type { MethodsRead } from "./methods";
import type { Model } from "./model";
import type { RunResult, StudyResult, Unit } from "./results";
import type { Curve, Motion, Section, Sequence, Table } from "./run";
import type { Slices } from "./slices";
import type { Study } from "./study";
import type { Timeline } from "./timeline";
import type { Water } from "./water";

/** What the program computed: the files of the results folder as they are. */
export interface Results {
  /** summary.json; of a study that of its first variant. */
  result: RunResult;
  study_result?: StudyResult;
}

export type Report = ReportDocument & Results;

/** What the report adds to the results: sentences, derived values and packed arrays. */
export interface ReportDocument {
  format: 1;
  kind: "run" | "study" | "tests";
  project: Project;
  status: "finished" | "interrupted" | "unstable" | "failed" | "unfinished";
  /** Why the run did not finish. */
  error?: string;
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
  methods_read?: MethodsRead;
  slices?: Slices;
  finite_elements?: ElementsDrawn;
  proven_bounds?: BoundsDrawn;
  /** Of a case with a timeline. */
  timeline?: Timeline;
  /** Sentences: what the numbers rest on, and where they end. */
  assumptions: string[];
  /** Names of the paragraphs of the methods section that apply. */
  methods: MethodParagraph[];
  /** The case as it was understood: nested tables whose leaves are InputValue. */
  input: InputTable;
  provenance: Provenance;
  timing: Timing;
}

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
