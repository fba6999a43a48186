// SPDX-License-Identifier: MIT
/** The time of the timeline that is shown: one for the curve, the section and the table. */
import { signal } from "@preact/signals";

import type { Timeline } from "../contract";

const picked = signal<number | null>(null);

/** Number of the time; first that of the least factor. */
export function chosenMoment(timeline: Timeline): number {
  const least = timeline.factors.findIndex((f) => f.time === timeline.least_time);
  return Math.min(picked.value ?? Math.max(0, least), timeline.factors.length - 1);
}

export function chooseMoment(moment: number) {
  picked.value = moment;
}
