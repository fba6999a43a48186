// SPDX-License-Identifier: MIT
/** Lines that are found in the shown frame: slip surface, axis of the largest strain. */
import { computed, effect, signal } from "@preact/signals";

import { load, report } from "../state";
import { findMovedLimit } from "./moved";
import { findStrainRidge } from "./ridge";
import { layers } from "./settings";
import { fail, frame, shown, takeFrame, takePositions, type Shown } from "./shown";
import { findWaterTable } from "./waterTable";

export type Line = [number, number][];

/** Corners of the slip surface in the shown frame [m]; empty where there is none. */
export const slipSurface = signal<Line>([]);
/** Likewise the ridge of the deviatoric strain. */
export const strainRidge = signal<Line>([]);

/** Lines of zero pore pressure in the shown frame; null where the frame tells no pressures. */
export const waterTables = signal<Line[] | null>(null);

/** Displacement above which soil counts as moved [m]: a hundredth of the slope's height, as for the moved volume. */
export const movedThreshold = computed(() => 0.01 * report.value.model.slope_height);

type Tracer = (positions: Float32Array, values: Float32Array, spacing: number) => Line;

/** Draws `line` from the field called `name`; only in a section. */
async function trace(now: Shown, index: number, line: { value: Line }, name: string, find: Tracer): Promise<void> {
  const found = now.sequence.fields.find((f) => f.name === name);
  if (!found || report.value.model.dimension === 3) return void (line.value = []);
  const values = await load(found.values);
  if (shown.peek()?.sequence !== now.sequence || frame.peek() !== index) return;
  line.value = find(takePositions(now, index), takeFrame(values, index, now.sequence.point_count), now.spacing);
}

const findLimit: Tracer = (x, u, spacing) => findMovedLimit(x, u, spacing, movedThreshold.value);

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
      if (layers.value.slip && now) trace(now, frame.value, slipSurface, "displacement", findLimit).catch(fail);
    }),
    effect(() => {
      const now = shown.value;
      if (layers.value.ridge && now)
        trace(now, frame.value, strainRidge, "deviatoric_strain", findStrainRidge).catch(fail);
    }),
    effect(() => {
      const now = shown.value;
      if (layers.value.water && now) traceWater(now, frame.value).catch(fail);
    }),
  ];
  return () => ends.forEach((end) => end());
}
