// SPDX-License-Identifier: MIT
/** Finds the point under a pixel, or next to another point in a direction. */
import { pickedPoint } from "../state";
import { inSpace } from "./settings";
import { shown } from "./shown";
import { radii } from "./sizes";
import type { Stage } from "./stage";

/** Calls back with each shown point's index, pixel and depth. */
function visitPoints(stage: Stage, visit: (index: number, x: number, y: number, depth: number) => void): void {
  const now = shown.value;
  if (!now) return;
  const project = stage.camera.makeProjection();
  for (let i = 0; i < now.sequence.point_count; ++i) {
    if (!radii.value[i]) continue;
    const [x, y, depth] = project(...stage.locate(i));
    visit(i, x, y, depth);
  }
}

/** Picks the point under a pixel: the nearest in a section, in space the foremost whose sphere is hit. */
export function pickAt(stage: Stage, px: number, py: number): void {
  const { scale } = stage.camera;
  let [best, bestScore] = [-1, Infinity];
  visitPoints(stage, (i, x, y, depth) => {
    const distance = Math.hypot(x - px, y - py);
    // In a section a press beside the soil picks what is near, as fingers are thick.
    const radius = Math.abs(radii.value[i]!) * scale;
    if (distance > (inSpace.value ? Math.max(2, radius) : Math.max(12, radius))) return;
    const bulge = Math.sqrt(Math.max(0, radius * radius - distance * distance)) / scale;
    const score = inSpace.value ? -depth - bulge : distance;
    if (score < bestScore) [best, bestScore] = [i, score];
  });
  pickedPoint.value = best < 0 ? null : best;
}

/** Picks the next point in a direction on the screen; the one in the middle of the view when none is picked. */
export function pickNext(stage: Stage, dx: number, dy: number): void {
  const picked = pickedPoint.value;
  const from = picked !== null && radii.value[picked] ? picked : null;
  const [px, py] = from === null ? stage.camera.centre : stage.camera.makeProjection()(...stage.locate(from));
  let [best, bestScore] = [-1, Infinity];
  visitPoints(stage, (i, x, y) => {
    if (i === from) return;
    const along = (x - px) * dx + (y - py) * dy;
    const across = Math.abs((x - px) * dy - (y - py) * dx);
    const score = from === null ? Math.hypot(x - px, y - py) : along + 2 * across;
    if ((from === null || along > across) && score < bestScore) [best, bestScore] = [i, score];
  });
  if (best >= 0) pickedPoint.value = best;
}
