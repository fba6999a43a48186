// SPDX-License-Identifier: MIT
/** What the canvas shows and where: the extent, the ground, and what lies under the pointer. */
import { pointsOf, segmentsOf } from "../document/vertices";
import { background, place } from "../background/background";
import type { Part } from "../document/parts";
import { findTop, isInside, listSegments, type Point, projectOnSegment } from "../geometry/plane";
import { chains, draft, loads, parts, regions, section, vertices } from "../state";
import { fit } from "./camera";

/** What of a part is dragged: an end of its range, a level, a radius. */
export type Grip = { of: "x" | "level"; index: number } | { of: "radius" };

export type Hit =
  | { kind: "vertex"; at: Point }
  | { kind: "load"; index: number; end: number }
  | { kind: "part"; id: string; grip: Grip | null }
  | { kind: "side"; chain: string; index: number; at: Point }
  | { kind: "region"; id: string }
  | { kind: "nothing" };

/** The ground above x, by the highest side of all regions; null outside. */
export function findGround(x: number): number | null {
  return findTop(x, regions.value.flatMap(({ points }) => points.map((a, i) => [a, points[(i + 1) % points.length]!] as const)));
}

/** The end of a range on the ground near a point. */
function findRangeEnd(p: Point, reach: number): Hit | null {
  for (const { id, kind, x } of parts.value)
    for (const [index, { value }] of x.entries()) {
      const top = kind === "entry" || kind === "exit" ? findGround(value) : null;
      if (top !== null && Math.abs(value - p[0]) <= reach && Math.abs(p[1] - top) <= 1.6 * reach) return { kind: "part", id, grip: { of: "x", index } };
    }
  return null;
}

/** Ends of the horizontal lines of a part along x [m]. */
export function findWidth(part: Part): readonly [number, number] {
  if (part.x.length === 2) return [part.x[0]!.value, part.x[1]!.value];
  const all = regions.value.flatMap(({ points }) => points.map((p) => p[0]));
  return all.length ? [Math.min(...all), Math.max(...all)] : [0, 0];
}

/** A condition beside its line, a range on the ground, a level or a circle near a point. */
function findPart(p: Point, reach: number): Hit | null {
  for (const part of parts.value) {
    const { id, circle, levels, line, x } = part;
    if (circle && Math.abs(Math.hypot(p[0] - circle.centre[0], p[1] - circle.centre[1]) - circle.radius.value) <= 0.8 * reach) return { kind: "part", id, grip: { of: "radius" } };
    const [low, high] = findWidth(part);
    const within = p[0] >= low - reach && p[0] <= high + reach;
    for (const [index, { value }] of levels.entries()) if (within && Math.abs(p[1] - value) <= 0.8 * reach) return { kind: "part", id, grip: { of: "level", index } };
    const isRange = part.kind === "entry" || part.kind === "exit";
    for (const [index, { value }] of x.entries())
      if (!isRange && Math.abs(p[0] - value) <= 0.8 * reach && levels[0] && Math.abs(p[1] - levels[0].value) <= 4 * reach) return { kind: "part", id, grip: { of: "x", index } };
    const top = isRange && within ? findGround(p[0]) : null;
    if (top !== null && p[1] > top && p[1] < top + 1.6 * reach) return { kind: "part", id, grip: null };
    if (listSegments(line, false).some((side) => projectOnSegment(p, side).distance <= 2.2 * reach)) return { kind: "part", id, grip: null };
  }
  return null;
}

/** Selects by distance [m]; vertices come before loads, loads before sides. */
export function findHit(p: Point, reach: number): Hit {
  let best: Hit = { kind: "nothing" };
  let least = reach;
  for (const vertex of vertices.value) {
    if (vertex.corners.every(({ chain }) => chains.value[chain]!.kind === "box")) continue;
    const far = Math.hypot(vertex.at[0] - p[0], vertex.at[1] - p[1]);
    if (far > least) continue;
    least = far;
    best = { kind: "vertex", at: vertex.at };
  }
  if (best.kind !== "nothing") return best;
  loads.value.forEach(({ x }, index) =>
    x.forEach(({ value }, end) => {
      const top = findGround(value);
      if (top === null || Math.abs(value - p[0]) > least || p[1] < top - reach || p[1] > top + 4 * reach) return;
      least = Math.abs(value - p[0]);
      best = { kind: "load", index, end };
    }),
  );
  if (best.kind !== "nothing") return best;
  const end = findRangeEnd(p, reach);
  if (end) return end;
  least = 0.8 * reach;
  for (const chain of chains.value) {
    if (chain.corners && chain.kind !== "box") {
      const [[x0, y0], [x1, y1]] = pointsOf(chain) as [Point, Point];
      const corners: Point[] = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
      for (const side of listSegments(corners, true)) {
        const { at, distance } = projectOnSegment(p, side);
        if (distance <= least) best = { kind: "side", chain: chain.id, index: 0, at };
      }
    }
    segmentsOf(chain).forEach((side, index) => {
      const { at, distance } = projectOnSegment(p, side);
      if (distance > least) return;
      least = distance;
      best = { kind: "side", chain: chain.id, index, at };
    });
  }
  if (best.kind !== "nothing") return best;
  const part = findPart(p, reach);
  if (part) return part;
  // Later regions replace earlier ones.
  const region = regions.value.findLast(({ points }) => isInside(p, points));
  return region ? { kind: "region", id: region.id } : { kind: "nothing" };
}

/** Shows all points of the case and of what is being drawn. */
export function fitAll(): void {
  const own = chains.value.filter(({ kind }) => kind !== "box").flatMap(pointsOf);
  const built = section.value?.regions.flatMap(({ polygon }) => polygon) ?? [];
  const found = background.value?.shown ? background.value : null;
  const picture = found ? [[0, 0], [found.width, 0], [found.width, found.height], [0, found.height]].map((pixel) => place(found, pixel as [number, number])) : [];
  fit([...own, ...built, ...picture, ...draft.value]);
}
