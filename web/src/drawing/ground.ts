// SPDX-License-Identifier: MIT
/** The ground of a section: soils in their colours with their names where there is room, water tables, surcharges. */
import { formatValue } from "../page/format";
import { report } from "../state";
import { tabulateCategories, writeColour } from "../viewer/colours";
import { type Pixel, strokeLine } from "../viewer/lines";
import type { Pen } from "./pen";
import { drawWaterState, findUsedWater, writeLabel } from "./standingWater";
import type { LabelBox } from "./surfaceLines";

type Point = readonly number[];
interface Room {
  at: [number, number];
  /** To the nearest edge [m]. */
  radius: number;
}

export function isInside([x, y]: Point, points: readonly Point[]): boolean {
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

/** Colour of a soil as CSS; the viewer gives materials the same. */
export function findSoilColour(material: string): string {
  const found = report.value.model.materials.find((m) => m.name === material);
  return writeColour(tabulateCategories(), found ? found.index & 255 : -1);
}

function tracePolygons({ context, place }: Pen): void {
  for (const polygon of report.value.model.polygons) {
    polygon.points.forEach((p, i) => (i ? context.lineTo(...place(p)) : context.moveTo(...place(p))));
    context.closePath();
  }
}

/** Strength parameters of a soil: "c = 5 kPa, φ = 32°"; empty for a law without them. */
export function describeStrength(material: string): string {
  const properties = report.value.model.materials.find((m) => m.name === material)?.properties ?? [];
  const write = (key: string) => {
    const found = properties.find((p) => p.key === key);
    return !found || found.characteristic === null ? "" : formatValue(found.characteristic, found.unit);
  };
  const growing = (key: string, gradient: string) => {
    const value = write(key);
    const growth = properties.find((p) => p.key === gradient)?.characteristic ? write(gradient) : "";
    return value && growth ? `${value} + ${growth}` : value;
  };
  const softening = (value: string, residual: string) => [value, write(residual)].filter(Boolean).join(" to ");
  const parts: [string, string][] = [
    ["c", softening(growing("cohesion", "cohesion_gradient"), "residual_cohesion")],
    ["φ", softening(write("friction_angle"), "residual_friction_angle")],
    ["s_u", growing("undrained_strength", "undrained_gradient")],
  ];
  return parts.filter(([, value]) => value).map(([symbol, value]) => `${symbol} = ${value}`).join(", ");
}

/**
 * The name of each soil where its polygon is widest, over its strength where both fit; none where it would
 * not fit. `follow`: present position of the soil that lay at a place [m]; null where there is none. Returns the places
 * of the texts.
 */
export function drawSoilNames(
  { context, camera, place, theme }: Pick<Pen, "context" | "camera" | "place" | "theme">,
  follow: (at: [number, number]) => readonly number[] | null = (at) => at,
): LabelBox[] {
  const { polygons } = report.value.model;
  const boxes: LabelBox[] = [];
  polygons.forEach(({ material, points }, i) => {
    if (!material) return;
    const room = findRoom(points, polygons.slice(i + 1).map((p) => p.points));
    if (!room) return;
    const fits = (text: string) => 6.5 * text.length <= 2.4 * room.radius * camera.scale;
    const space = room.radius * camera.scale;
    if (!fits(material) || space < 8) return;
    context.textAlign = "center";
    const now = follow(room.at);
    if (!now) return;
    const [x, y] = place(now);
    const strength = describeStrength(material);
    const lines = strength && space >= 18 && fits(strength) ? [material, strength] : [material];
    lines.forEach((text, k) => writeLabel(context, text, [x, y + 14 * k], theme, theme.ink));
    boxes.push({ x, y: y + 7 * (lines.length - 1), half: 3.5 * Math.max(...lines.map((t) => t.length)), high: 8 * lines.length });
  });
  return boxes;
}

/** Later polygons replace earlier ones, as in the case. */
export function drawSoils(pen: Pen, strength = 0.3): void {
  const { context, place, theme } = pen;
  for (const polygon of report.value.model.polygons) {
    context.beginPath();
    polygon.points.forEach((p) => context.lineTo(...place(p)));
    context.closePath();
    context.fillStyle = theme.ground;
    context.fill();
    context.globalAlpha = strength;
    context.fillStyle = findSoilColour(polygon.material);
    context.fill();
    context.globalAlpha = 1;
  }
}

export function drawOutlines({ context, place, theme }: Pen): void {
  context.lineJoin = "round";
  for (const polygon of report.value.model.polygons)
    strokeLine(context, polygon.points.map(place), { colour: theme.ink, width: 1.2, closed: true });
}

/** Draws inside the soil only. */
export function clipToSoil(pen: Pen, draw: () => void): void {
  const { context } = pen;
  context.save();
  if (report.value.model.polygons.length) {
    context.beginPath();
    tracePolygons(pen);
    context.clip("nonzero");
  }
  draw();
  context.restore();
}

/** The water that the methods began with. */
export const drawWater = (pen: Pen): void => drawWaterState(pen, findUsedWater());

/** Height of the ground over x: the highest line of the polygons there [m]. */
function findGround(x: number): number | null {
  let highest: number | null = null;
  for (const { points } of report.value.model.polygons)
    points.forEach((a, i) => {
      const b = points[(i + 1) % points.length]!;
      if (a[0] === b[0] || x < Math.min(a[0]!, b[0]!) || x > Math.max(a[0]!, b[0]!)) return;
      const y = a[1]! + ((b[1]! - a[1]!) * (x - a[0]!)) / (b[0]! - a[0]!);
      highest = highest === null ? y : Math.max(highest, y);
    });
  return highest;
}

/** The vertical crack between an end of a slip surface and the ground above it, blue up to the level of the water in it. */
export function drawCrack({ context, place, theme }: Pick<Pen, "context" | "place" | "theme">, points: number[][]): void {
  const { crack } = report.value.model;
  if (!crack || points.length < 2) return;
  for (const end of [points[0]!, points.at(-1)!]) {
    const ground = findGround(end[0]!);
    const deep = ground === null ? 0 : ground - end[1]!;
    // Deeper than the crack is a vertical face of the ground.
    if (ground === null || deep < 0.02 * crack.depth || deep > 1.05 * crack.depth) continue;
    const upTo = (y: number): Pixel[] => [place(end), place([end[0]!, Math.min(ground, y)])];
    strokeLine(context, upTo(ground), { colour: theme.ground, width: 5 });
    strokeLine(context, upTo(ground), { colour: theme.ink, width: 2.2, dash: [3, 2] });
    if (crack.water > 0) strokeLine(context, upTo(end[1]! + crack.water), { colour: theme.water, width: 3.2 });
  }
}

/** Supports that `isShown`: a bar with its bonded part and a plate at its head. */
export function drawBars({ context, place, theme }: Pen, isShown = (_bar: { support: string; row: number }) => true): void {
  for (const { head, end, bonded } of report.value.model.bars.filter(isShown)) {
    const [a, b] = [place(head), place(end)];
    const length = Math.hypot(end[0]! - head[0]!, end[1]! - head[1]!);
    const pixels = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (!(length > 0 && pixels > 0)) continue;
    const from: Pixel = [a[0] + (bonded / length) * (b[0] - a[0]), a[1] + (bonded / length) * (b[1] - a[1])];
    const across: Pixel = [(-4 * (b[1] - a[1])) / pixels, (4 * (b[0] - a[0])) / pixels];
    strokeLine(context, [a, b], { colour: theme.ink, width: 1.1 });
    strokeLine(context, [from, b], { colour: theme.ink, width: 2.2 });
    strokeLine(context, [[a[0] + across[0], a[1] + across[1]], [a[0] - across[0], a[1] - across[1]]], { colour: theme.ink, width: 1.8 });
  }
}

/** Pieces in which a bar bends with the soil. */
const carriedPieces = 24;

/** The bars of the supports, as the soil carries them: `carry` moves a place of the first frame [m]. */
export function carryBars(carry: (at: readonly number[]) => [number, number]): number[][][] {
  return report.value.model.bars.map(({ head, end }) =>
    Array.from({ length: carriedPieces + 1 }, (_, i) => {
      const t = i / carriedPieces;
      return carry([head[0]! + t * (end[0]! - head[0]!), head[1]! + t * (end[1]! - head[1]!)]);
    }),
  );
}

/** Supports in soil that has moved, each a line from its head with a plate there. */
export function drawBentBars({ context, place, theme }: Pick<Pen, "context" | "place" | "theme">, bars: number[][][]): void {
  for (const bar of bars) {
    const line = bar.map((at) => place(at)).filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
    if (line.length < 2) continue;
    strokeLine(context, line, { colour: "#ffffff", width: 4 });
    strokeLine(context, line, { colour: theme.ink, width: 2.2 });
    const [a, b] = [line[0]!, line[1]!];
    const pixels = Math.max(1e-9, Math.hypot(b[0] - a[0], b[1] - a[1]));
    const across: Pixel = [(-5 * (b[1] - a[1])) / pixels, (5 * (b[0] - a[0])) / pixels];
    strokeLine(context, [[a[0] + across[0], a[1] + across[1]], [a[0] - across[0], a[1] - across[1]]], { colour: theme.ink, width: 2.2 });
  }
}

/** Arrows as long as the load is large. */
export function drawSurcharges({ context, place, theme }: Pen): void {
  const { surcharges } = report.value.model;
  const largest = Math.max(0, ...surcharges.flatMap((s) => s.load.map(Math.abs)));
  if (!largest) return;
  context.strokeStyle = theme.ink;
  context.lineWidth = 1;
  for (const { x, load } of surcharges)
    for (let i = 0; i + 1 < x.length; ++i) {
      const steps = Math.max(1, Math.round(Math.abs(place([x[i + 1]!, 0])[0] - place([x[i]!, 0])[0]) / 16));
      context.beginPath();
      for (let k = 0; k <= steps; ++k) {
        const fraction = k / steps;
        const at = x[i]! + fraction * (x[i + 1]! - x[i]!);
        const size = (26 * (load[i]! + fraction * (load[i + 1]! - load[i]!))) / largest;
        const ground = findGround(at);
        if (ground === null || Math.abs(size) < 2) continue;
        const [px, py] = place([at, ground]);
        context.moveTo(px, py - size);
        context.lineTo(px, py - 1);
        context.moveTo(px - 3, py - 6);
        context.lineTo(px, py - 1);
        context.lineTo(px + 3, py - 6);
      }
      context.stroke();
    }
}
