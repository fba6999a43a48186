// SPDX-License-Identifier: MIT
/** Extent of the model, and spacing of its points. */
import type { Sequence } from "../contract";
import { report } from "../state";
import type { Vec } from "./camera";
import { measureArea } from "./cells";

export interface Extent {
  /** Corners of the box around the model and around the first and last frames [m]. */
  box: [Vec, Vec];
  /** Mean distance of the points [m]. */
  spacing: number;
}

/** Mean distance of points, from the cells of a grid that hold one: (volume / points)^(1 / dimension). */
export function measureSpacing(positions: ArrayLike<number>, dimension: number, cell: number): number {
  const cells = new Set<string>();
  const count = positions.length / dimension;
  for (let i = 0; i < count; ++i) {
    let key = "";
    for (let k = 0; k < dimension; ++k) key += Math.floor(positions[dimension * i + k]! / cell) + ",";
    cells.add(key);
  }
  return cell * Math.pow(cells.size / Math.max(1, count), 1 / dimension);
}

function findBox(positions: Float64Array, current: Sequence): [Vec, Vec] {
  const { model } = report.value;
  const low: Vec = [Infinity, Infinity, 0];
  const high: Vec = [-Infinity, -Infinity, 0];
  const include = (at: ArrayLike<number>) => {
    for (let k = 0; k < Math.min(3, at.length); ++k) {
      if (at[k]! < low[k]!) low[k] = at[k]!;
      if (at[k]! > high[k]!) high[k] = at[k]!;
    }
  };
  for (const polygon of model.polygons) polygon.points.forEach(include);
  for (const line of model.boundaries.flatMap((b) => b.lines)) line.forEach(include);
  const size = current.point_count * model.dimension;
  for (const frame of [0, current.frames.length - 1]) {
    const at = positions.subarray(frame * size, (frame + 1) * size);
    for (let i = 0; i < at.length; i += model.dimension) include(at.subarray(i, i + model.dimension));
  }
  if (model.dimension === 3) [low[2], high[2]] = [model.bounds[0][2] ?? 0, model.bounds[1][2] ?? 0];
  return [low, high];
}

/** `positions` [frame][point][dimension] [m]. */
export function measureExtent(positions: Float64Array, current: Sequence): Extent {
  const { dimension, mesh, polygons, bounds } = report.value.model;
  const first = positions.subarray(0, current.point_count * dimension);
  const depth = dimension === 3 ? bounds[1][2]! - bounds[0][2]! : 1;
  const soil = depth * polygons.reduce((sum, polygon) => sum + Math.abs(measureArea(polygon.points)), 0);
  const spacing =
    soil > 0
      ? Math.pow(soil / current.point_count, 1 / dimension)
      : measureSpacing(first, dimension, mesh.mean_size || 1);
  return { box: findBox(positions, current), spacing };
}
