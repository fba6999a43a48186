// SPDX-License-Identifier: MIT
/** Parallel lines and rings at a distance, with mitred corners. */
import { computeArea, distance, intersectSegments, listSegments, type Point } from "./plane";

interface Ray {
  at: Point;
  direction: Point;
  /** Length of the original side [m]. */
  length: number;
}

/** The crossing of two infinite lines; null for parallel ones. */
function crossRays(a: Ray, b: Ray): Point | null {
  const cross = a.direction[0] * b.direction[1] - a.direction[1] * b.direction[0];
  if (Math.abs(cross) < 1e-9) return null;
  const t = ((b.at[0] - a.at[0]) * b.direction[1] - (b.at[1] - a.at[1]) * b.direction[0]) / cross;
  return [a.at[0] + t * a.direction[0], a.at[1] + t * a.direction[1]];
}

const along = (p: Point, { at, direction }: Ray) => (p[0] - at[0]) * direction[0] + (p[1] - at[1]) * direction[1];
const endOf = ({ at, direction, length }: Ray): Point => [at[0] + length * direction[0], at[1] + length * direction[1]];

/** Corners between shifted sides; mitres longer than four times the shift are cut off by a side of their own. */
function joinRays(rays: readonly Ray[], closed: boolean, shift: number): Point[][] {
  return rays.map((ray, i) => {
    const next = rays[(i + 1) % rays.length]!;
    if (!closed && i === rays.length - 1) return [endOf(ray)];
    const corner = crossRays(ray, next);
    if (!corner) return distance(endOf(ray), next.at) < 1e-9 ? [endOf(ray)] : [endOf(ray), next.at];
    return distance(corner, endOf(ray)) > 4 * Math.abs(shift) && along(corner, ray) > ray.length ? [endOf(ray), next.at] : [corner];
  });
}

export function crossesItself(points: readonly Point[], closed: boolean): boolean {
  const sides = listSegments(points, closed);
  return sides.some((a, i) =>
    sides.slice(i + 2).some((b, k) => !(closed && i === 0 && i + 2 + k === sides.length - 1) && intersectSegments(a, b) !== null),
  );
}

/**
 * The parallel of a line at a distance [m], to its left where positive: above a line from left to right. Sides that vanish
 * are left out. Returns null where the result would cross itself or where nothing is left.
 */
export function offsetLine(points: readonly Point[], shift: number, closed = false): Point[] | null {
  let rays: Ray[] = listSegments(points, closed)
    .filter(([a, b]) => distance(a, b) > 1e-12)
    .map(([a, b]) => {
      const length = distance(a, b);
      const direction: Point = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
      return { at: [a[0] - shift * direction[1], a[1] + shift * direction[0]] as const, direction, length };
    });
  for (;;) {
    if (rays.length < (closed ? 3 : 1)) return null;
    const corners = joinRays(rays, closed, shift);
    const starts = rays.map((ray, i) => (i > 0 ? corners[i - 1]!.at(-1)! : closed ? corners.at(-1)!.at(-1)! : ray.at));
    // A side that has no length or runs backwards between its corners is gone; the worst one first, because its neighbours then lengthen.
    let worst = -1;
    let least = 1e-9;
    rays.forEach((ray, i) => {
      const left = along(corners[i]![0]!, ray) - along(starts[i]!, ray);
      if (left >= least) return;
      least = left;
      worst = i;
    });
    if (worst < 0) {
      const result = closed ? corners.flat() : [starts[0]!, ...corners.flat()];
      if (crossesItself(result, closed)) return null;
      const turned = closed && computeArea(result) * computeArea(points) <= 0;
      return turned ? null : result;
    }
    rays = rays.filter((_, i) => i !== worst);
  }
}

/** A ring at a distance [m] outside of another, inside where negative; null where nothing is left. */
export function offsetRing(ring: readonly Point[], outwards: number): Point[] | null {
  return offsetLine(ring, computeArea(ring) > 0 ? -outwards : outwards, true);
}
