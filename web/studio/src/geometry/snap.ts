// SPDX-License-Identifier: MIT
/** Snapping: the vertex, crossing, line or grid point near the pointer that a drawn point takes. */
import { distance, intersectSegments, type Point, projectOnSegment, type Segment } from "./plane";

export type SnapKind = "vertex" | "intersection" | "line" | "aligned" | "grid" | "free";

export interface Snapped {
  at: Point;
  kind: SnapKind;
}

export interface SnapTargets {
  vertices: readonly Point[];
  segments: readonly Segment[];
  /** Distance of the lines of the grid [m]; 0 for no grid. */
  grid: number;
  /** Size of the unit of display [m], whose decimals are rounded; 1 if missing. */
  unit?: number;
  /** The place where a drag began, or the last drawn point: the next one is level with it or above it where that is near. */
  anchor?: Point | null;
}

/** Rounds away what a pixel cannot show: to the power of ten at or below `step` [m]. */
export function roundTo(value: number, step: number, unit = 1): number {
  const decimals = Math.min(9, Math.max(0, -Math.floor(Math.log10(step / unit) + 1e-9)));
  const rounded = Number((value / unit).toFixed(decimals)) * unit;
  return (unit === 1 ? rounded : Number(rounded.toFixed(9))) + 0;
}

function findNearest(points: readonly Point[], to: Point, radius: number): Point | null {
  let best: Point | null = null;
  let least = radius;
  for (const point of points) {
    const far = distance(point, to);
    if (far > least) continue;
    best = point;
    least = far;
  }
  return best;
}

/**
 * The snapped point within `radius` [m] of the pointer: a vertex before a crossing, before a line (where it crosses a line of
 * the grid if that is near), before a place level with or above the anchor, before the grid. Without any, the pointer rounded to `step` [m].
 */
export function snap(pointer: Point, targets: SnapTargets, radius: number, step: number): Snapped {
  const vertex = findNearest(targets.vertices, pointer, radius);
  if (vertex) return { at: vertex, kind: "vertex" };
  const near = targets.segments
    .map((segment) => ({ segment, ...projectOnSegment(pointer, segment) }))
    .filter((found) => found.distance <= radius)
    .sort((a, b) => a.distance - b.distance);
  const few = near.slice(0, 12).map((found) => found.segment);
  const crossings = few.flatMap((a, i) => few.slice(i + 1).flatMap((b) => listCrossing(a, b)));
  const crossing = findNearest(crossings, pointer, radius);
  if (crossing) return { at: crossing, kind: "intersection" };
  const { grid, unit = 1 } = targets;
  if (near[0]) {
    const onGrid = grid > 0 ? findNearest(crossGrid(near[0].segment, pointer, grid, unit), pointer, radius) : null;
    return { at: onGrid ?? near[0].at, kind: "line" };
  }
  const aligned = alignWith(targets, pointer, radius, step);
  if (aligned) return { at: aligned, kind: "aligned" };
  if (grid > 0) {
    const at: Point = [roundTo(Math.round(pointer[0] / grid) * grid, grid / 10, unit), roundTo(Math.round(pointer[1] / grid) * grid, grid / 10, unit)];
    if (distance(at, pointer) <= radius) return { at, kind: "grid" };
  }
  return { at: [roundTo(pointer[0], step, unit), roundTo(pointer[1], step, unit)], kind: "free" };
}

/** The place near the pointer with the x or y of the anchor; the other coordinate is on the grid where that is near. */
function alignWith({ anchor, grid, unit = 1 }: SnapTargets, pointer: Point, radius: number, step: number): Point | null {
  if (!anchor) return null;
  const [dx, dy] = [Math.abs(pointer[0] - anchor[0]), Math.abs(pointer[1] - anchor[1])];
  if (Math.min(dx, dy) > radius) return null;
  const place = (value: number) => {
    const level = grid > 0 ? roundTo(Math.round(value / grid) * grid, grid / 10, unit) : value;
    return Math.abs(level - value) <= radius ? level : roundTo(value, step, unit);
  };
  return dy <= dx ? [place(pointer[0]), anchor[1]] : [anchor[0], place(pointer[1])];
}

function listCrossing(a: Segment, b: Segment): Point[] {
  const found = intersectSegments(a, b);
  return found ? [found.at] : [];
}

/** Where a segment crosses the two lines of the grid nearest to a point. */
function crossGrid([a, b]: Segment, to: Point, grid: number, unit: number): Point[] {
  const found: Point[] = [];
  for (const k of [0, 1] as const) {
    const level = roundTo(Math.round(to[k] / grid) * grid, grid / 10, unit);
    const span = b[k] - a[k];
    const t = span ? (level - a[k]) / span : -1;
    if (t < 0 || t > 1) continue;
    const other = a[1 - k]! + t * (b[1 - k]! - a[1 - k]!);
    found.push(k === 0 ? [level, other] : [other, level]);
  }
  return found;
}
