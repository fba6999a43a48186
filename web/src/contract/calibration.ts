/** The part of the data contract that `talus calibrate` has. */

export interface CalibratedQuantity {
  name: string;
  title: string;
  unit: string;
}

/** A fitted number of a soil, in `unit`. */
export interface CalibratedParameter {
  /** "materials.loess.kappa". */
  key: string;
  unit: string;
  start: number;
  value: number;
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
}
