// SPDX-License-Identifier: MIT
/** Sizes of the drawn points by their volume: cells in a section and spheres in space. */
import { computed } from "@preact/signals";

import { report } from "../state";
import { findCells, type Cells } from "./cells";
import { cut, inSpace } from "./settings";
import { frame, shown, takeFrame, takePositions, type Shown } from "./shown";

/** Spheres that fill the body need somewhat more than their volume: balls leave gaps. */
const sphereShare = 0.72;

/**
 * Side [m] of the square or cube of each point: its part of the body by its volume. The volume of points left out of
 * the report is distributed over those that are shown. A point without a volume has the mean size.
 */
export function distributeVolume(volumes: ArrayLike<number> | null, count: number, spacing: number, dimension: number) {
  const sizes = new Float32Array(count).fill(spacing);
  if (!volumes) return sizes;
  let [sum, found] = [0, 0];
  for (let i = 0; i < count; ++i) if (volumes[i]! > 0) [sum, found] = [sum + volumes[i]!, found + 1];
  if (!found) return sizes;
  for (let i = 0; i < count; ++i) {
    if (volumes[i]! > 0) sizes[i] = spacing * Math.pow((volumes[i]! * found) / sum, 1 / dimension);
  }
  return sizes;
}

/** Sizes of the shown frame's points [m]. */
const sizes = computed<Float32Array>(() => {
  const now = shown.value;
  if (!now) return new Float32Array();
  const count = now.sequence.point_count;
  const volumes = now.volumes && takeFrame(now.volumes, frame.value, count);
  return distributeVolume(volumes, count, now.spacing, report.value.model.dimension);
});

/** Numbers of cells that are kept, so that a second round of playing need not find them again. */
const kept = 1.5e6;
let cellsOf: { positions: Float64Array; frames: Map<number, Cells> } | null = null;

function lookUpCells(now: Shown, index: number): Cells {
  if (cellsOf?.positions !== now.positions) cellsOf = { positions: now.positions, frames: new Map() };
  let cells = cellsOf.frames.get(index);
  if (cells) return cells;
  const [low, high] = report.value.model.bounds;
  cells = findCells(takePositions(now, index), sizes.value, [low[0]!, low[1]!, high[0]!]);
  if (cellsOf.frames.size * now.sequence.point_count > kept) cellsOf.frames.clear();
  cellsOf.frames.set(index, cells);
  return cells;
}

/** Cells of the shown frame; null in a model in space. */
export const cells = computed<Cells | null>(() => {
  const now = shown.value;
  return now && report.value.model.dimension === 2 ? lookUpCells(now, frame.value) : null;
});

/** [point] radius [m] as in Body. */
export const radii = computed<Float32Array>(() => {
  const now = shown.value;
  if (!now) return new Float32Array();
  const count = now.sequence.point_count;
  const { dimension } = report.value.model;
  const positions = takePositions(now, frame.value);
  const values = takeFrame(now.values, frame.value, count);
  const flat = !inSpace.value && cells.value ? cells.value.radii : null;
  const sides = sizes.value;
  const [low, high] = now.box;
  /** Returns whether a coordinate is cut off by the planes that the reader has set along an axis. */
  const isCut = (place: number, k: number) => {
    const fraction = (place - low[k]!) / (high[k]! - low[k]! || 1);
    return fraction < cut.value[k]![0] - 1e-6 || fraction > cut.value[k]![1] + 1e-6;
  };
  const hasCut = dimension === 3 && cut.value.some(([from, to]) => from > 0 || to < 1);
  const found = new Float32Array(count);
  for (let i = 0; i < count; ++i) {
    if (Number.isNaN(positions[dimension * i]!)) continue;
    if (hasCut && [0, 1, 2].some((k) => isCut(positions[3 * i + k]!, k))) continue;
    const radius = flat ? flat[i]! : sphereShare * sides[i]!;
    found[i] = Number.isNaN(values[i]!) ? -radius : radius;
  }
  return found;
});

/** True if some point has no value of the field in the shown frame. */
export const hasNoValue = computed(() => radii.value.some((radius) => radius < 0));
