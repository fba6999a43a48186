// SPDX-License-Identifier: MIT
/** What a run has found so far, from the events of the server, and the curves that are drawn of it. */
import type { Point } from "../geometry/plane";

/** Values of a line of progress; see ProgressValues of the program. */
export interface RunValue {
  method: string;
  series?: string;
  lower?: number;
  upper?: number;
  factor?: number;
  holds?: boolean;
  /** [m] */
  displacement?: number;
  /** [s] */
  time?: number;
  done?: number;
  total?: number;
  surface?: Point[];
}

/** Material points of one time [m], at most some thousand of them. */
export interface RunFrame {
  time: number;
  stage: string;
  count: number;
  x: number[];
  y: number[];
  displacement: number[];
}

export interface LiveRun {
  values: RunValue[];
  /** Largest displacement [m] over the time of a stage [s]. */
  motion: { stage: string; points: Point[] };
  frame: RunFrame | null;
}

export const emptyRun: LiveRun = { values: [], motion: { stage: "", points: [] }, frame: null };

/** Values are few hundred; a study of thousands keeps the newest. */
const mostValues = 2000;
const mostMotions = 600;

export function addValue(run: LiveRun, value: RunValue): LiveRun {
  return { ...run, values: [...run.values.slice(1 - mostValues), value] };
}

/** Adds the displacement of a line of progress; every second place is dropped where there are too many. */
export function addMotion(run: LiveRun, stage: string, time: number, displacement: number): LiveRun {
  const before = run.motion.stage === stage ? run.motion.points : [];
  const last = before.at(-1);
  const kept = last && time <= last[0] ? before.filter(([t]) => t < time) : before;
  const thinned = kept.length >= mostMotions ? kept.filter((_, i) => i % 2 === 0) : kept;
  return { ...run, motion: { stage, points: [...thinned, [time, displacement]] } };
}

export interface Curve {
  title: string;
  x: string;
  y: string;
  /** Connected points. */
  line: Point[];
  /** Trials with equilibrium (true) and without, results (null). */
  marks: { at: Point; holds: boolean | null; label: string }[];
  /** A band between two lines with the same x. */
  band?: { lower: Point[]; upper: Point[] };
}

function bySeries(values: RunValue[]): Map<string, RunValue[]> {
  const groups = new Map<string, RunValue[]>();
  for (const value of values) {
    const key = `${value.method} ${value.method === "study" ? "" : (value.series ?? "")}`;
    groups.set(key, [...(groups.get(key) ?? []), value]);
  }
  return groups;
}

/** FEM and MPM: displacement over the factor of each trial. */
function drawTrials(title: string, values: RunValue[]): Curve | null {
  const trials = values.filter((v) => v.factor !== undefined && v.displacement !== undefined);
  if (!trials.length) return null;
  const marks = trials.map((v) => ({
    at: [v.factor!, v.displacement!] as Point,
    holds: v.holds ?? null,
    label: `${v.factor!.toPrecision(4)}${v.holds === undefined ? "" : v.holds ? ", equilibrium" : ", no equilibrium"}`,
  }));
  const line = marks.map(({ at }) => at).toSorted((a, b) => a[0] - b[0]);
  return { title, x: "factor", y: "displacement [m]", line, marks };
}

/** Limit analysis: the interval as it narrows. */
function drawInterval(title: string, values: RunValue[]): Curve | null {
  const known = values.filter((v) => v.lower !== undefined && v.upper !== undefined);
  if (!known.length) return null;
  return {
    title,
    x: "mesh",
    y: "factor",
    line: [],
    marks: [],
    band: { lower: known.map((v, i) => [i + 1, v.lower!]), upper: known.map((v, i) => [i + 1, v.upper!]) },
  };
}

/** A timeline: the factor over time; each time may be found several times, the last counts. */
function drawTimeline(values: RunValue[]): Curve | null {
  const found = new Map(values.flatMap((v) => (v.factor === undefined || v.time === undefined ? [] : [[v.time, v.factor] as const])));
  if (!found.size) return null;
  const line = [...found].toSorted((a, b) => a[0] - b[0]).map(([t, f]): Point => [t / 3600, f]);
  return { title: "Factor in time", x: "time [h]", y: "factor", line, marks: line.map((at) => ({ at, holds: null, label: at[1].toFixed(3) })) };
}

/** A study: the factor of every variant, in the order in which they ended. */
function drawStudy(values: RunValue[]): Curve | null {
  const marks = values.flatMap((v, i) =>
    v.factor === undefined ? [] : [{ at: [v.done ?? i + 1, v.factor] as Point, holds: null, label: `${v.series ?? ""}: ${v.factor.toFixed(3)}` }],
  );
  return marks.length ? { title: "Variants", x: "variants done", y: "factor", line: [], marks } : null;
}

export function listCurves({ values, motion }: LiveRun): Curve[] {
  const curves = [...bySeries(values)].map(([, list]) => {
    const { method, series } = list[0]!;
    if (method === "timeline") return drawTimeline(list);
    if (method === "study") return drawStudy(list);
    if (method === "bounds") return drawInterval("Limit analysis", list);
    return drawTrials(method === "fem" ? `FEM, ${series ?? ""}` : `MPM, ${series ?? ""}`, list);
  });
  if (motion.points.length > 1)
    curves.push({ title: `MPM, ${motion.stage}`, x: "time [s]", y: "largest displacement [m]", line: motion.points, marks: [] });
  return curves.filter((curve) => curve !== null);
}

/** The newest result or interval of every method, one sentence each. */
export function listFindings(values: RunValue[]): { name: string; text: string; surface?: Point[] }[] {
  return [...bySeries(values)].flatMap(([, list]) => {
    const { method, series } = list[0]!;
    if (method === "study" || method === "timeline") return [];
    const name = method === "bounds" ? "Limit analysis" : `${method.toUpperCase()}${series ? `, ${series}` : ""}`;
    const result = list.findLast((v) => v.factor !== undefined && v.holds === undefined && v.displacement === undefined);
    if (result) return [{ name, text: result.factor!.toFixed(3), surface: result.surface }];
    const ends = list.findLast((v) => v.lower !== undefined || v.upper !== undefined);
    if (!ends) return [];
    const show = (end: number | undefined) => end?.toFixed(3) ?? "–";
    return [{ name, text: `${show(ends.lower)} to ${show(ends.upper)}` }];
  });
}

/** The newest slip surface with its factor, of any method. */
export function findSurface(values: RunValue[]): RunValue | null {
  return values.findLast((v) => (v.surface?.length ?? 0) > 1) ?? null;
}
