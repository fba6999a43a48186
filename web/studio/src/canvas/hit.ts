// SPDX-License-Identifier: MIT
/** What the canvas shows and where: the extent, the ground, and what lies under the pointer. */
import { pointsOf, segmentsOf } from "../document/vertices";
import { findTop, isInside, type Point, projectOnSegment } from "../geometry/plane";
import { chains, draft, loads, regions, section, vertices } from "../state";
import { fit } from "./camera";

export type Hit =
  | { kind: "vertex"; at: Point }
  | { kind: "load"; index: number; end: number }
  | { kind: "side"; chain: string; index: number; at: Point }
  | { kind: "region"; id: string }
  | { kind: "nothing" };

/** The ground above x, by the highest side of all regions; null outside. */
export function findGround(x: number): number | null {
  return findTop(x, regions.value.flatMap(({ points }) => points.map((a, i) => [a, points[(i + 1) % points.length]!] as const)));
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
  least = 0.8 * reach;
  for (const chain of chains.value)
    segmentsOf(chain).forEach((side, index) => {
      const { at, distance } = projectOnSegment(p, side);
      if (distance > least) return;
      least = distance;
      best = { kind: "side", chain: chain.id, index, at };
    });
  if (best.kind !== "nothing") return best;
  // Later regions replace earlier ones.
  const region = regions.value.findLast(({ points }) => isInside(p, points));
  return region ? { kind: "region", id: region.id } : { kind: "nothing" };
}

/** Shows all points of the case and of what is being drawn. */
export function fitAll(): void {
  const own = chains.value.filter(({ kind }) => kind !== "box").flatMap(pointsOf);
  const built = section.value?.regions.flatMap(({ polygon }) => polygon) ?? [];
  fit([...own, ...built, ...draft.value]);
}
