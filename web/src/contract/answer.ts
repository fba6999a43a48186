// SPDX-License-Identifier: MIT
/** What was asked for: factors of safety, other numbers, the methods beside each other; and the case as it was understood. */
import type { CriterionKind, FactorMeasure, Flow, Method, SliceMethod, SurfaceSource, Unit } from "./results";

export interface Answer {
  /** The answer in words, the most important sentence first. */
  sentences: string[];
  factors: Factor[];
  results: ShownResult[];
}

/** A factor of safety by one method and criterion. */
export interface Factor {
  method: Method;
  /** The method of slices, flow rule or criterion; empty for a surface that LEM optimised. */
  by: SliceMethod | Flow | CriterionKind | "";
  /** Where its surface comes from: of LEM and FEM. */
  source?: SurfaceSource;
  /** Of FEM. */
  measure?: FactorMeasure;
  /** As in results: "factor_of_safety.frozen". */
  name: string;
  /** "rest or run-away at frozen geometry". */
  title: string;
  /** null: this criterion found none, `note` says why. */
  value: number | null;
  lower: number | null;
  upper: number | null;
  note: string;
  /** The one that the first sentence names; of limit analysis: whether one of its bounds governs. */
  main: boolean;
  /** What pore water did in the trials: absent where the ground is dry. */
  water?: "seeps" | "flows" | "held";
}

/** A number that a [[compare]] of the case may name. */
export interface ShownResult {
  name: string;
  title: string;
  /** Null where it is not determined; `text` then says why. */
  value: number | null;
  unit: Unit;
  /** With its unit and what the mesh leaves open, "1.3 ± 0.4 m", where that is known; "not determined (…)". */
  text?: string;
  kind:
    | "factor"
    | "yield_acceleration"
    | "over_design"
    | "runout"
    | "motion"
    | "stage"
    | "mesh"
    | "water"
    | "seepage"
    | "other";
  /** "moved_volume", "largest_suction". */
  quantity: string;
  /** Of LEM; empty for other results. */
  by: SliceMethod | "";
}

/** Of a case that asks for several methods, or for others than MPM. */
export interface MethodsRead {
  /** Name of the governing slip surface of LEM; absent where LEM has no factor. */
  governing?: string;
  /** The remarks by topic: "LEM", "Mechanism". */
  reading: { topic: string; sentences: string[] }[];
}

export interface InputValue {
  value: unknown;
  given: boolean;
  unit?: string;
}

export type InputTable = { [key: string]: InputTable | InputTable[] | InputValue };
