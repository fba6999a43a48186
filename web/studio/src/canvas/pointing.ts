// SPDX-License-Identifier: MIT
/** Mouse, pen and fingers on the canvas: hover, drag of vertices and sides, pan, pinch, wheel. */
import { listenTo } from "../../../src/viewer/theme";
import { distance, type Point } from "../geometry/plane";
import { type Snapped, snap } from "../geometry/snap";
import * as state from "../state";
import { length } from "../units";
import { panBy, toScreen, toWorld, view, zoomAt } from "./camera";
import { addPoint, finishDraft, insertAt } from "./drawing";
import { findHit, type Hit } from "./hit";
import { type Drag, endDrag, startDrag } from "./moving";
import { pointer } from "./overlay";

/** Pixels within which a place snaps. */
export const snapRadius = 8;

/** Snapped place of a pixel; `without`: a vertex that moves; `anchor`: where it began. */
export function snapPixel(pixel: Point, free: boolean, without: Point | null = null, anchor: Point | null = null): Snapped {
  const { scale } = view.value;
  const at = toWorld(pixel);
  const on = state.snapping.value && !free;
  const targets = on ? { ...state.listTargets(without), anchor: anchor ?? state.draft.value.at(-1) ?? null } : { vertices: [], segments: [], grid: 0, unit: length.value.size };
  return snap(at, targets, snapRadius / scale, 1 / scale);
}

/** Shift or Ctrl adds to the selection. */
const isMore = (event: MouseEvent) => event.shiftKey || event.ctrlKey || event.metaKey;

/** A pressed pointer that has not yet moved far enough to be a drag. */
interface Press {
  pixel: Point;
  hit: Hit;
  drag: Drag | null;
  moved: boolean;
}

export function listenToPointer(svg: SVGSVGElement): () => void {
  const fingers = new Map<number, Point>();
  let press: Press | null = null;

  const findPixel = (event: MouseEvent): Point => {
    const box = svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const findReach = (event: PointerEvent) => (event.pointerType === "touch" ? 18 : 9) / view.value.scale;

  const selectHit = (hit: Hit, more: boolean) => {
    if (hit.kind === "vertex") state.selection.value = { kind: "vertex", at: hit.at };
    else if (hit.kind === "side") state.selectChain(hit.chain, more);
    else if (hit.kind === "load") state.selection.value = { kind: "load", index: hit.index };
    else if (hit.kind === "part") state.selection.value = { kind: "part", id: hit.id };
    else if (hit.kind === "region" && state.chains.value.some(({ id }) => id === hit.id)) state.selectChain(hit.id, more);
    else if (!more) state.selection.value = { kind: "none" };
  };

  const down = (event: PointerEvent) => {
    if (event.button > 1) return;
    svg.focus({ preventScroll: true });
    svg.setPointerCapture(event.pointerId);
    const pixel = findPixel(event);
    fingers.set(event.pointerId, pixel);
    if (fingers.size > 1) {
      if (press?.drag) endDrag();
      press = null;
      return;
    }
    const selecting = state.tool.value === "select" && event.button === 0;
    const hit: Hit = selecting ? findHit(toWorld(pixel), findReach(event)) : { kind: "nothing" };
    press = { pixel, hit, drag: null, moved: false };
    if (selecting && hit.kind !== "nothing" && hit.kind !== "region" && !isMore(event)) selectHit(hit, false);
  };

  const pinch = (id: number, pixel: Point) => {
    const [a, b] = [...fingers.entries()];
    const other = a![0] === id ? b![1] : a![1];
    const before = fingers.get(id)!;
    const middle: Point = [(pixel[0] + other[0]) / 2, (pixel[1] + other[1]) / 2];
    panBy((pixel[0] - before[0]) / 2, (pixel[1] - before[1]) / 2);
    zoomAt(middle, distance(pixel, other) / Math.max(1, distance(before, other)));
  };

  const dragTo = (now: Press, pixel: Point, event: PointerEvent) => {
    if (!now.moved) {
      now.moved = true;
      now.drag = state.tool.value === "select" ? startDrag(now.hit, event.shiftKey) : null;
    }
    const { drag } = now;
    if (drag) {
      const current = now.hit.kind === "vertex" ? state.selectedVertex.value?.at ?? drag.from : null;
      const snapped = snapPixel(pixel, event.altKey, current, now.hit.kind === "vertex" || now.hit.kind === "side" ? drag.from : null);
      pointer.value = snapped;
      drag.to(snapped.at);
    } else {
      const before = fingers.get(event.pointerId) ?? pixel;
      panBy(pixel[0] - before[0], pixel[1] - before[1]);
    }
  };

  const move = (event: PointerEvent) => {
    const pixel = findPixel(event);
    if (fingers.size === 2 && fingers.has(event.pointerId)) pinch(event.pointerId, pixel);
    else if (press && (press.moved || distance(pixel, press.pixel) > 4)) dragTo(press, pixel, event);
    else if (!press) hover(pixel, event);
    if (fingers.has(event.pointerId)) fingers.set(event.pointerId, pixel);
  };

  const hover = (pixel: Point, event: PointerEvent) => {
    const snapped = snapPixel(pixel, event.altKey);
    const drawing = state.tool.value !== "select";
    pointer.value = drawing || snapped.kind === "vertex" ? snapped : { at: snapPixel(pixel, true).at, kind: "free" };
    const hit = drawing ? null : findHit(toWorld(pixel), findReach(event));
    svg.dataset.over = hit?.kind ?? "";
  };

  const up = (event: PointerEvent) => {
    const now = press;
    fingers.delete(event.pointerId);
    press = null;
    if (now?.drag || event.type === "pointercancel") return endDrag();
    if (!now) return;
    if (now.moved || event.button === 1) return;
    const pixel = findPixel(event);
    if (state.tool.value === "select") selectHit(now.hit, isMore(event));
    else click(pixel, event);
  };

  const click = (pixel: Point, event: PointerEvent) => {
    const first = state.draft.value[0];
    const closes = (state.tool.value === "region" || state.tool.value === "exclude") && state.draft.value.length > 2 && first && distance(toScreen(first), pixel) <= 12;
    if (closes) return void finishDraft();
    if (state.tool.value === "insert") {
      const at = snapPixel(pixel, event.altKey);
      const hit = findHit(at.at, 2 / view.value.scale);
      if (hit.kind === "side") insertAt(at.kind === "line" || at.kind === "intersection" ? at.at : hit.at, hit.chain);
      return;
    }
    addPoint(snapPixel(pixel, event.altKey).at);
  };

  const stop = listenTo(svg, {
    pointerdown: down,
    pointermove: move,
    pointerup: up,
    pointercancel: up,
    pointerleave: () => (pointer.value = null),
    dblclick: () => finishDraft(),
    wheel: (event: WheelEvent) => {
      event.preventDefault();
      zoomAt(findPixel(event), Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.0015)));
    },
  });
  return stop;
}
