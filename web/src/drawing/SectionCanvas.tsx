// SPDX-License-Identifier: MIT
/** A section drawn on a canvas, with rulers, a scalar bar, a reading under the pointer, zoom and print. */
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";

import type { Bar, Key } from "../viewer/scaleBar";
import { IconButton, ZoomButtons } from "./buttons";
import type { Box, Pen } from "./pen";
import { listen, View } from "./view";
import "./drawing.css";

interface Props {
  /** Description of the picture for readers who cannot see it. */
  label: string;
  box: Box;
  draw: (pen: Pen) => void;
  /** Dependencies of `draw`. */
  depends: unknown[];
  /** Lies over it, and is drawn alone when only `dependsOver` changes. */
  drawOver?: (pen: Pen) => void;
  dependsOver?: unknown[];
  bar?: Bar | Key | null;
  tallest?: number;
  /** Reading at a place; `reach` is about four pixels [m]. */
  read?: (at: [number, number], reach: number) => string;
  hint?: string;
  /** File name of the saved picture. */
  file: string;
}

const steps: Record<string, [number, number]> = {
  ArrowLeft: [40, 0],
  ArrowRight: [-40, 0],
  ArrowUp: [0, 40],
  ArrowDown: [0, -40],
};

export function SectionCanvas(props: Props) {
  const host = useRef<HTMLDivElement>(null);
  const view = useRef<View | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const [reading, setReading] = useState("");
  const { box, draw, drawOver, bar = null, tallest = 460, file } = props;
  const drawing = { box, draw, drawOver, bar, tallest };

  // At once: what is drawn because of printing has no time for more.
  useLayoutEffect(() => {
    const made = (view.current = new View(host.current!, drawing));
    const stop = listen(host.current!, made, (at) => {
      const { read } = latest.current;
      if (read) setReading(at ? read(at, 4 / made.camera.scale) : "");
    });
    return () => {
      stop();
      made.dispose();
      view.current = null;
    };
  }, []);
  useEffect(() => view.current?.update(drawing, true), [JSON.stringify(box), bar, ...props.depends]);
  useEffect(() => view.current?.update(drawing, false), props.dependsOver ?? []);

  const press = (event: KeyboardEvent) => {
    const now = view.current;
    if (!now || event.ctrlKey || event.altKey || event.metaKey) return;
    const step = steps[event.key];
    if (step) now.pan(...step);
    else if (event.key === "+" || event.key === "=") now.zoom(1.25);
    else if (event.key === "-") now.zoom(0.8);
    else if (event.key === "0") now.fit();
    else return;
    event.preventDefault();
  };

  return (
    <div class="drawing">
      {props.read && (
        <p class="chart-reading" aria-live="polite">
          {reading || props.hint}
        </p>
      )}
      <div class="drawing-frame">
        <div
          ref={host}
          class="drawing-stage"
          tabIndex={0}
          role="application"
          aria-roledescription="drawing of a section"
          aria-label={`${props.label}. Plus and minus zoom, arrow keys move, 0 fits.`}
          onKeyDown={press}
        />
        <div class="icon-buttons drawing-buttons no-print">
          <ZoomButtons zoom={(factor) => view.current?.zoom(factor)} fit={() => view.current?.fit()} />
          <IconButton
            name="Save picture"
            path="M8 2v8M4.5 7 8 10.5 11.5 7M2.5 13.5h11"
            act={() => view.current?.save(`${file}.png`)}
          />
        </div>
      </div>
    </div>
  );
}
