/** Which point stands under a pixel, or next to another point in a direction. */
import { pickedPoint, report } from "../state";
import { cut, inSpace } from "./settings";
import { shown } from "./shown";
import type { Stage } from "./stage";

/** Calls back with each point's index, pixel and depth. */
function visitPoints(stage: Stage, visit: (index: number, x: number, y: number, depth: number) => void): void {
  const now = shown.value;
  if (!now) return;
  const project = stage.camera.makeProjection();
  const [low, high] = now.box;
  const solid = report.value.model.dimension === 3;
  for (let i = 0; i < now.sequence.point_count; ++i) {
    const at = stage.locate(i);
    const inside = (k: number) => {
      const share = (at[k]! - low[k]!) / (high[k]! - low[k]! || 1);
      return share >= cut.value[k]![0] && share <= cut.value[k]![1];
    };
    if (solid && !(inside(0) && inside(1) && inside(2))) continue;
    const [x, y, depth] = project(...at);
    visit(i, x, y, depth);
  }
}

/** Picks the point under a pixel: the nearest in a section, in space the foremost whose sphere is hit. */
export function pickAt(stage: Stage, px: number, py: number): void {
  const reach = Math.max(12, (shown.value?.spacing ?? 0) * stage.camera.scale * 0.8);
  let [best, bestScore] = [-1, Infinity];
  visitPoints(stage, (i, x, y, depth) => {
    const distance = Math.hypot(x - px, y - py);
    const score = inSpace.value ? distance / stage.camera.scale - depth : distance;
    if (distance <= reach && score < bestScore) [best, bestScore] = [i, score];
  });
  pickedPoint.value = best < 0 ? null : best;
}

/** Picks the next point in a direction on the screen; the one in the middle of the view when none is picked. */
export function pickNext(stage: Stage, dx: number, dy: number): void {
  const from = pickedPoint.value;
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
