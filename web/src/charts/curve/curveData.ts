// SPDX-License-Identifier: MIT
/** The displacement curve as columns, its fitted lines as points, and the places of the labels of the factors. */
import type { Branch, DisplacementCurve, Trial } from "../../contract";
import type { CsvColumn } from "../base/csv";

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

export interface Flags {
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
