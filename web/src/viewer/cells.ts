// SPDX-License-Identifier: MIT
/** The body of a section from its points: each pixel belongs to the nearest point, and it ends where soil ends. */
import Delaunator from "delaunator";

export interface Cells {
  /** [point] how far the point's cell reaches [m]; 0 for a point that is not there. */
  radii: Float32Array;
  /** [point] within this distance [m] a cell belongs to the body: anywhere inside, half a point near the surface. */
  reach: Float32Array;
  /** Corners of triangles that cover the rest of the body, near its surface, x y each [m]. */
  cover: Float64Array;
  /** Closed lines around the body and around its larger gaps [m]. */
  outlines: [number, number][][];
}

/** Gaps that are wider than three points are gaps, narrower ones lie within solid soil. */
const widestCell = 1.5;

/** Rings of points along the surface whose triangles are needed to find the border of the body. */
const surfaceRings = 2;

/** Lines around less than this many point areas are not worth drawing. */
const smallestLoop = 6;

/**
 * Triangles of the Delaunay triangulation without the long ones (an alpha shape), widened by half a point where they
 * end: points are within the soil, not at its surface. As far as its points' triangles go a cell reaches to their
 * circumcentres, so that no pixel of the body is left out, and no cell is drawn larger than needed.
 *
 * `positions` [point][2] [m], NaN for a point that is not there; `sizes` [point] side of the square that a point stands
 * for [m]; `walls`: left, lower and right ends [m], which nothing passes.
 */
export function findCells(
  positions: ArrayLike<number>,
  sizes: Float32Array,
  walls: readonly number[] = [-Infinity, -Infinity, Infinity],
): Cells {
  const points: number[] = [];
  for (let i = 0; i < sizes.length; ++i) if (!Number.isNaN(positions[2 * i]!)) points.push(i);
  const at = new Float64Array(2 * points.length);
  points.forEach((i, k) => ((at[2 * k] = positions[2 * i]!), (at[2 * k + 1] = positions[2 * i + 1]!)));
  const { triangles, halfedges } = new Delaunator(at);

  const radii = new Float32Array(sizes.length);
  const reach = sizes.map((side) => side / 2);
  const size = (k: number) => sizes[points[k]!]!;
  const widen = (k: number, radius: number) => {
    const i = points[k]!;
    if (radius > radii[i]!) radii[i] = radius;
  };
  for (const i of points) radii[i] = reach[i]!;

  const solid = new Uint8Array(triangles.length / 3);
  const cover: number[] = [];
  for (let t = 0; t < solid.length; ++t) {
    const a = triangles[3 * t]!;
    const b = triangles[3 * t + 1]!;
    const c = triangles[3 * t + 2]!;
    const radius = measureCircumradius(at, a, b, c);
    if (!(radius < widestCell * Math.max(size(a), size(b), size(c)))) continue;
    solid[t] = 1;
    widen(a, radius);
    widen(b, radius);
    widen(c, radius);
  }

  const isSolid = (e: number) => e >= 0 && solid[Math.floor(e / 3)] === 1;
  const isEnd = (e: number) => isSolid(e) && !isSolid(halfedges[e]!);
  const next = (e: number) => (e % 3 === 2 ? e - 2 : e + 1);
  /** The edge of the body that continues at the end of this one. */
  const follow = (e: number) => {
    let f = next(e);
    while (!isEnd(f)) f = next(halfedges[f]!);
    return f;
  };
  /** Direction out of the body, of length 1. */
  const findNormal = (e: number): [number, number] => {
    const [a, b, c] = [triangles[e]!, triangles[next(e)]!, triangles[next(next(e))]!];
    const [x, y] = [at[2 * b + 1]! - at[2 * a + 1]!, at[2 * a]! - at[2 * b]!];
    const inwards = (at[2 * c]! - at[2 * a]!) * x + (at[2 * c + 1]! - at[2 * a + 1]!) * y > 0;
    const length = (Math.hypot(x, y) || 1) * (inwards ? -1 : 1);
    return [x / length, y / length];
  };
  /** The corner between two edges of the body, moved outwards by half a point. */
  const moveOut = (before: number, after: number): [number, number] => {
    const [n, m] = [findNormal(before), findNormal(after)];
    const k = triangles[after]!;
    // The mitre of a sharp corner is cut.
    const fraction = (0.5 * size(k)) / Math.max(0.6, 1 + n[0] * m[0] + n[1] * m[1]);
    const out: [number, number] = [at[2 * k]! + fraction * (n[0] + m[0]), at[2 * k + 1]! + fraction * (n[1] + m[1])];
    widen(k, Math.hypot(out[0] - at[2 * k]!, out[1] - at[2 * k + 1]!));
    return [Math.min(walls[2]!, Math.max(walls[0]!, out[0])), Math.max(walls[1]!, out[1])];
  };

  const rings = findRings(triangles, solid, isEnd, points.length);
  points.forEach((i, k) => {
    // Cells this far inside have no part outside the body: none of their triangles is at its surface.
    if (rings[k]! >= surfaceRings && radii[i]! > reach[i]!) reach[i] = 1e6;
  });
  for (let e = 0; e < triangles.length; e += 3) {
    const corners = [triangles[e]!, triangles[e + 1]!, triangles[e + 2]!];
    if (!isSolid(e) || !corners.some((k) => rings[k]! <= surfaceRings)) continue;
    for (const k of corners) cover.push(at[2 * k]!, at[2 * k + 1]!);
  }

  const outlines: [number, number][][] = [];
  const seen = new Uint8Array(triangles.length);
  for (let start = 0; start < triangles.length; ++start) {
    if (seen[start] || !isEnd(start)) continue;
    const edges: number[] = [];
    for (let e = start; !seen[e]; e = follow(e)) {
      seen[e] = 1;
      edges.push(e);
    }
    const line = edges.map((e, i) => moveOut(edges.at(i - 1)!, e));
    edges.forEach((e, i) => {
      const [a, b] = [triangles[e]!, triangles[next(e)]!];
      const [p, q] = [line[i]!, line[(i + 1) % line.length]!];
      const [ax, ay, bx, by] = [at[2 * a]!, at[2 * a + 1]!, at[2 * b]!, at[2 * b + 1]!];
      cover.push(ax, ay, bx, by, ...p, bx, by, ...q, ...p);
      const farthest = Math.hypot(Math.hypot(bx - ax, by - ay) / 2, 0.5 * Math.max(size(a), size(b)));
      widen(a, farthest);
      widen(b, farthest);
    });
    const typical = edges.reduce((sum, e) => sum + size(triangles[e]!), 0) / edges.length;
    if (Math.abs(measureArea(line)) > smallestLoop * typical ** 2) outlines.push(line);
  }
  return { radii, reach, cover: Float64Array.from(cover), outlines };
}

