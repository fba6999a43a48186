// SPDX-License-Identifier: MIT
/** Lines that are found in the shown frame: slip surface, axis of the largest strain, water table. */
import { computed, effect, signal } from "@preact/signals";
import Delaunator from "delaunator";

import { load, report } from "../state";
import { layers } from "./settings";
import { fail, frame, shown, type Shown, takeFrame, takePositions } from "./shown";
import { findMovedLimits, findStrainRidge } from "./slipLines";
import { measureCircumradius } from "./cells";

/** Triangles whose circumcircle is wider than this many point distances lie outside the soil. */
const widestTriangle = 1.5;
/** Lines shorter than this many point distances are noise of points that are nearly without pressure. */
const shortestLine = 6;
/** Pressures of this size everywhere [Pa] are none. */
const noPressure = 1;

type Line = [number, number][];

/** Means over each point and its neighbours in the triangulation. */
function average(values: Float64Array, triangles: Uint32Array, solid: Uint8Array): Float64Array {
  const sums = Float64Array.from(values);
  const counts = new Float64Array(values.length).fill(1);
  for (let e = 0; e < triangles.length; ++e) {
    if (!solid[Math.floor(e / 3)]) continue;
    const [a, b] = [triangles[e]!, triangles[e % 3 === 2 ? e - 2 : e + 1]!];
    // An edge inside is met from both sides, one at the surface once; it counts as much from either end.
    sums[a]! += values[b]! / 2;
    sums[b]! += values[a]! / 2;
    counts[a]! += 0.5;
    counts[b]! += 0.5;
  }
  return sums.map((sum, k) => sum / counts[k]!);
}

/** Joins pieces with a common edge of the triangulation. */
function joinPieces(pieces: [number, number][], place: (edge: number) => [number, number]): Line[] {
  const at = new Map<number, number[]>();
  pieces.forEach((piece, i) => piece.forEach((edge) => at.set(edge, [...(at.get(edge) ?? []), i])));
  const used = new Uint8Array(pieces.length);
  const lines: Line[] = [];
  const walk = (start: number) => {
    const line: Line = [place(start)];
    for (let edge = start; ; ) {
      const next = at.get(edge)!.find((i) => !used[i]);
      if (next === undefined) break;
      used[next] = 1;
      const [a, b] = pieces[next]!;
      edge = a === edge ? b : a;
      line.push(place(edge));
    }
    if (line.length > 1) lines.push(line);
  };
  // Ends first, so that no open line begins in its middle; what is left is closed.
  for (const [edge, touching] of at) if (touching.length === 1) walk(edge);
  for (const edge of at.keys()) walk(edge);
  return lines;
}

/**
 * Extends an open line by one point distance at either end, in its direction: points are half a distance
 * behind the surface, and their means are farther behind it.
 */
function prolong(line: Line, spacing: number): Line {
  const [first, last] = [line[0]!, line.at(-1)!];
  if (Math.hypot(first[0] - last[0], first[1] - last[1]) < 2 * spacing) return line;
  const carryOn = (end: [number, number], along: Line): [number, number] => {
    const from = along.find((p) => Math.hypot(p[0] - end[0], p[1] - end[1]) > 3 * spacing) ?? along.at(-1)!;
    const length = Math.hypot(end[0] - from[0], end[1] - from[1]);
    return [0, 1].map((d) => end[d]! + (spacing * (end[d]! - from[d]!)) / length) as [number, number];
  };
  return [carryOn(first, line), ...line, carryOn(last, [...line].reverse())];
}

/** Each inner corner moves to the mean of its neighbours and itself; the ends stay. */
function smoothLine(line: Line): Line {
  let now = line;
  for (let round = 0; round < 3; ++round)
    now = now.map((p, i) => {
      const [a, b] = [now[i - 1], now[i + 1]];
      return a && b ? [(a[0] + 2 * p[0] + b[0]) / 4, (a[1] + 2 * p[1] + b[1]) / 4] : p;
    });
  return now;
}

/**
 * Lines of zero pore pressure. `positions` [point][2] [m], NaN for a point that is not there; `pressure` [point] [Pa];
 * `isWet` [point]; `spacing`: mean distance of the points [m]. Points of a full element have one pressure, so that
 * pressures are averaged over neighbours first.
 */
