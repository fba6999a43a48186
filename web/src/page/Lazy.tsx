// SPDX-License-Identifier: MIT
/** Parts that are drawn when they come near the screen, when the page is idle, or before it is printed. */
import { signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

/** Set once everything has to be there, whatever is on the screen. */
const everything = signal(false);
const waiting: (() => void)[] = [];
let idle = false;

const whenIdle: (action: () => void) => void =
  "requestIdleCallback" in globalThis
    ? (action) => requestIdleCallback(action, { timeout: 1500 })
    : (action) => setTimeout(action, 60);

/** Draws one part after the other, so that the page stays responsive; marks <html> when all are drawn. */
function drawNext() {
  const next = waiting.shift();
  if (next) {
    next();
    whenIdle(drawNext);
  } else {
    idle = false;
    document.documentElement.dataset.drawn = "all";
  }
}

function wait(draw: () => void) {
  delete document.documentElement.dataset.drawn;
  waiting.push(draw);
  if (idle) return;
  idle = true;
  setTimeout(() => whenIdle(drawNext), 400);
}

/** Draws all parts now: before printing. */
export function drawEverything() {
  everything.value = true;
}

interface Props {
  /** Height of the part before it is drawn [px], so that the page does not jump. */
  height: number;
  children: () => ComponentChildren;
}

export function Lazy({ height, children }: Props) {
  const [drawn, setDrawn] = useState(false);
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const draw = () => setDrawn(true);
    wait(draw);
    const observer = new IntersectionObserver(
      (entries) => {
        if (entries.some((entry) => entry.isIntersecting)) draw();
      },
      { rootMargin: "500px" },
    );
    if (place.current) observer.observe(place.current);
    return () => observer.disconnect();
  }, []);
  if (drawn || everything.value) return <>{children()}</>;
  return <div ref={place} class="not-yet" style={{ minHeight: `${height}px` }} aria-busy="true" />;
}
