/** What the parts of the page share: the frame that is shown, the field, the point that was picked. */
import { computed, signal } from "@preact/signals";

import type { Report, Sequence } from "./contract";
import { readValues } from "./data";

/** The report, set once before anything is drawn. */
export const report = signal<Report>(null as unknown as Report);

/** Index in report.sequences. */
export const sequenceIndex = signal(0);
/** Index of the frame in the sequence. */
export const frameIndex = signal(0);
/** Name of the field that colours the points. */
export const fieldName = signal("deviatoric_strain");
/** Index of the picked point in the arrays of the sequence (not its id), or null. */
export const pickedPoint = signal<number | null>(null);

export const sequence = computed<Sequence | null>(() => report.value.sequences[sequenceIndex.value] ?? null);

const cache = new Map<string, Promise<Float32Array>>();

/** The values of a packed array, decoded once. */
export function load(array: import("./contract").PackedArray): Promise<Float32Array> {
  let values = cache.get(array.id);
  if (!values) cache.set(array.id, (values = readValues(array)));
  return values;
}