export function findWaterTable(
  positions: ArrayLike<number>,
  pressure: Float32Array,
  isWet: (point: number) => boolean,
  spacing: number,
): Line[] {
  const points: number[] = [];
  let largest = 0;
  for (let i = 0; i < pressure.length; ++i) {
    if (!isWet(i) || Number.isNaN(pressure[i]!) || Number.isNaN(positions[2 * i]!)) continue;
    largest = Math.max(largest, Math.abs(pressure[i]!));
    points.push(i);
  }
  if (points.length < 3 || largest < noPressure) return [];
  const at = new Float64Array(2 * points.length);
  points.forEach((i, k) => ((at[2 * k] = positions[2 * i]!), (at[2 * k + 1] = positions[2 * i + 1]!)));
  const { triangles, halfedges } = new Delaunator(at);

  const solid = new Uint8Array(triangles.length / 3);
  for (let t = 0; t < solid.length; ++t) {
    const [a, b, c] = triangles.subarray(3 * t, 3 * t + 3);
    if (measureCircumradius(at, a!, b!, c!) < widestTriangle * spacing) solid[t] = 1;
  }
  // The mean of the pressures belongs to the mean of the places: so a plane of pressure stays what it is.
  const smooth = (some: Float64Array) => average(average(some, triangles, solid), triangles, solid);
  const x = smooth(Float64Array.from(points, (i) => positions[2 * i]!));
  const y = smooth(Float64Array.from(points, (i) => positions[2 * i + 1]!));
  const values = smooth(Float64Array.from(points, (i) => pressure[i]!));

  const pieces: [number, number][] = [];
  for (let t = 0; t < solid.length; ++t) {
    if (!solid[t]) continue;
    const crossed: number[] = [];
    for (let e = 3 * t; e < 3 * t + 3; ++e) {
      const [a, b] = [triangles[e]!, triangles[e % 3 === 2 ? e - 2 : e + 1]!];
      // An edge has the smaller of its two numbers, from whichever triangle it is seen.
      if (values[a]! > 0 !== values[b]! > 0) crossed.push(halfedges[e]! < 0 ? e : Math.min(e, halfedges[e]!));
    }
    if (crossed.length === 2) pieces.push([crossed[0]!, crossed[1]!]);
  }
  const place = (e: number): [number, number] => {
    const [a, b] = [triangles[e]!, triangles[e % 3 === 2 ? e - 2 : e + 1]!];
    const fraction = values[a]! / (values[a]! - values[b]!);
    return [x[a]! + fraction * (x[b]! - x[a]!), y[a]! + fraction * (y[b]! - y[a]!)];
  };
  const measure = (line: Line) =>
    line.reduce((sum, p, i) => (i ? sum + Math.hypot(p[0] - line[i - 1]![0], p[1] - line[i - 1]![1]) : 0), 0);
  return joinPieces(pieces, place)
    .filter((line) => measure(line) > shortestLine * spacing)
    .map((line) => prolong(smoothLine(line), spacing));
}

/** Corners of the slip surfaces in the shown frame [m]: one, or one of each side where the soil moves to both. */
export const slipSurfaces = signal<Line[]>([]);
/** Corners of the ridge of the deviatoric strain in the shown frame [m]; empty where there is none. */
export const strainRidge = signal<Line>([]);

/** Lines of zero pore pressure in the shown frame; null where the frame has no pressures. */
export const waterTables = signal<Line[] | null>(null);

/** Displacement above which soil counts as moved [m]: a hundredth of the slope's height, as for the moved volume. */
export const movedThreshold = computed(() => 0.01 * report.value.model.slope_height);

/** The values of stored fields in a frame, null for one that is not stored; undefined when another frame is shown by then. */
async function takeFields(now: Shown, index: number, names: string[]): Promise<(Float32Array | null)[] | undefined> {
  const stored = names.map((name) => now.sequence.fields.find((f) => f.name === name));
  const values = await Promise.all(stored.map(async (f) => (f ? load(f.values) : null)));
  if (shown.peek()?.sequence !== now.sequence || frame.peek() !== index) return undefined;
  return values.map((v) => (v ? takeFrame(v, index, now.sequence.point_count) : null));
}

const isSection = () => report.value.model.dimension === 2;

async function traceSlip(now: Shown, index: number): Promise<void> {
  const fields = isSection() ? await takeFields(now, index, ["displacement", "displacement_x"]) : [null];
  if (!fields) return;
  const [displacement, across] = fields;
  slipSurfaces.value = displacement
    ? findMovedLimits(takePositions(now, index), displacement, across ?? null, now.spacing, movedThreshold.value)
    : [];
}

async function traceRidge(now: Shown, index: number): Promise<void> {
  const fields = isSection() ? await takeFields(now, index, ["deviatoric_strain"]) : [null];
  if (!fields) return;
  const [strain] = fields;
  strainRidge.value = strain ? findStrainRidge(takePositions(now, index), strain, now.spacing) : [];
}

async function traceWater(now: Shown, index: number): Promise<void> {
  const { model } = report.value;
  const found = now.sequence.fields.find((f) => f.name === "pore_pressure");
  if (!found || model.dimension === 3) return void (waterTables.value = null);
  const [values, materials] = await Promise.all([load(found.values), load(now.sequence.materials)]);
  if (shown.peek()?.sequence !== now.sequence || frame.peek() !== index) return;
  const wet = new Set(model.materials.filter((m) => m.water).map((m) => m.index));
  const pressure = takeFrame(values, index, now.sequence.point_count);
  waterTables.value = findWaterTable(takePositions(now, index), pressure, (i) => wet.has(materials[i]!), now.spacing);
}

/** Finds the lines of the layers that are on; returns what ends that. */
export function startTracing(): () => void {
  const ends = [
    effect(() => {
      const now = shown.value;
      if (layers.value.slip && now) traceSlip(now, frame.value).catch(fail);
    }),
    effect(() => {
      const now = shown.value;
      if (layers.value.ridge && now) traceRidge(now, frame.value).catch(fail);
    }),
    effect(() => {
      const now = shown.value;
      if (layers.value.water && now) traceWater(now, frame.value).catch(fail);
    }),
  ];
  return () => ends.forEach((end) => end());
}
