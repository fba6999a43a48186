// SPDX-License-Identifier: MIT
/** Marks of the fields, no closer than can be seen: crosses of principal stresses, arrows of velocities. */
import type { Pen } from "../drawing/pen";

/** Sides of the squares that have one mark each [px]. */
const spacing = 26;

export interface Principal {
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
