// SPDX-License-Identifier: MIT
/** Initial state of the viewer with slip surfaces of other methods over the points of MPM. */
import { effect } from "@preact/signals";
import { findRestLimits, judgeTrial } from "../charts/curve/rest";
import { findMethods } from "../compared/methodTable";
import type { Report } from "../contract";
import { fieldName, frameIndex, sequenceIndex } from "../state";
import { limitMode } from "../viewer/settings";

/**
 * The trial of the displacement curve that shows the mechanism: of those above the main factor of MPM
 * the first that does not come to rest, else the first. Null for MPM alone, and without such a trial.
 */
export function findMechanism(report: Report): { sequence: number; frame: number } | null {
  if (!findMethods(report)?.surfaces.some((s) => s.method !== "mpm")) return null;
  const main = report.answer.factors.find((f) => f.method === "mpm" && f.main)?.value;
  const sequence = report.sequences.findIndex((s) => s.kind === "curve");
  if (main === null || main === undefined || sequence < 0) return null;
  const limits = findRestLimits(report.result.input, report.model.slope_height);
  const moves = (factor: number) => {
    const point = report.result.curve?.points.find((p) => Math.abs(p.srf - factor) < 1e-9);
    return point !== undefined && judgeTrial(point, limits) !== "rest";
  };
  const above = report.sequences[sequence]!.frames
    .map(({ factor }, frame) => ({ factor: factor ?? 0, frame }))
    .filter(({ factor }) => factor > main)
    .sort((a, b) => a.factor - b.factor);
  const chosen = above.find(({ factor }) => moves(factor)) ?? above[0];
  return chosen ? { sequence, frame: chosen.frame } : null;
}

/** Before the viewer is drawn, which keeps what it finds chosen. */
export function openAtMechanism(report: Report): void {
  const found = findMechanism(report);
  if (!found) return;
  sequenceIndex.value = found.sequence;
  frameIndex.value = found.frame;
  // Limits over all trials are the strains of the failed ones, next to which a slip band is pale. Another sequence has its
  // usual limits again.
  const usual = limitMode.value;
  limitMode.value = "frame";
  const stop = effect(() => {
    if (sequenceIndex.value === found.sequence) return;
    if (limitMode.peek() === "frame") limitMode.value = usual;
    queueMicrotask(() => stop());
  });
  const fields = report.sequences[found.sequence]!.fields.map((f) => f.name);
  if (!fields.includes(fieldName.value)) fieldName.value = fields[0] ?? "";
}
