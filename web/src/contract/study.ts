// SPDX-License-Identifier: MIT
/** What a study has: its rows, and what is read off all of them. */
import type { Curve, Motion, Section } from "./run";
import type { Sampling } from "./sampling";

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
      /** The method or criterion alone: "frozen". */
      by: string;
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

/** Displacement of each monitor [m] over time on the clock [s]. */
export interface MonitorPaths {
  time: number[];
  paths: { name: string; displacement: (number | null)[] }[];
}
