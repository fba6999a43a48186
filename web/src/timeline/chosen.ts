// SPDX-License-Identifier: MIT
/** The timeline with the words and fields that the report adds, its rain and levels, and its shown part: one time for the curve, the section and the table; the released points. */
import { computed, signal } from "@preact/signals";

import type { HydraulicCondition, Release, Timeline } from "../contract";
import { frameIndex, report, sequenceIndex } from "../state";
import { evaluateSeries } from "../viewer/symbols";

export interface RainBar {
  /** [s] */
  from: number;
  to: number;
  /** In the unit of its series. */
  rate: number;
}

/** The strongest rain series. */
export function findRain(conditions: HydraulicCondition[]): HydraulicCondition["series"] {
  const rains = conditions.filter((c) => c.condition === "rain" && c.series);
  const most = (c: HydraulicCondition) => Math.max(0, ...(c.series?.values ?? []));
  return rains.sort((a, b) => most(b) - most(a))[0]?.series;
}

/** The rain series between 0 and `duration` [s]; rows that change linearly have their mean. */
export function listRain(conditions: HydraulicCondition[], duration: number): RainBar[] {
  const series = findRain(conditions);
  if (!series) return [];
  const { time, values } = series;
  const bars: RainBar[] = [];
  const add = (from: number, to: number, rate: number) => {
    const [a, b] = [Math.max(0, from), Math.min(duration, to)];
    if (b > a && rate > 0) bars.push({ from: a, to: b, rate });
  };
  if (time.length > 0) add(0, time[0]!, values[0]!);
  for (let i = 1; i < time.length; ++i) add(time[i - 1]!, time[i]!, (values[i - 1]! + values[i]!) / 2);
  if (time.length > 0) add(time.at(-1)!, duration, values.at(-1)!);
  return bars;
}

export interface LevelLine {
  on: string;
  unit: string;
  /** Time [s] and level, from 0 to the duration; a jump has two points at one time. */
  points: [number, number][];
}

/** The total heads that change between 0 and `duration` [s]. */
export function listLevels(conditions: HydraulicCondition[], duration: number): LevelLine[] {
  return conditions.flatMap(({ condition, on, series }) => {
    if (condition !== "total_head" || !series || series.time.length === 0) return [];
    const { time, values } = series;
    const at = (t: number) => evaluateSeries({ series }, t);
    const inside = time.flatMap((t, i): [number, number][] => (t >= 0 && t <= duration ? [[t, values[i]!]] : []));
    const before: [number, number] = [0, inside.length && inside[0]![0] === 0 ? inside[0]![1] : at(0)];
    const points: [number, number][] = [before, ...inside, [duration, at(duration)]];
    return new Set(points.map(([, level]) => level)).size > 1 ? [{ on, unit: series.unit.name, points }] : [];
  });
}

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
