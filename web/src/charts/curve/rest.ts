/** Did a trial of the displacement curve come to rest? It runs its whole window, so its last state has to be judged. */
import type { Curve, InputTable } from "../../contract";

export interface RestLimits {
  /** Largest out-of-balance force over the external force [-]. */
  forceRatio: number;
  /** Largest nodal speed [m/s]: speed_ratio × √(gH). */
  nodalSpeed: number;
}

export type TrialState = "rest" | "moving" | "failed";

function readLeaf(input: InputTable, table: string, key: string): number | null {
  const inner = input[table] as InputTable | undefined;
  const leaf = inner?.[key] as { value?: unknown } | undefined;
  return typeof leaf?.value === "number" ? leaf.value : null;
}

/** The limits of the case's [rest] table; its defaults where the report does not hold them. */
export function findRestLimits(input: InputTable, slopeHeight: number): RestLimits {
  const g = readLeaf(input, "gravity", "acceleration") ?? 9.81;
  const ratio = readLeaf(input, "rest", "speed_ratio") ?? 1e-4;
  const forceRatio = readLeaf(input, "rest", "force_ratio") ?? 1e-3;
  return { forceRatio, nodalSpeed: ratio * Math.sqrt(g * slopeHeight) };
}

/** State of a trial at its end: by its word where that says it, else by force ratio and nodal speed. */
export function judgeTrial(point: Curve["points"][number], limits: RestLimits): TrialState {
  if (point.end === "rest" || point.end === "failed") return point.end;
  return point.force_ratio < limits.forceRatio && point.nodal_speed < limits.nodalSpeed ? "rest" : "moving";
}

export const stateWords: Record<TrialState, string> = {
  rest: "at rest at its end",
  moving: "still moving at its end",
  failed: "ended as failed",
};
