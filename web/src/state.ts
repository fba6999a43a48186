// SPDX-License-Identifier: MIT
/** Common state of the parts of the page: the shown frame, the field, the picked point, whether it is printed. */
import { computed, signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";

import type { PackedArray, PackedPlaces, Report, Sequence } from "./contract";
import { readIntegers, readPlaces, readValues } from "./data";

/** The report, set once before anything is drawn. */
export const report = signal<Report>(null as unknown as Report);

/** Index in report.sequences. */
export const sequenceIndex = signal(0);
/** Index of the frame in the sequence. */
export const frameIndex = signal(0);
/** Name of the field that colours the points; "material" is none of the stored ones. */
export const fieldName = signal("deviatoric_strain");
/** Index of the picked point in the arrays of the sequence (not its id), or null. */
export const pickedPoint = signal<number | null>(null);

export const sequence = computed<Sequence | null>(() => report.value.sequences[sequenceIndex.value] ?? null);

function makeCache<A extends PackedArray, T>(read: (array: A) => Promise<T>): (array: A) => Promise<T> {
  const cache = new Map<string, Promise<T>>();
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

/** What `start` decodes for `of`; null until it is there, where it cannot be read, and where there is nothing to decode. */
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
  return found && found.of === of ? found.data : null;
}

export const printing = signal(false);

if (typeof window !== "undefined") {
  window.addEventListener("beforeprint", () => (printing.value = true));
  window.addEventListener("afterprint", () => (printing.value = false));
}
