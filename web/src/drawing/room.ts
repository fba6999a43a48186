// SPDX-License-Identifier: MIT
/** Finds the place in a polygon with most space for a text. */

type Point = readonly number[];
export interface Room {
  at: [number, number];
  /** To the nearest edge [m]. */
  radius: number;
}

function isInside([x, y]: Point, points: readonly Point[]): boolean {
  let inside = false;
  points.forEach((a, i) => {
    const b = points[(i + 1) % points.length]!;
    if (a[1]! > y! === b[1]! > y!) return;
    if (x! < a[0]! + ((b[0]! - a[0]!) * (y! - a[1]!)) / (b[1]! - a[1]!)) inside = !inside;
  });
  return inside;
}

function measure(p: Point, points: readonly Point[]): number {
  let least = Infinity;
  points.forEach((a, i) => {
    const b = points[(i + 1) % points.length]!;
    const [dx, dy] = [b[0]! - a[0]!, b[1]! - a[1]!];
    const square = dx * dx + dy * dy || 1;
    const t = Math.min(1, Math.max(0, ((p[0]! - a[0]!) * dx + (p[1]! - a[1]!) * dy) / square));
    least = Math.min(least, Math.hypot(p[0]! - a[0]! - t * dx, p[1]! - a[1]! - t * dy));
  });
  return least;
}

const places = 24;
/** As a fraction of the width. */
const preferred = 0.15;
const known = new WeakMap<object, Room | null>();

/** Selects from a grid of places the one farthest from the edges and outside the polygons over it; null for none. */
export function findRoom(points: readonly Point[], over: readonly (readonly Point[])[]): Room | null {
  const kept = known.get(points);
  if (kept !== undefined) return kept;
  const low = [0, 1].map((k) => Math.min(...points.map((p) => p[k]!)));
  const high = [0, 1].map((k) => Math.max(...points.map((p) => p[k]!)));
  let best: Room | null = null;
  let most = 0;
  for (let i = 0; i < places; ++i)
    for (let j = 0; j < places; ++j) {
      const at: [number, number] = [
        low[0]! + ((i + 0.5) / places) * (high[0]! - low[0]!),
        low[1]! + ((j + 0.5) / places) * (high[1]! - low[1]!),
      ];
      if (!isInside(at, points) || over.some((other) => isInside(at, other))) continue;
      const radius = Math.min(measure(at, points), ...over.map((other) => measure(at, other)));
      // Among places with similar space, one left of the middle is preferred, where there are fewer surfaces and factors.
      const value = radius * (1 - 0.1 * Math.abs((at[0] - low[0]!) / (high[0]! - low[0]!) - preferred));
      if (!best || value > most) {
        best = { at, radius };
        most = value;
      }
    }
  known.set(points, best);
  return best;
}
