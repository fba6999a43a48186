// SPDX-License-Identifier: MIT
/** The line at the bottom: what to do, where the pointer is and what it snaps to, and the field for typed coordinates. */
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";

import { addPoint, finishDraft, insertAt, lastPoint, measured } from "../canvas/drawing";
import { findHit } from "../canvas/hit";
import { moveSelectedTo } from "../canvas/moving";
import { pointer } from "../canvas/overlay";
import { tools } from "../canvas/tools";
import { readCoordinates } from "../geometry/coordinates";
import * as state from "../state";
import { length, stress, system } from "../units";

const kinds: Record<string, string> = { vertex: "vertex", intersection: "crossing", line: "line", aligned: "aligned", grid: "grid", free: "" };

function write(value: number): string {
  const { size } = length.value;
  return (value / size).toFixed(Math.min(3, Math.max(0, 2 - Math.floor(Math.log10(state.gridStep.value / size) + 0.5)))).replace("-", "−");
}

/** Why nothing can be typed now; empty where it can. */
function findUse(): "draw" | "move" | "" {
  if (state.tool.value !== "select") return "draw";
  return state.selectedVertex.value ? "move" : "";
}

function Coordinates() {
  const field = useRef<HTMLInputElement>(null);
  const fault = useSignal("");
  const use = findUse();

  const leave = () => {
    fault.value = "";
    field.current!.value = "";
    document.querySelector<SVGSVGElement>("svg.section")?.focus();
  };

  const accept = () => {
    const typed = field.current!.value.trim();
    if (typed === "") {
      // An empty line finishes, as in CAD.
      if (use !== "draw" || finishDraft()) leave();
      return;
    }
    const vertex = state.selectedVertex.value;
    const { point, fault: found } = readCoordinates(typed, use === "move" ? (vertex?.at ?? null) : lastPoint(), length.value.size);
    fault.value = found ?? "";
    if (!point) return;
    field.current!.value = "";
    if (use === "move") {
      moveSelectedTo(point);
      leave();
    } else if (state.tool.value === "insert") {
      const hit = findHit(point, 1e-6);
      if (hit.kind === "side") insertAt(point, hit.chain);
      else fault.value = "No side passes through this point.";
    } else {
      addPoint(point);
      if (state.tool.value === "select") leave();
    }
  };

  const press = (event: KeyboardEvent) => {
    if (event.key === "Enter") accept();
    else if (event.key === "Escape") leave();
    else return;
    event.preventDefault();
  };

  return (
    <span class="coordinates">
      <label for="typed-coordinates">{use === "move" ? "Move to" : "Point"}</label>
      <input
        id="typed-coordinates"
        ref={field}
        disabled={use === ""}
        placeholder="x,y  @dx,dy  length<angle"
        spellcheck={false}
        autocomplete="off"
        aria-describedby="coordinate-fault"
        aria-invalid={fault.value !== ""}
        onKeyDown={press}
      />
      <span id="coordinate-fault" class="bad" role="status">
        {fault.value}
      </span>
    </span>
  );
}

/** Switches the units of display; the text of the case keeps its own. */
function UnitButton() {
  const isAmerican = system.value === "us";
  const shown = `${length.value.name} · ${stress.value.name}`;
  const label = `${shown}: units of display. Switch to ${isAmerican ? "SI" : "feet and pounds"}`;
  return (
    <button type="button" class="units" aria-label={label} title={label} onClick={() => (system.value = isAmerican ? "si" : "us")}>
      {shown}
    </button>
  );
}

export function StatusBar() {
  const at = pointer.value;
  const { hint } = tools[state.tool.value];
  const notice = state.notice.value;
  const drawing = state.draft.value.length > 0;
  return (
    <div class="status-bar">
      <p class={notice?.bad ? "hint bad" : "hint"} role="status">
        {notice?.text || measured.value || hint}
      </p>
      {drawing && (
        <button type="button" onClick={() => finishDraft()}>
          Finish
        </button>
      )}
      <Coordinates />
      <UnitButton />
      <span class="pointer-place" aria-hidden="true">
        {at ? `${write(at.at[0])}, ${write(at.at[1])} ${length.value.name}` : ""}
        <span class="muted"> {at ? kinds[at.kind] : ""}</span>
      </span>
    </div>
  );
}
