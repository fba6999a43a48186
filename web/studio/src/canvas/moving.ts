// SPDX-License-Identifier: MIT
/** Moves of the selection: by dragging, by keys, by typed coordinates. Each is one step of the history. */
import { batch } from "@preact/signals";

import { applyEdits, removeAt, setValue, writeNumber } from "../document/edits";
import { deleteRegion } from "../document/operations";
import { applyInTurn, deleteVertex, listVertices, moveVertices, prepareMove, type Vertex } from "../document/vertices";
import type { Point } from "../geometry/plane";
import * as state from "../state";
import type { Hit } from "./hit";

/** A drag from its first place; every move is an edit of the text as it was then. */
export interface Drag {
  name: string;
  /** What is under the pointer at the start [m]. */
  from: Point;
  /** Moves it to a place; the same step of the history each time. */
  to: (at: Point) => void;
}

let counter = 0;

function dragVertices(name: string, from: Point, moved: Vertex[], follow: boolean): Drag {
  const group = `drag ${++counter}`;
  const move = prepareMove(state.tree.value, state.chains.value, moved, state.vertices.value);
  const single = moved.length === 1;
  return {
    name,
    from,
    to(at) {
      const [dx, dy] = [at[0] - from[0], at[1] - from[1]];
      const targets = moved.map((vertex): Point => (single ? at : [vertex.at[0] + dx, vertex.at[1] + dy]));
      const { text, chains, vertices } = move(targets);
      batch(() => {
        state.live.value = { chains, vertices };
        state.change(name, text, group);
        if (follow) state.selection.value = { kind: "vertex", at };
      });
    },
  };
}

/** Ends a drag: the text is read anew. */
export function endDrag(): void {
  state.live.value = null;
  state.sealChange();
}

function dragLoad(index: number, end: number): Drag {
  const tree = state.tree.value;
  const load = state.loads.value[index]!;
  const group = `drag ${++counter}`;
  return {
    name: "Move a surcharge",
    from: [load.x[end]!.value, 0],
    to([x]) {
      const sorted = load.x.map(({ value }, i) => (i === end ? x : value));
      if (sorted.some((value, i) => i > 0 && value <= sorted[i - 1]!)) return;
      state.attempt("Move a surcharge", () => applyEdits(tree.text, setValue(tree, [...load.path, "x", end], writeNumber(x))), group);
    },
  };
}

/** The drag of what was hit; null for what does not move. */
export function startDrag(hit: Hit, whole: boolean): Drag | null {
  if (state.fault.value) return null;
  if (hit.kind === "vertex") {
    const vertex = state.vertices.value.find(({ at }) => at === hit.at);
    return vertex ? dragVertices("Move a vertex", hit.at, [vertex], true) : null;
  }
  if (hit.kind === "load") return dragLoad(hit.index, hit.end);
  if (hit.kind !== "side") return null;
  const c = state.chains.value.findIndex(({ id }) => id === hit.chain);
  const count = state.chains.value[c]!.points.length;
  const ends = [hit.index, (hit.index + 1) % count];
  const moved = state.vertices.value.filter(({ corners }) =>
    corners.some(({ chain, index }) => chain === c && (whole || ends.includes(index))),
  );
  return dragVertices(whole ? "Move a line" : "Move a side", hit.at, moved, false);
}

/** Moves the selected vertex to a place. */
export function moveSelectedTo(at: Point, group: string | null = null): void {
  const vertex = state.selectedVertex.value;
  if (!vertex) return;
  const done = state.attempt("Move a vertex", () => moveVertices(state.tree.value, state.chains.value, [{ vertex, to: at }], state.vertices.value), group);
  if (done) state.selection.value = { kind: "vertex", at };
}

/** Moves the selected vertex, or all vertices of the selected line or region. */
export function moveSelectedBy(dx: number, dy: number): void {
  const vertex = state.selectedVertex.value;
  const chain = state.selectedChain.value;
  const round = (value: number) => Number(value.toFixed(9));
  if (vertex) return moveSelectedTo([round(vertex.at[0] + dx), round(vertex.at[1] + dy)], `key ${vertex.corners[0]!.chain}`);
  if (!chain) return;
  const c = state.chains.value.indexOf(chain);
  const moves = listVertices(state.chains.value)
    .filter(({ corners }) => corners.some((corner) => corner.chain === c))
    .map((moved) => ({ vertex: moved, to: [round(moved.at[0] + dx), round(moved.at[1] + dy)] as const }));
  state.attempt(`Move ${chain.name}`, () => moveVertices(state.tree.value, state.chains.value, moves), `key ${chain.id}`);
}

/** Deletes what is selected. */
export function deleteSelected(): void {
  const vertex = state.selectedVertex.value;
  const chain = state.selectedChain.value;
  const now = state.selection.value;
  if (vertex) return void state.attempt("Delete a vertex", () => deleteVertex(state.tree.value, state.chains.value, vertex));
  if (now.kind === "load") {
    const path = state.loads.value[now.index]!.path;
    state.attempt("Delete a surcharge", () => applyEdits(state.tree.value.text, removeAt(state.tree.value, path)));
    return;
  }
  if (!chain) return;
  state.attempt(`Delete ${chain.name}`, () => {
    if (chain.kind === "region") return deleteRegion(state.tree.value, chain.name);
    if (chain.kind === "water")
      return applyInTurn(state.tree.value.text, [
        (tree) => removeAt(tree, chain.path),
        (tree) => removeAt(tree, ["initial", "pore_pressure"]),
      ]);
    const own = ["ground", "box"].includes(chain.kind) ? chain.path : chain.owner;
    return applyEdits(state.tree.value.text, removeAt(state.tree.value, own));
  });
}
