// SPDX-License-Identifier: MIT
/** Keys on the canvas: tools, vertices, moves, zoom, typed coordinates. Everything that the mouse does is done by keys as well. */
import type { Point } from "../geometry/plane";
import * as state from "../state";
import { panBy, zoomBy } from "./camera";
import { dropPoint, finishDraft, selectTool } from "./drawing";
import { fitAll } from "./hit";
import { deleteSelected, moveSelectedBy } from "./moving";
import { tools } from "./tools";

/** The field for typed coordinates takes the focus with their first character, at once, so that the next is not lost. */
function startTyping(first: string): void {
  const field = document.querySelector<HTMLInputElement>("#typed-coordinates");
  if (!field || field.disabled) return;
  field.value = first;
  field.focus();
}

const arrows: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Selects the next vertex from left to right. */
function selectVertex(step: number): void {
  const all = state.vertices.value
    .filter(({ corners }) => corners.some(({ chain }) => state.chains.value[chain]!.kind !== "box"))
    .toSorted((a, b) => a.at[0] - b.at[0] || a.at[1] - b.at[1]);
  if (!all.length) return;
  const now = state.selectedVertex.value ? all.indexOf(state.selectedVertex.value) : -1;
  const next = now < 0 ? (step > 0 ? 0 : all.length - 1) : (now + step + all.length) % all.length;
  state.selection.value = { kind: "vertex", at: all[next]!.at };
}

function pressArrow([x, y]: Point, event: KeyboardEvent): void {
  if (state.selection.value.kind === "none") return panBy(-40 * x, 40 * y);
  const step = state.gridStep.value * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
  moveSelectedBy(x * step, y * step);
}

const acts: Record<string, () => void> = {
  ",": () => selectVertex(-1),
  ".": () => selectVertex(1),
  "+": () => zoomBy(1.25),
  "=": () => zoomBy(1.25),
  "-": () => (state.tool.value === "select" ? zoomBy(0.8) : startTyping("-")),
  "0": () => (state.tool.value === "select" ? fitAll() : startTyping("0")),
  Delete: deleteSelected,
  Backspace: () => (state.draft.value.length ? dropPoint() : deleteSelected()),
  Enter: () => {
    if (state.draft.value.length) finishDraft();
    else if (state.selectedVertex.value) startTyping("");
  },
  Escape: () => {
    if (state.draft.value.length) state.draft.value = [];
    else if (state.tool.value !== "select") selectTool("select");
    else state.selection.value = { kind: "none" };
  },
};

export function pressKey(event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey) return;
  const arrow = arrows[event.key];
  const named = (Object.keys(tools) as state.Tool[]).find((tool) => tools[tool].key === event.key);
  if (arrow) pressArrow(arrow, event);
  else if (acts[event.key]) acts[event.key]!();
  else if (/^[\d@]$/.test(event.key) && (state.tool.value !== "select" || state.selectedVertex.value)) startTyping(event.key);
  else if (named && !event.altKey) selectTool(named);
  else return;
  event.preventDefault();
}
