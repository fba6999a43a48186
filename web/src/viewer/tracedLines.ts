// SPDX-License-Identifier: MIT
/** Lines that are found in the shown frame: slip surface, axis of the largest strain. */
import { computed, effect, signal } from "@preact/signals";

import { load, report } from "../state";
import { findMovedLimits } from "./moved";
import { findStrainRidge } from "./ridge";
import { layers } from "./settings";
import { fail, frame, shown, takeFrame, takePositions, type Shown } from "./shown";
import { findWaterTable } from "./waterTable";

export type Line = [number, number][];

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
