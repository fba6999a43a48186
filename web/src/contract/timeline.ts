// SPDX-License-Identifier: MIT
/** What the report adds to `timeline` of the results: times in words, and the packed fields of the water. */
import type { Unit } from "./results";
import type { WaterMesh, WaterShown } from "./water";

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
