// SPDX-License-Identifier: MIT
/** The factor of safety in time. */
import type { Unit } from "./results";
import type { WaterMesh, WaterState } from "./water";

export interface Timeline {
  /** [s] */
  duration: number;
  /** The date of time 0, "2023-03-01"; null where none is given. */
  start: string | null;
  /** Of the times that are shown. */
  unit: Unit;
  /** A factor below it is failure. */
  target: number;
  /** When it fails, and when the factor is least, in words. */
  sentence: string;
  /** In time; the first one at 0. */
  factors: TimedFactor[];
  /** Where the water stood at these times; empty where it is not known. */
  states: WaterState[];
  /** The triangles of the fields of these states. */
  water_mesh?: WaterMesh;
  least: number | null;
  /** [s] */
  least_time: number | null;
  /** Largest estimate of what a straight line between two times is off, over the factor; null for given times. */
  distance: number | null;
  /**
   * Between `from` and `to` [s] the factor falls below the target; both were tried. With what searches scatter it falls
   * between `earliest` and `latest`; null: or not at all.
   */
  failure?: { from: number; to: number; earliest: number; latest: number | null };
  /** Volumes over the whole time [m³], in 2D per metre. */
  water: { inflow: number; outflow: number; runoff: number; standing: number; transpired: number; growth: number; error: number };
  /** Of the seepage. */
  steps: number;
  /** The largest error of one of them, by its prediction, as a head [m]. */
  step_error: number;
  seepage_seconds: number;
  search_seconds: number;
  /** Finite elements at later times. */
  elements?: TimedReduction[];
  /** Material points that took over, those of the report itself first. */
  releases?: Release[];
}

export interface TimedReduction {
  /** [s] */
  time: number;
  /** "6 h". */
  title: string;
  /** Of the results, inside the folder of the run. */
  folder: string;
  /** By flow rule; empty where there is no answer. `slip_line` [m]. */
  runs: { flow: "as_given" | "associated"; factor: number; slip_line: number[][] }[];
  /** Why there is no answer. */
  error: string | null;
}

export interface Release {
  /** [s] */
  time: number;
  /** "6 h". */
  title: string;
  /** Of slices at that time. */
  factor: number | null;
  /** Of the results, inside the folder of the run; empty: the run itself. */
  folder: string;
  /** What the points began with, or whether they came to rest before they were let go: "came to rest". */
  start: string;
  /** Why it did not end. */
  error: string | null;
  /** [m] */
  largest_displacement: number;
  /** [m³], in 2D per metre. */
  moved_volume: number;
  /** Advance of the front, with what the mesh leaves open: "1.3 ± 0.4 m". */
  front: string;
}

export interface TimedFactor {
  /** [s] */
  time: number;
  /** "6 h". */
  title: string;
  factor: number | null;
  /** Of slices, in words. */
  method: string;
  /** "critical polyline". */
  source: string;
  /** Why a search would refuse the surface; empty: it would not. */
  refusal: string;
  /** Of the slip surface that governs [m]. */
  points: number[][];
}
