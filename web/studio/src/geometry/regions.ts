// SPDX-License-Identifier: MIT
/** Regions: split by a line, and cut by a new region. */
import clipping from "polygon-clipping";

import { computeArea, distance, intersectSegments, isInside, listSegments, type Point } from "./plane";

/** Crossings of a polyline with a ring, in the order of the polyline. */
function listCrossings(ring: readonly Point[], line: readonly Point[], tolerance: number) {
  const found: { at: Point; along: number; edge: number; fraction: number }[] = [];
  listSegments(line, false).forEach((piece, i) =>
    listSegments(ring, true).forEach((edge, k) => {
      const crossing = intersectSegments(piece, edge);
      if (!crossing) return;
      const { at, s, t } = crossing;
      const known = found.some((other) => distance(other.at, at) <= tolerance);
      if (!known) found.push({ at, along: i + s, edge: k, fraction: Math.min(1, Math.max(0, t)) });
    }),
  );
  return found.sort((a, b) => a.along - b.along);
}

/** The corners of a ring after place `from` up to place `to`, in the order of the ring; a place is an edge and a fraction. */
function walk(ring: readonly Point[], from: number, to: number): Point[] {
  const result: Point[] = [];
  const end = to > from ? to : to + ring.length;
  for (let k = Math.floor(from) + 1; k <= end; ++k) if (k > from && k < end) result.push(ring[k % ring.length]!);
  return result;
}

function removeDoubles(ring: readonly Point[], tolerance: number): Point[] {
  return ring.filter((p, i) => distance(p, ring[(i + ring.length - 1) % ring.length]!) > tolerance);
}

/**
 * Splits a ring along the first part of a polyline that crosses it from side to side. Returns the two rings, or null where
 * the line does not cross the ring.
 */
export function splitRing(ring: readonly Point[], line: readonly Point[], tolerance = 1e-6): [Point[], Point[]] | null {
  const crossings = listCrossings(ring, line, tolerance);
  for (let i = 0; i + 1 < crossings.length; ++i) {
    const [a, b] = [crossings[i]!, crossings[i + 1]!];
    const between = line.filter((_, k) => k > a.along && k < b.along);
    const path = [a.at, ...between, b.at];
    const middle: Point = [(path[0]![0] + path[1]![0]) / 2, (path[0]![1] + path[1]![1]) / 2];
    if (!isInside(middle, ring)) continue;
    const [pa, pb] = [a.edge + a.fraction, b.edge + b.fraction];
    const first = removeDoubles([...path, ...walk(ring, pb, pa)], tolerance);
    const second = removeDoubles([...path.toReversed(), ...walk(ring, pa, pb)], tolerance);
    const least = tolerance * Math.sqrt(Math.abs(computeArea(ring)));
    if (Math.min(Math.abs(computeArea(first)), Math.abs(computeArea(second))) > least) return [first, second];
  }
  return null;
}

const toRing = (ring: readonly Point[]): [number, number][] => ring.map(([x, y]) => [x, y]);

/** Whether `inner` lies wholly inside `outer`, its boundary included. */
export function isCovered(inner: readonly Point[], outer: readonly Point[]): boolean {
  const rest = clipping.difference([toRing(inner)], [toRing(outer)]);
  const left = rest.flat().reduce((sum, ring) => sum + Math.abs(computeArea(ring)), 0);
  return left <= 1e-9 * Math.abs(computeArea(inner));
}

/**
 * The rest of a region under a new one: null where it changes nothing (no overlap, or the new one lies inside, where it replaces the
 * other as the case file has it), else the rings that are left, none where everything is covered.
 */
export function cutRing(ring: readonly Point[], cutter: readonly Point[]): Point[][] | null {
  const common = clipping.intersection([toRing(ring)], [toRing(cutter)]);
  const area = common.flat().reduce((sum, part) => sum + Math.abs(computeArea(part)), 0);
  if (area <= 1e-9 * Math.abs(computeArea(ring))) return null;
  const rest = clipping.difference([toRing(ring)], [toRing(cutter)]);
  // A hole: the new region lies inside.
  if (rest.some((polygon) => polygon.length > 1)) return null;
  return rest.map((polygon) => removeDoubles(polygon[0]!.slice(0, -1), 1e-9));
}
