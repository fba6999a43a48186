// SPDX-License-Identifier: MIT
/** Soil by itself: element tests, and the calibration on measured ones. */
import type { Column } from "./units";

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
  /** File of the picture, in the folder. */
  picture: string;
  /** Names of columns. */
  panels: { x: string; y: string; log_x: boolean }[];
  /** Numbers of its tests, and of each the number of its colour and of its dashes. */
  tests: number[];
  colour: number[];
  dash: number[];
}

/** The part of the data contract that `talus calibrate` has. */

export interface CalibratedQuantity {
  name: string;
  title: string;
  unit: string;
  kind: "strain" | "stress" | "other";
}

/** A fitted number of a soil, in `unit`. */
export interface CalibratedParameter {
  /** "materials.loess.kappa". */
  key: string;
  unit: string;
  start: number;
  value: number;
  /** As `--set` takes it. */
  text: string;
  low: number;
  high: number;
  /** Standard error; null where the curves do not tell it. */
  error: number | null;
  /** Whether it ended at an end of its range. */
  limit: "no" | "low" | "high";
}

/** A measured curve and what the model makes of it, in the units of x and y. */
export interface CalibratedCurve {
  test: string;
  x: CalibratedQuantity;
  y: CalibratedQuantity;
  at: number[];
  measured: number[];
  /** With the parameters at the start, and fitted. */
  before: number[];
  fitted: number[];
  /** The calculated curves, thinned: [x, y]. */
  line: [number, number][];
  line_before: [number, number][];
  /** Standard error of the measured values, as the case states it. */
  deviation: number;
  /** 0: shown, not fitted. */
  weight: number;
  /** Root mean square of the differences; mean and largest difference, calculated minus measured. */
  rms: number;
  rms_before: number;
  mean: number;
  largest: number;
  largest_at: number;
  /** Mean share of the abscissas that the test does not reach. */
  missing: number;
}

export interface CalibrationStart {
  from: number[];
  to: number[];
  /** Half the sum of the squares, in standard errors. */
  misfit: number;
  misfit_before: number;
  converged: boolean;
  iterations: number;
  message: string;
}

export interface Calibration {
  format: number;
  title: string;
  /** Of the starts. */
  seed: number;
  /** [s] */
  wall: number;
  parameters: CalibratedParameter[];
  curves: CalibratedCurve[];
  /** Null where a parameter has no standard error. */
  correlation: (number | null)[][];
  starts: CalibrationStart[];
  /** Number of the search that came nearest. */
  best: number;
  /** Measured values that were fitted. */
  values: number;
  /** Root of the sum of squares over values less parameters: differences in parts of the stated errors. */
  scatter: number;
  evaluations: number;
  tests: number;
  /** What to distrust. */
  findings: string[];
}
