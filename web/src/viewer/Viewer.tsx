// SPDX-License-Identifier: MIT
/** The section viewer: the body of soil in every stored frame, coloured by any stored field. */
import { effect } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";

import { frameIndex, pickedPoint, report, sequence } from "../state";
import { startArrows } from "./arrows";
import { Legend } from "./Legend";
import { startMesh } from "./meshEdges";
import { listenToPointer, pickNext } from "./pointer";
import { PickPanel } from "./PickPanel";
import { startClock, step, goTo, countFrames, togglePlaying } from "./play";
import { openAtFailure } from "./settings";
import { failure, field, shown, startLoading } from "./shown";
import { Stage } from "./stage";
import { Toolbar } from "./Toolbar";
import { startTracing } from "./tracedLines";
import { Transport } from "./Transport";
import "./viewer.css";
import { ZoomButtons } from "../drawing/buttons";
import { listenTo } from "./theme";

const help =
  "Space plays, arrow keys step through the frames, plus and minus zoom, 0 fits, " +
  "Shift with an arrow key picks the next point in that direction, Escape drops it.";

/** Arrow keys as directions on the screen. */
const directions: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Acts on a key; returns false for a key that the viewer does not use. */
function actOnKey(event: KeyboardEvent, stage: Stage): boolean {
  if (event.ctrlKey || event.altKey || event.metaKey) return false;
  const direction = directions[event.key];
  if (direction && event.shiftKey) pickNext(stage, ...direction);
  else if (direction) step(direction[0] || -direction[1]);
  else if (event.key === " ") togglePlaying();
  else if (event.key === "Enter") pickNext(stage, 0, 0);
  else if (event.key === "Escape" && pickedPoint.value !== null) pickedPoint.value = null;
  else if (event.key === "Home" || event.key === "End") goTo(event.key === "Home" ? 0 : countFrames() - 1);
  else if (event.key === "+" || event.key === "=") zoom(stage, 1.25);
  else if (event.key === "-") zoom(stage, 0.8);
  else if (event.key === "0") stage.fit();
  else return false;
  return true;
}

function zoom(stage: Stage, factor: number): void {
  stage.camera.zoom(factor);
  stage.moved();
}

/** Keeps the picked point by its number when another sequence, with other points, is shown. */
function keepPicked(stage: Stage): () => void {
  let last: { ids: ArrayLike<number>; id: number | null } | null = null;
  return effect(() => {
    const now = shown.value;
    if (!now) return;
    if (last && last.ids !== now.ids && last.id !== null) {
      pickedPoint.value = stage.findIndex(last.id) ?? null;
    }
    const index = pickedPoint.value;
    last = { ids: now.ids, id: index === null ? null : (now.ids[index] ?? null) };
  });
}

/** A press outside, or Escape, closes the menus of the toolbar. */
function closeMenus(): () => void {
  const close = (event: Event) => {
    if (event instanceof KeyboardEvent && event.key !== "Escape") return;
    for (const menu of document.querySelectorAll<HTMLDetailsElement>(".viewer-menu[open]")) {
      if (event instanceof KeyboardEvent || !menu.contains(event.target as Node)) menu.open = false;
    }
  };
  return listenTo(document, { pointerdown: close, keydown: close });
}

/** Describes the picture for screen readers. */
function describe(): string {
  const frames = sequence.value?.frames ?? [];
  const label = frames[Math.min(frameIndex.value, frames.length - 1)]?.label ?? "";
  const what = report.value.model.dimension === 3 ? "Model" : "Section";
  return `${what} coloured by ${field.value?.title.toLowerCase()}, ${sequence.value?.title}, ${label}. ${help}`;
}

export function Viewer() {
  const host = useRef<HTMLDivElement>(null);
  const [stage, setStage] = useState<Stage | null>(null);
  useState(openAtFailure);
  const empty = report.value.sequences.length === 0;

  useEffect(() => {
    if (!host.current) return;
    const made = new Stage(host.current);
    const ends = [
      startLoading(),
      startTracing(),
      startArrows(),
      startMesh(),
      startClock(),
      listenToPointer(host.current, made),
      keepPicked(made),
      closeMenus(),
      () => made.dispose(),
    ];
    setStage(made);
    return () => ends.forEach((end) => end());
  }, []);

  if (empty) return <p class="viewer-empty">This report holds no frames to show.</p>;
  const save = () => stage?.save(`${sequence.value?.id}_${field.value?.name}_${frameIndex.value + 1}.png`);
  return (
    <div class="viewer">
      <Toolbar stage={stage} save={save} />
      <div class="viewer-frame-box">
        <div
          ref={host}
          class="viewer-stage"
          tabIndex={0}
          role="application"
          aria-roledescription="section viewer"
          aria-label={describe()}
          onKeyDown={(event) => {
            if (stage && event.target === event.currentTarget && actOnKey(event, stage)) event.preventDefault();
          }}
        />
        <div class="viewer-zoom">
          <ZoomButtons
            class="viewer-icon"
            zoom={(factor) => stage && zoom(stage, factor)}
            fit={() => stage?.fit()}
          />
        </div>
        {failure.value && <p class="viewer-failure">The arrays of this frame cannot be read: {failure.value}</p>}
      </div>
      <Transport />
      <Legend />
      <PickPanel stage={stage} />
      <p class="viewer-note viewer-touch">Two fingers zoom and move. After Fit, one finger scrolls the page again.</p>
      {sequence.value?.thinning && <p class="viewer-note">{sequence.value.thinning}</p>}
    </div>
  );
}