/** [point] 0 on the surface, 1 beside such points, and so on up to one more than the rings that are needed. */
function findRings(triangles: Uint32Array, solid: Uint8Array, isEnd: (e: number) => boolean, count: number) {
  const rings = new Uint8Array(count).fill(surfaceRings + 1);
  for (let e = 0; e < triangles.length; ++e) {
    if (!isEnd(e)) continue;
    rings[triangles[e]!] = 0;
    rings[triangles[e % 3 === 2 ? e - 2 : e + 1]!] = 0;
  }
  for (let ring = 0; ring < surfaceRings; ++ring) {
    for (let t = 0; t < solid.length; ++t) {
      if (!solid[t]) continue;
      const [a, b, c] = [triangles[3 * t]!, triangles[3 * t + 1]!, triangles[3 * t + 2]!];
      if (Math.min(rings[a]!, rings[b]!, rings[c]!) !== ring) continue;
      for (const k of [a, b, c]) if (rings[k]! > ring) rings[k] = ring + 1;
    }
  }
  return rings;
}

export function measureCircumradius(at: Float64Array, a: number, b: number, c: number): number {
  const dx = at[2 * b]! - at[2 * a]!;
  const dy = at[2 * b + 1]! - at[2 * a + 1]!;
  const ex = at[2 * c]! - at[2 * a]!;
  const ey = at[2 * c + 1]! - at[2 * a + 1]!;
  const d = dx * dx + dy * dy;
  const e = ex * ex + ey * ey;
  const cross = 2 * (dx * ey - dy * ex);
  return Math.sqrt((ey * d - dy * e) ** 2 + (dx * e - ex * d) ** 2) / Math.abs(cross);
}

/** Area within a closed line [m²]; its sign is the sense in which the line runs. */
export function measureArea(line: number[][]): number {
  let twice = 0;
  const [x0, y0] = line[0] ?? [0, 0];
  line.forEach(([x, y], i) => {
    const [nextX, nextY] = line[(i + 1) % line.length]!;
    twice += (x! - x0!) * (nextY! - y0!) - (nextX! - x0!) * (y! - y0!);
  });
  return twice / 2;
}
