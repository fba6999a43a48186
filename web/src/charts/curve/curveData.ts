// SPDX-License-Identifier: MIT
/** The displacement curve as columns, its fitted lines as points, the places of the labels of the factors, and which trials came to rest. */
import type { Branch, DisplacementCurve, InputTable, Trial } from "../../contract";
import { findSetting } from "../../page/methods/settings";
import type { CsvColumn } from "../base/rows";

/** All that the curve holds, in SI, as in curve.csv of the results. */
export function makeCurveColumns(curve: DisplacementCurve): CsvColumn[] {
  const take = <K extends keyof Omit<Trial, "setbacks">>(key: K) => curve.points.map((p) => p[key]);
  return [
    { name: "srf", unit: "-", values: take("srf") },
    { name: "largest displacement", unit: "m", values: take("displacement") },
    { name: "end", values: take("end") },
    { name: "force ratio", unit: "-", values: take("force_ratio") },
    { name: "nodal speed", unit: "m/s", values: take("nodal_speed") },
  ];
}

/** The part of a fitted line between `from` and `to` whose displacement lies in [low, high], as [SRF, m]. */
export function sampleBranch(branch: Branch, from: number, to: number, low: number, high: number, count = 240) {
  const points: [number, number][] = [];
  for (let i = 0; i <= count; ++i) {
    const srf = from + ((to - from) * i) / count;
    const u = branch.slope * srf + branch.intercept;
    if (u >= low && u <= high) points.push([srf, u]);
  }
  return points;
}

interface Flags {
  /** Side of its line for each label. */
  side: "right" | "left";
  /** Row of each label, 0 next to the frame. */
  rows: number[];
}

/**
 * Gives each label a row above the frame so that none covers another one or the line of another one. `at`: places of
 * the lines [px], `widths` of the labels with their gaps [px]. Labels are to the right of their lines when all end
 * before `right`, else to the left.
 */
export function placeFlags(at: readonly number[], widths: readonly number[], right: number): Flags {
  const side = at.every((x, i) => x + widths[i]! <= right) ? "right" : "left";
  const sign = side === "right" ? 1 : -1;
  const order = at.map((_, i) => i).sort((a, b) => sign * (at[b]! - at[a]!));
  const rows = at.map(() => 0);
  // Each label is put above the lines that it reaches over; those were placed before.
  order.forEach((i, n) => {
    for (const k of order.slice(0, n))
      if (sign * (at[k]! - at[i]!) < widths[i]!) rows[i] = Math.max(rows[i]!, rows[k]! + 1);
  });
  return { side, rows };
}

interface RestLimits {
  /** Largest out-of-balance force over the external force [-]. */
  forceRatio: number;
  /** Largest nodal speed [m/s]: speed_ratio × √(gH). */
  nodalSpeed: number;
}

export type TrialState = "rest" | "moving" | "failed";

/** The limits of the case's [rest] table; its defaults where the report does not hold them. */
export function findRestLimits(input: InputTable, slopeHeight: number): RestLimits {
  const read = (path: string, otherwise: number) => {
    const value = findSetting(input, path);
    return typeof value === "number" ? value : otherwise;
  };
  const forceRatio = read("rest.force_ratio", 1e-3);
  const ratio = read("rest.speed_ratio", 1e-4);
  const g = read("gravity.acceleration", 9.81);
  return { forceRatio, nodalSpeed: ratio * Math.sqrt(g * slopeHeight) };
}

/** State of a trial at its end: by its word where that is given, else by force ratio and nodal speed. */
export function judgeTrial(point: Pick<Trial, "end" | "force_ratio" | "nodal_speed">, limits: RestLimits): TrialState {
  if (point.end === "rest" || point.end === "failed") return point.end;
  return point.force_ratio < limits.forceRatio && point.nodal_speed < limits.nodalSpeed ? "rest" : "moving";
}

export const stateWords: Record<TrialState, string> = {
  rest: "at rest at its end",
  moving: "still moving at its end",
  failed: "ended as failed",
};
