// SPDX-License-Identifier: MIT
/** Mouse, pen and fingers on the stage: pan, zoom, turn, pick. */
import { pickedPoint } from "../state";
import { inSpace } from "./settings";
import { shown } from "./shown";
import { radii } from "./sizes";
import type { Stage } from "./stage";
import { listenTo } from "./theme";

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
function pickAt(stage: Stage, px: number, py: number): void {
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

/** Listens on the element that holds the stage; returns what ends that. */
export function listenToPointer(host: HTMLElement, stage: Stage): () => void {
  const held = new Map<number, { x: number; y: number }>();
  let travelled = 0;
  const place = (event: PointerEvent | WheelEvent) => {
    const box = host.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  function press(event: PointerEvent): void {
    if (event.button > 2) return;
    host.setPointerCapture(event.pointerId);
    held.set(event.pointerId, place(event));
    if (held.size === 1) travelled = 0;
  }

  function move(event: PointerEvent): void {
    const before = held.get(event.pointerId);
    if (!before) return;
    const now = place(event);
    const [dx, dy] = [now.x - before.x, now.y - before.y];
    travelled += Math.hypot(dx, dy);
    held.set(event.pointerId, now);
    if (travelled < 4) return;
    const other = [...held].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      // Two fingers: the middle moves the model, their distance zooms.
      const measure = (at: { x: number; y: number }) => Math.hypot(at.x - other.x, at.y - other.y);
      const [from, to] = [measure(before), measure(now)];
      stage.camera.pan(dx / 2, dy / 2);
      if (from > 10) stage.camera.zoom(to / from, (now.x + other.x) / 2, (now.y + other.y) / 2);
    } else if (inSpace.value && !event.shiftKey && !(event.buttons & 6)) {
      stage.camera.rotate(dx, dy);
    } else {
      stage.camera.pan(dx, dy);
    }
    stage.moved();
  }

  function release(event: PointerEvent): void {
    if (!held.delete(event.pointerId) || event.type === "pointercancel") return;
    if (travelled < 4 && held.size === 0 && event.button === 0) {
      const { x, y } = place(event);
      pickAt(stage, x, y);
    }
  }

  function turnWheel(event: WheelEvent): void {
    // The page scrolls past the viewer until the reader has clicked into it, or holds the control key.
    if (!event.ctrlKey && !host.contains(document.activeElement)) return;
    event.preventDefault();
    const { x, y } = place(event);
    stage.camera.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), x, y);
    stage.moved();
  }

  const stopMenu = (event: Event) => event.preventDefault();
  return listenTo(host, {
    pointerdown: press,
    pointermove: move,
    pointerup: release,
    pointercancel: release,
    wheel: turnWheel,
    contextmenu: stopMenu,
  });
}
