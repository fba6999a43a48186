// SPDX-License-Identifier: MIT
/** The fields of both bounds, decoded, and their marks: crosses of principal stresses, arrows of velocities. */
import type { BoundsDrawn } from "../contract";
import type { Pen, Triangles } from "../drawing/pen";
import { load, loadIntegers, loadPlaces, useLoaded } from "../state";

interface BoundsFields {
  holds: { mesh: Triangles; middles: number[][]; stress: Float32Array; utilisation: Float32Array } | null;
  moves: { mesh: Triangles; nodes: Float64Array; velocity: Float32Array; shear_rate: Float32Array } | null;
}

/** Every triangle on nodes of its own, so that it has one colour; `stride`: nodes of a triangle, corners first. */
export function separate(nodes: ArrayLike<number>, triangles: ArrayLike<number>, stride: number): Triangles {
  const count = triangles.length / stride;
  const own = new Float64Array(6 * count);
  for (let t = 0; t < count; ++t)
    for (const corner of [0, 1, 2])
      for (const d of [0, 1]) own[6 * t + 2 * corner + d] = nodes[2 * triangles[stride * t + corner]! + d]!;
  return { nodes: own, triangles: Uint32Array.from({ length: 3 * count }, (_, i) => i) };
}

/** The value of each triangle at its three nodes. */
export function repeat(values: Float32Array): Float32Array {
  return Float32Array.from({ length: 3 * values.length }, (_, i) => values[Math.floor(i / 3)]!);
}

function findMiddles({ nodes }: Triangles): number[][] {
  return Array.from({ length: nodes.length / 6 }, (_, t) =>
    [0, 1].map((d) => (nodes[6 * t + d]! + nodes[6 * t + 2 + d]! + nodes[6 * t + 4 + d]!) / 3),
  );
}

async function loadHolds(field: BoundsDrawn["holds"]): Promise<BoundsFields["holds"]> {
  if (!field) return null;
  const [nodes, triangles, stress, utilisation] = await Promise.all([
    loadPlaces(field.nodes),
    loadIntegers(field.triangles),
    load(field.stress),
    load(field.utilisation),
  ]);
  const mesh = separate(nodes, triangles, 3);
  return { mesh, middles: findMiddles(mesh), stress, utilisation: repeat(utilisation) };
}

async function loadMoves(field: BoundsDrawn["moves"]): Promise<BoundsFields["moves"]> {
  if (!field) return null;
  const [nodes, triangles, velocity, shear_rate] = await Promise.all([
    loadPlaces(field.nodes),
    loadIntegers(field.triangles),
    load(field.velocity),
    load(field.shear_rate),
  ]);
  return { mesh: separate(nodes, triangles, 6), nodes, velocity, shear_rate: repeat(shear_rate) };
}

export const useBounds = (bounds: BoundsDrawn): BoundsFields | null =>
  useLoaded(async () => {
    const [holds, moves] = await Promise.all([loadHolds(bounds.holds), loadMoves(bounds.moves)]);
    return { holds, moves };
  }, bounds);

/** Sides of the squares that have one mark each [px]. */
const spacing = 26;

interface Principal {
  /** More compression, less compression [Pa], positive in tension. */
  most: number;
  least: number;
  /** Direction of the larger compression, from the x axis [rad]. */
  angle: number;
}

export function findPrincipal(xx: number, yy: number, xy: number): Principal {
  const mean = (xx + yy) / 2;
  const radius = Math.hypot((xx - yy) / 2, xy);
  return { most: mean - radius, least: mean + radius, angle: 0.5 * Math.atan2(2 * xy, xx - yy) + Math.PI / 2 };
}

/** Numbers of places of which no two lie in one square of the picture. */
export function thinOut(places: readonly (readonly number[])[], side = spacing): number[] {
  const taken = new Set<string>();
  return places.flatMap(([x, y], i) => {
    const key = `${Math.floor(x! / side)} ${Math.floor(y! / side)}`;
    if (taken.has(key)) return [];
    taken.add(key);
    return [i];
  });
}

/** Crosses as long as the stresses, compression dark and tension red. */
export function drawCrosses(pen: Pen, middles: number[][], stress: Float32Array): void {
  const { context, place } = pen;
  const places = middles.map(place);
  const shown = thinOut(places);
  const principal = shown.map((i) => findPrincipal(stress[3 * i]!, stress[3 * i + 1]!, stress[3 * i + 2]!));
  const sizes = principal.map((p) => Math.max(Math.abs(p.most), Math.abs(p.least))).sort((a, b) => a - b);
  const largest = sizes[Math.floor(0.95 * (sizes.length - 1))] || 1;
  const bar = ([x, y]: readonly number[], size: number, angle: number) => {
    const half = Math.min(0.5 * spacing, (0.5 * spacing * Math.abs(size)) / largest);
    context.beginPath();
    context.moveTo(x! - half * Math.cos(angle), y! + half * Math.sin(angle));
    context.lineTo(x! + half * Math.cos(angle), y! - half * Math.sin(angle));
    context.strokeStyle = size > 0 ? "#d81b60" : "#111111";
    context.stroke();
  };
  context.lineWidth = 1;
  shown.forEach((i, k) => {
    bar(places[i]!, principal[k]!.most, principal[k]!.angle);
    bar(places[i]!, principal[k]!.least, principal[k]!.angle + Math.PI / 2);
  });
}

/** Arrows as long as the velocities. */
export function drawArrows(pen: Pen, nodes: Float64Array, velocity: Float32Array): void {
  const { context, place } = pen;
  const places = Array.from({ length: nodes.length / 2 }, (_, n) => place([nodes[2 * n]!, nodes[2 * n + 1]!]));
  context.strokeStyle = "#111111";
  context.lineWidth = 1;
  context.beginPath();
  for (const n of thinOut(places)) {
    const [vx, vy] = [velocity[2 * n]!, velocity[2 * n + 1]!];
    const length = 0.9 * spacing * Math.hypot(vx, vy);
    if (length < 1.5) continue;
    const [x, y] = places[n]!;
    const angle = Math.atan2(-vy, vx);
    const [tipX, tipY] = [x + length * Math.cos(angle), y + length * Math.sin(angle)];
    context.moveTo(x, y);
    context.lineTo(tipX, tipY);
    for (const turn of [2.6, -2.6]) {
      context.moveTo(tipX, tipY);
      context.lineTo(tipX + 4 * Math.cos(angle + turn), tipY + 4 * Math.sin(angle + turn));
    }
  }
  context.stroke();
}
