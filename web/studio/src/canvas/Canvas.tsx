// SPDX-License-Identifier: MIT
/** The canvas: the section with its layers, mouse, fingers, wheel and keys on it. */
import { effect, untracked } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { ZoomButtons } from "../../../src/drawing/buttons";
import { RunLayer } from "../runs/RunLayer";
import * as state from "../state";
import { length } from "../units";
import { findGridStep, size, view, zoomBy } from "./camera";
import { fitAll } from "./hit";
import { pressKey } from "./keys";
import { Labels, WorldLayers } from "./layers";
import { Draft, Grid, Handles, MessageMarks, PictureMarks, Rulers, SnapMarker } from "./overlay";
import { listenToPointer } from "./pointing";

const help =
  "Section of the slope. Comma and full stop select the previous or next vertex, arrow keys move it, or the view where nothing is selected; " +
  "Delete deletes; plus, minus and 0 zoom; digits begin typed coordinates; Escape ends.";

export function Canvas() {
  const host = useRef<HTMLDivElement>(null);
  const drawing = useRef<SVGSVGElement>(null);

  useEffect(() => {
    const measure = () => {
      const { width, height } = host.current!.getBoundingClientRect();
      if (width < 20 || height < 20) return;
      // Beside a report, and after a phone is turned, the same part of the section stays in sight.
      const ratio = width / size.value.width;
      if (Math.abs(ratio - 1) > 0.2) view.value = { ...view.value, scale: view.value.scale * ratio };
      size.value = { width: Math.round(width), height: Math.round(height) };
    };
    const observer = new ResizeObserver(measure);
    observer.observe(host.current!);
    measure();
    const stop = listenToPointer(drawing.current!);
    // A section by layers is known once the engine has built it.
    let fitted = -1;
    const stopFit = effect(() => {
      const turn = state.opened.value;
      const isKnown = state.regions.value.length > 0;
      if (fitted === turn) return;
      if (isKnown) fitted = turn;
      untracked(fitAll);
    });
    const stopGrid = effect(() => {
      const { size: unit } = length.value;
      state.gridStep.value = findGridStep(view.value.scale * unit) * unit;
    });
    return () => {
      observer.disconnect();
      stop();
      stopFit();
      stopGrid();
    };
  }, []);

  return (
    <div class="canvas" ref={host}>
      <svg
        ref={drawing}
        class={`section tool-${state.tool.value}`}
        width={size.value.width}
        height={size.value.height}
        viewBox={`0 0 ${size.value.width} ${size.value.height}`}
        tabindex={0}
        role="application"
        aria-roledescription="drawing"
        aria-label={help}
        onKeyDown={pressKey}
      >
        <Grid />
        <WorldLayers />
        <Labels />
        <RunLayer />
        <Handles />
        <Draft />
        <PictureMarks />
        <MessageMarks />
        <SnapMarker />
        <Rulers />
      </svg>
      <div class="icon-buttons zoom-buttons">
        <ZoomButtons zoom={zoomBy} fit={fitAll} />
      </div>
    </div>
  );
}
