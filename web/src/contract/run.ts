// SPDX-License-Identifier: MIT
/** What the report adds to the results of a run, a study and a timeline: frames, tables over time, sections, times in words. */
import type { WaterMesh, WaterShown } from "./model";
import type { DisplacementCurve, Motion, Unit } from "./results";
import type { Column, PackedArray, PackedPlaces, TableColumn } from "./units";

/** Frames that belong together: the stages, the trials of the curve, one runout. */
export interface Sequence {
  /** "stages", "curve", "runout_1.75"; of points that a timeline released as well the folder, "released_later". */
  id: string;
  kind: "stages" | "curve" | "runout" | "variant";
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
  positions: PackedPlaces;
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

/** A table with a common abscissa: a history, a profile. */
export interface Table {
  /** "history", "monitors", "history_runout_1.75", "profile_runout_1.75". */
  id: string;
  title: string;
  kind: "history" | "monitors" | "ground";
  /** Id of the sequence that runs along the same time: "stages", "runout_1.75"; it may have no frames to show. */
  sequence: string;
  x: TableColumn;
  columns: TableColumn[];
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

export interface StudyShown {
  columns: (Column & { shown: string[] })[];
  /** Of the variants, in their order. */
  rows: VariantShown[];
  /** Of a back-analysis, in the order of its targets. */
  goals?: StudyGoal[];
}

/** A target of a back-analysis and the value of the key that reaches it, in the units of their columns. */
export interface StudyGoal {
  /** Names of the columns. */
  key: string;
  result: string;
  target: number;
  /** Null if no value was found. */
  value: number | null;
  /** Ends of the interval of the value; null if unknown. */
  low: number | null;
  high: number | null;
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

export interface TimelineShown {
  /** Of the times that are shown. */
  unit: Unit;
  /** When it fails, and when the factor is least, in words. */
  sentence: string;
  /** Times of the factors and of FEM: "6 h". */
  factors: string[];
  elements: string[];
  /** Of the states of the water, at the times of the factors. */
  states: WaterShown[];
  /** The triangles of the fields of these states. */
  water_mesh?: WaterMesh;
  releases: ReleaseShown[];
}

export interface ReleaseShown {
  title: string;
  /** What the points began with, or whether they came to rest before they were let go: "came to rest". */
  start: string;
  /** Advance of the front, with what the mesh leaves open: "1.3 ± 0.4 m". */
  front: string;
}
