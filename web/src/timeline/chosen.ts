// SPDX-License-Identifier: MIT
/** The timeline with the words and fields that the report adds, and its shown part: one time for the curve, the section and the table; the released points. */
import { computed, signal } from "@preact/signals";

import type { Release, Timeline } from "../contract";
import { frameIndex, report, sequenceIndex } from "../state";

export const shownTimeline = computed(() => {
  const { result, timeline: shown } = report.value;
  const { timeline } = result;
  if (!timeline || !shown) return undefined;
  return {
    ...timeline,
    unit: shown.unit,
    sentence: shown.sentence,
    water_mesh: shown.water_mesh,
    factors: timeline.factors.map((factor, i) => ({ ...factor, title: shown.factors[i]! })),
    elements: timeline.elements.map((reduction, i) => ({ ...reduction, title: shown.elements[i]! })),
    states: timeline.states.map((state, i) => ({ ...state, ...shown.states[i]! })),
    releases: timeline.releases.map((release, i) => ({ ...release, ...shown.releases[i]! })),
  };
});

export type ShownTimeline = NonNullable<typeof shownTimeline.value>;
export type ShownRelease = ShownTimeline["releases"][number];

const picked = signal<number | null>(null);

/** Number of the time; first that of the least factor. */
export function chosenMoment(timeline: Timeline): number {
  const least = timeline.factors.findIndex((f) => f.time === timeline.least_time);
  return Math.min(picked.value ?? Math.max(0, least), timeline.factors.length - 1);
}

/** The tried time that is nearest to a time [s]. */
export function findMoment({ factors }: Timeline, time: number): number {
  const distance = (i: number) => Math.abs(factors[i]!.time - time);
  return factors.reduce((best, _, i) => (distance(i) < distance(best) ? i : best), 0);
}

export function chooseMoment(moment: number) {
  picked.value = moment;
}

export type FirstFigure = "time" | "motion";
const figure = signal<FirstFigure | null>(null);

/** Selects the first figure: with a release it is the final position of the soil. */
export function chosenFigure(timeline: Timeline): FirstFigure {
  const moved = timeline.releases.some((r) => r.error === null);
  return report.value.sequences.length === 0 ? "time" : (figure.value ?? (moved ? "motion" : "time"));
}

export function chooseFigure(first: FirstFigure) {
  figure.value = first;
}

/** Index of the sequence with the points of a release; -1: its frames are not in this report. */
export const findRelease = ({ folder }: Release): number =>
  report.value.sequences.findIndex((s) => s.id === (folder || "stages"));

/** Shows the end of a release in the first figure. */
export function showRelease(release: Release) {
  const found = findRelease(release);
  if (found < 0) return;
  sequenceIndex.value = found;
  frameIndex.value = report.value.sequences[found]!.frames.length - 1;
  chooseFigure("motion");
}
