// SPDX-License-Identifier: MIT
/** Points, segments and rings in the plane [m]. */
export type Point = readonly [number, number];
export type Segment = readonly [Point, Point];

export const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The point of a segment nearest to `p`, and its fraction of the way from the first end to the second. */
export function projectOnSegment(p: Point, [a, b]: Segment): { at: Point; fraction: number; distance: number } {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dy * dy;
  const fraction = square > 0 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square)) : 0;
  const at: Point = [a[0] + fraction * dx, a[1] + fraction * dy];
  return { at, fraction, distance: distance(p, at) };
}

/** The crossing of two segments, ends included; null for parallel ones. */
export function intersectSegments([a, b]: Segment, [c, d]: Segment): { at: Point; s: number; t: number } | null {
  const [rx, ry] = [b[0] - a[0], b[1] - a[1]];
  const [qx, qy] = [d[0] - c[0], d[1] - c[1]];
  const cross = rx * qy - ry * qx;
  if (Math.abs(cross) <= 1e-12 * Math.hypot(rx, ry) * Math.hypot(qx, qy)) return null;
  const s = ((c[0] - a[0]) * qy - (c[1] - a[1]) * qx) / cross;
  const t = ((c[0] - a[0]) * ry - (c[1] - a[1]) * rx) / cross;
  const slack = 1e-9;
  if (s < -slack || s > 1 + slack || t < -slack || t > 1 + slack) return null;
  return { at: [a[0] + s * rx, a[1] + s * ry], s, t };
}

/** Positive for counter-clockwise rings [m²]. */
export function computeArea(ring: readonly Point[]): number {
  let twice = 0;
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length]!;
    twice += a[0] * b[1] - b[0] * a[1];
  });
  return twice / 2;
}

export function isInside([x, y]: Point, ring: readonly Point[]): boolean {
  let inside = false;
  ring.forEach((a, i) => {
    const b = ring[(i + 1) % ring.length]!;
    if (a[1] > y !== b[1] > y && x < a[0] + ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1])) inside = !inside;
  });
  return inside;
}

export function listSegments(points: readonly Point[], closed: boolean): Segment[] {
  const count = closed ? points.length : points.length - 1;
  return Array.from({ length: Math.max(0, count) }, (_, i) => [points[i]!, points[(i + 1) % points.length]!] as const);
}

/** Whether `p` lies on a segment but on neither end, within `tolerance` [m]. */
export function isWithinSegment(p: Point, segment: Segment, tolerance: number): boolean {
  if (distance(p, segment[0]) <= tolerance || distance(p, segment[1]) <= tolerance) return false;
  return projectOnSegment(p, segment).distance <= tolerance;
}

/** Ends of all points: x and y from least to largest; null without points. */
export function findExtent(points: Iterable<Point>): { low: Point; high: Point } | null {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    x0 = Math.min(x0, x);
    x1 = Math.max(x1, x);
    y0 = Math.min(y0, y);
    y1 = Math.max(y1, y);
  }
  return x1 >= x0 ? { low: [x0, y0], high: [x1, y1] } : null;
}

/** The highest point of segments above x; null where there is none. */
export function findTop(x: number, segments: readonly Segment[]): number | null {
  let top: number | null = null;
  for (const [a, b] of segments) {
    const [low, high] = a[0] < b[0] ? [a, b] : [b, a];
    if (x < low[0] || x > high[0]) continue;
    const y = high[0] > low[0] ? low[1] + ((x - low[0]) / (high[0] - low[0])) * (high[1] - low[1]) : Math.max(a[1], b[1]);
    if (top === null || y > top) top = y;
  }
  return top;
}
