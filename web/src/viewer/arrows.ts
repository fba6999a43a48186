// SPDX-License-Identifier: MIT
/** Arrows of displacement or velocity: the points that have one, its length, and the scale. */
import { effect, signal } from "@preact/signals";

import type { SequenceField } from "../contract";
import { load, report } from "../state";
import type { Camera } from "./camera";
import { arrowQuantity, type ArrowQuantity, arrowTitles, limitMode } from "./settings";
import { fail, frame, shown, takeFrame, takePositions, type Shown } from "./shown";
import { radii } from "./sizes";

interface Loaded {
  sequence: string;
  quantity: ArrowQuantity;
  /** Components along x, y (z), [frame][point] each [SI]. */
  components: Float32Array[];
  fields: SequenceField[];
}

/** Components of the chosen quantity, or null while there are none. */
export const arrowArrays = signal<Loaded | null>(null);

/** The stored components of a quantity; empty where one is missing. */
export function findComponents(fields: SequenceField[], quantity: string, dimension: number): SequenceField[] {
  const found = ["x", "y", "z"].slice(0, dimension).map((axis) => fields.find((f) => f.name === `${quantity}_${axis}`));
  return found.every((f) => f) ? (found as SequenceField[]) : [];
}

async function loadArrows(now: Shown, quantity: ArrowQuantity): Promise<void> {
  const fields = findComponents(now.sequence.fields, quantity, report.value.model.dimension);
  const components = await Promise.all(fields.map((f) => load(f.values)));
  if (arrowQuantity.peek() !== quantity || shown.peek()?.sequence !== now.sequence) return;
  arrowArrays.value = components.length ? { sequence: now.sequence.id, quantity, components, fields } : null;
}

export function startArrows(): () => void {
  return effect(() => {
    const [now, quantity] = [shown.value, arrowQuantity.value];
    if (!now || quantity === "none") arrowArrays.value = null;
    else loadArrows(now, quantity).catch(fail);
  });
}

/** Pixels between arrows, and of the longest one. */
const [mesh, longest] = [28, 44];

export interface Arrow {
  from: [number, number];
  to: [number, number];
}
export interface ArrowField {
  arrows: Arrow[];
  /** Length [px] of the arrow for `text`. */
  reference: number;
  text: string;
}

/** Largest of 1, 2, 5 × 10^k that is not above the value. */
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return power * (value >= 5 * power * 0.9999 ? 5 : value >= 2 * power * 0.9999 ? 2 : 1);
}

/** One arrow for each square of the screen: of the point nearest to its middle, in space of the foremost. */
export function chooseArrows(camera: Camera): ArrowField | null {
  const [now, loaded] = [shown.value, arrowArrays.value];
  if (!now || !loaded || loaded.sequence !== now.sequence.id) return null;
  const { dimension } = report.value.model;
  const count = now.sequence.point_count;
  const positions = takePositions(now, frame.value);
  const components = loaded.components.map((c) => takeFrame(c, frame.value, count));
  const project = camera.makeProjection();
  const best = new Map<number, { index: number; score: number; at: [number, number] }>();
  let largest = 0;
  const measure = (i: number) => Math.hypot(...components.map((c) => c[i]!));
  for (let i = 0; i < count; ++i) {
    if (!radii.value[i] || Number.isNaN(components[0]![i]!)) continue;
    largest = Math.max(largest, measure(i));
    const z = dimension === 3 ? positions[3 * i + 2]! : 0;
    const [x, y, depth] = project(positions[dimension * i]!, positions[dimension * i + 1]!, z);
    if (x < 0 || y < 0 || x > camera.width || y > camera.height) continue;
    const [column, row] = [Math.floor(x / mesh), Math.floor(y / mesh)];
    const distance = Math.hypot(x - (column + 0.5) * mesh, y - (row + 0.5) * mesh);
    const score = dimension === 3 ? -depth : distance;
    const key = column * 4096 + row;
    const known = best.get(key);
    if (!known || score < known.score) best.set(key, { index: i, score, at: [x, y] });
  }
  // Over all frames the scale stays the same while playing; the colours of one frame have arrows to go with them.
  const whole = Math.hypot(...loaded.fields.map((f) => Math.max(...f.scale.map(Math.abs))));
  const full = limitMode.value === "frame" ? largest : whole;
  if (!(full > 0)) return null;
  const { right, up } = camera.findAxes();
  const arrows: Arrow[] = [];
  for (const { index, at } of best.values()) {
    const along = (v: number[]) => components.reduce((sum, c, k) => sum + c[index]! * v[k]!, 0) / full;
    const [dx, dy] = [along(right) * longest, -along(up) * longest];
    if (Math.hypot(dx, dy) >= 2) arrows.push({ from: at, to: [at[0] + dx, at[1] + dy] });
  }
  const { unit } = loaded.fields[0]!;
  const value = roundDown(full / unit.si);
  const number = value < 1e-3 ? value.toExponential(0).replace("-", "−") : Number(value.toPrecision(1));
  const name = arrowTitles[loaded.quantity].toLowerCase();
  return { arrows, reference: ((value * unit.si) / full) * longest, text: `${name} ${number} ${unit.name}` };
}
