// SPDX-License-Identifier: MIT
/** Common state of the parts of the page: the shown frame, the field, the picked point, whether it is printed. */
import { batch, computed, signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";

import type { PackedArray, PackedPlaces, Report, Sequence } from "./contract";
import { type ReportData, readIntegers, readPlaces, readValues, takeArrays } from "./data";

/** The report, set before anything is drawn, and again where the page follows a run in progress. */
export const report = signal<Report>(null as unknown as Report);
/** True where the page follows a run in progress. */
export const follows = signal(false);

/** Index in report.sequences. */
export const sequenceIndex = signal(0);
/** Index of the frame in the sequence. */
export const frameIndex = signal(0);
/** Name of the field that colours the points; "material" is none of the stored ones. */
export const fieldName = signal("deviatoric_strain");
/** Index of the picked point in the arrays of the sequence (not its id), or null. */
export const pickedPoint = signal<number | null>(null);

export const sequence = computed<Sequence | null>(() => report.value.sequences[sequenceIndex.value] ?? null);

const caches: Map<string, unknown>[] = [];

function makeCache<A extends PackedArray, T>(read: (array: A) => Promise<T>): (array: A) => Promise<T> {
  const cache = new Map<string, Promise<T>>();
  caches.push(cache);
  return (array) => {
    let numbers = cache.get(array.id);
    if (!numbers) cache.set(array.id, (numbers = read(array)));
    return numbers;
  };
}

/** The values of a packed array, decoded once. */
export const load = makeCache((array: PackedArray) => readValues(array));

/** Likewise coordinates [m]. */
export const loadPlaces = makeCache((array: PackedPlaces) => readPlaces(array));

/** Likewise its numbers as they are stored: those of points exceed the precision of a value of 32 bits. */
export const loadIntegers = makeCache((array: PackedArray) => readIntegers(array));

/**
 * Replaces the report by a later one of the same run. The shown sequence stays; its frame too, unless it was the last
 * one, which the newest follows.
 */
export function followReport(data: ReportData): void {
  for (const id of takeArrays(data)) for (const cache of caches) cache.delete(id);
  const before = report.peek() as Report | null;
  const shown = before?.sequences[sequenceIndex.peek()];
  const wasLast = frameIndex.peek() >= (shown?.frames.length ?? 0) - 1;
  batch(() => {
    report.value = { ...data.report, ...data.results };
    follows.value = true;
    if (!shown) return;
    const sequences = report.value.sequences;
    sequenceIndex.value = Math.max(0, sequences.findIndex(({ id }) => id === shown.id));
    const last = Math.max(0, (sequence.value?.frames.length ?? 0) - 1);
    frameIndex.value = wasLast ? last : Math.min(frameIndex.value, last);
  });
}

/**
 * Returns the value that `start` decodes for `of`; null until it is there, where it cannot be read, and where there is nothing to decode.
 * A page that follows a run keeps what it has until the next is decoded.
 */
export function useLoaded<T>(start: () => Promise<T> | null | undefined, of: unknown): T | null {
  const [found, setFound] = useState<{ of: unknown; data: T | null } | null>(null);
  useEffect(() => {
    let wanted = true;
    start()?.then(
      (data) => wanted && setFound({ of, data }),
      () => wanted && setFound({ of, data: null }),
    );
    return () => void (wanted = false);
  }, [of]);
  return found && (found.of === of || (follows.value && of)) ? found.data : null;
}

export const printing = signal(false);

if (typeof window !== "undefined") {
  window.addEventListener("beforeprint", () => (printing.value = true));
  window.addEventListener("afterprint", () => (printing.value = false));
}
