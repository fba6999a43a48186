// SPDX-License-Identifier: MIT
/** What the report adds to the results of a study: its table in units of display, and what it shows of each variant. */
import type { DisplacementCurve, Motion } from "./results";
import type { Section } from "./run";
import type { Column } from "./units";

export interface StudyShown {
  columns: (Column & { shown: string[] })[];
  /** Of the variants, in their order. */
  rows: VariantShown[];
}

export interface VariantShown {
  warnings: string[];
  /** As in the variant's summary. */
  curve?: DisplacementCurve;
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
