// SPDX-License-Identifier: MIT
/** Present data: the decoded arrays of the sequence and field. */
import { computed, effect, signal } from "@preact/signals";

import type { Sequence, SequenceField } from "../contract";
import { fieldName, frameIndex, load, loadIntegers, loadPlaces, report, sequence } from "../state";
import { measureExtent, type Extent } from "./extent";
import { makeScale, type Scale } from "./scale";
import { handLimits, inSpace, limitMode, logarithmic } from "./settings";

export interface Shown extends Extent {
  sequence: Sequence;
  field: SequenceField;
  /** [frame][point][dimension] [m]; NaN for a point that is not there. */
  positions: Float64Array;
  /** [frame][point], or [point] of what does not change. */
  values: Float32Array;
  /** [frame][point] volumes of the points [m³, m³/m], or null where none are stored. */
  volumes: Float32Array | null;
  /** Number of each point, as in the results. */
  ids: ArrayLike<number>;
}

/** Stays on the last arrays while the next ones are decoded. */
export const shown = signal<Shown | null>(null);
export const failure = signal("");

export const materialField = "material";

/** The points' materials as if they were a field: their numbers are places in a table of colours. */
function makeMaterialField(current: Sequence): SequenceField {
  const unit = { name: "-", si: 1 };
  const scale: [number, number] = [0, 255];
  return { name: materialField, title: "material", unit, values: current.materials, scale, diverging: false };
}

/** Fields that colours can show in the sequence. */
export const fields = computed<SequenceField[]>(() => {
  const now = sequence.value;
  return now ? [...now.fields, makeMaterialField(now)] : [];
});

export const field = computed<SequenceField | null>(
  () => fields.value.find((f) => f.name === fieldName.value) ?? fields.value[0] ?? null,
);

/** Index of the frame, kept within the shown sequence while another one is decoded. */
export const frame = computed(() => Math.min(frameIndex.value, (shown.value?.sequence.frames.length ?? 1) - 1));

/** One frame of an array with `size` numbers per point; a view, not a copy. */
export function takeFrame<A extends Float32Array | Float64Array>(array: A, index: number, count: number, size = 1): A {
  if (array.length === count * size) return array;
  return array.subarray(index * count * size, (index + 1) * count * size) as A;
}

/** Positions [point][dimension] of a frame. */
export function takePositions(now: Shown, index: number): Float64Array {
  return takeFrame(now.positions, index, now.sequence.point_count, report.value.model.dimension);
}

let extentOf: (Extent & { id: string }) | null = null;

async function loadShown(current: Sequence, wanted: SequenceField): Promise<void> {
  const stored = current.fields.find((f) => f.name === "volume");
  const [positions, values, ids, volumes] = await Promise.all([
    loadPlaces(current.positions),
    load(wanted.values),
    loadIntegers(current.ids),
    stored ? load(stored.values) : null,
  ]);
  if (sequence.peek() !== current || field.peek()?.values.id !== wanted.values.id) return;
  if (extentOf?.id !== current.id) extentOf = { id: current.id, ...measureExtent(positions, current) };
  const { box, spacing } = extentOf;
  shown.value = { sequence: current, field: wanted, positions, values, ids, volumes, spacing, box };
}

export const fail = (error: unknown) => void (failure.value = error instanceof Error ? error.message : String(error));

/** Decodes the selected field; returns the function that ends this. */
export function startLoading(): () => void {
  const ends = [
    effect(() => {
      if (sequence.value && field.value) loadShown(sequence.value, field.value).catch(fail);
    }),
    effect(() => {
      if (report.value.model.dimension === 3) inSpace.value = true;
    }),
  ];
  return () => ends.forEach((end) => end());
}

/** True for fields with a logarithmic scale: quantities that are never negative and not categories. */
export const canBeLogarithmic = computed(() => {
  const now = field.value;
  return !!now && now.name !== materialField && !now.diverging && (now.values.range?.[0] ?? -1) >= 0;
});

/** The scale of the colours, in SI. */
export const scale = computed<Scale>(() => {
  const now = shown.value;
  if (!now) return makeScale(0, 1);
  let [low, high] = now.field.scale;
  if (now.field.name === materialField) return makeScale(low, high);
  if (limitMode.value === "hand") {
    [low, high] = handLimits.value;
  } else if (limitMode.value === "frame") {
    [low, high] = [Infinity, -Infinity];
    for (const value of takeFrame(now.values, frame.value, now.sequence.point_count)) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
    if (!(low <= high)) return makeScale(0, 1);
    if (now.field.diverging) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
  }
  return makeScale(low, high, logarithmic.value && canBeLogarithmic.value);
});
