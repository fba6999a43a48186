// SPDX-License-Identifier: MIT
/** Mouse, fingers and wheel over a drawing. */
import type { Vec } from "../viewer/camera";
import type { View } from "./view";

/** Moves by dragging with the mouse, or with a finger once the view is not whole; the wheel zooms where it has focus. */
export function listen(host: HTMLElement, view: View, point: (at: [number, number] | null) => void): () => void {
  let last: Vec | null = null;
  const down = (event: PointerEvent) => {
    if (event.button !== 0 || (event.pointerType === "touch" && !view.touched)) return;
    last = [event.clientX, event.clientY, 0];
    host.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent) => {
    if (last) {
      view.pan(event.clientX - last[0], event.clientY - last[1]);
      last = [event.clientX, event.clientY, 0];
    } else point(view.locate(event.clientX, event.clientY));
  };
  const up = () => (last = null);
  const leave = (event: PointerEvent) => {
    if (event.pointerType !== "touch") point(null);
  };
  const wheel = (event: WheelEvent) => {
    if (document.activeElement !== host) return;
    event.preventDefault();
    const { left, top } = host.getBoundingClientRect();
    view.zoom(Math.exp(-event.deltaY * 0.0015), event.clientX - left, event.clientY - top);
  };
  const pairs: [string, (event: never) => void][] = [
    ["pointerdown", down],
    ["pointermove", move],
    ["pointerup", up],
    ["pointercancel", up],
    ["pointerleave", leave],
  ];
  for (const [name, act] of pairs) host.addEventListener(name, act as EventListener);
  host.addEventListener("wheel", wheel, { passive: false });
  return () => {
    for (const [name, act] of pairs) host.removeEventListener(name, act as EventListener);
    host.removeEventListener("wheel", wheel);
  };
}
