// SPDX-License-Identifier: MIT
/** What the canvas shows of a run: slip surfaces with their factors, and the material points of the newest frame. */
import { signal } from "@preact/signals";

import type { RunResults } from "../engine/http";
import type { Point } from "../geometry/plane";
import type { RunFrame, RunValue } from "./liveRun";

export interface ShownRun {
  id: string;
  surfaces: { name: string; method: string; points: Point[] }[];
  frame: RunFrame | null;
}

export const shown = signal<ShownRun | null>(null);

export function showResults(id: string, { surfaces }: RunResults): void {
  const named = surfaces.map(({ title, method, factor, points }) => ({
    name: factor === null ? title : `${title} ${factor.toFixed(3)}`,
    method,
    points,
  }));
  shown.value = { id, surfaces: named, frame: null };
}

/** The newest value of a run in progress. */
export function showValue(id: string, value: RunValue | null, frame: RunFrame | null): void {
  const surfaces = value?.surface
    ? [{ name: `${value.series || value.method} ${value.factor?.toFixed(3) ?? ""}`, method: value.method, points: value.surface }]
    : [];
  shown.value = { id, surfaces, frame };
}
