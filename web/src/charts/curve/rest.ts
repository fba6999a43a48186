// SPDX-License-Identifier: MIT
/** Decides whether a trial of the displacement curve came to rest, by its last state, because it runs its whole window. */
import type { InputTable, Trial } from "../../contract";
import { findSetting } from "../../page/methods/settings";

export interface RestLimits {
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
