// SPDX-License-Identifier: MIT
/** Tools for drawing a section: canvas, view, colours. */
import { report } from "../state";
import type { Camera } from "../viewer/camera";
import type { Pixel } from "../viewer/lines";
import type { Theme } from "../viewer/theme";

export interface Pen {
  context: CanvasRenderingContext2D;
  camera: Camera;
  theme: Theme;
  /** Device pixels per pixel. */
  density: number;
  dark: boolean;
  /** [m] → [px]. */
  place: (at: readonly number[]) => Pixel;
}

/** Corners [m]. */
export type Box = [number[], number[]];

/** The box around lists of points; null around none. */
export function findBox(lists: readonly (readonly (readonly number[])[])[]): Box | null {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (const list of lists)
    for (const point of list)
      for (const k of [0, 1]) {
        low[k] = Math.min(low[k]!, point[k]!);
        high[k] = Math.max(high[k]!, point[k]!);
      }
  return low[0]! <= high[0]! ? [low, high] : null;
}

/** Around the soil, or else around the model. */
export function findSoilBox(): Box {
  const { polygons, bounds } = report.value.model;
  return findBox(polygons.map((p) => p.points)) ?? [bounds[0].slice(0, 2), bounds[1].slice(0, 2)];
}

/** The smallest box around both. */
export function joinBoxes(a: Box, b: Box | null): Box {
  return b ? findBox([a, b])! : a;
}
