// SPDX-License-Identifier: MIT
/** Moves of the selection: by dragging, by keys, by typed coordinates. Each is one step of the history. */
import { batch } from "@preact/signals";

import { applyEdits, removeAt, setValue, writeNumber } from "../document/edits";
import { type CaseTree, readTree } from "../document/tree";
import { deleteRegion } from "../document/operations";
import type { Chain, LengthAt } from "../document/chains";
import type { Part } from "../document/parts";
import { mapChains, shiftBy } from "../document/transform";
import { applyInTurn, deleteVertex, moveVertices, prepareMove, type Vertex, writeLength } from "../document/vertices";
import type { Point } from "../geometry/plane";
import * as state from "../state";
import type { Grip, Hit } from "./hit";

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

const setLength = (text: string, at: LengthAt, value: number) => applyEdits(text, writeLength(at, value));

/** Keeps a range from left to right. */
const isBetween = (value: number, all: readonly LengthAt[], index: number) =>
  all.every((other, i) => i === index || (i < index ? value > other.value : value < other.value));

function dragPart(part: Part, grip: Grip): Drag {
  const { text } = state.tree.value;
  const name = `Move ${part.title.toLowerCase()}`;
  const group = `drag ${++counter}`;
  const from: Point = grip.of === "x" ? [part.x[grip.index]!.value, 0] : grip.of === "level" ? [0, part.levels[grip.index]!.value] : [0, 0];
  return {
    name,
    from,
    to([x, y]) {
      const change = () => {
        if (grip.of === "x") return isBetween(x, part.x, grip.index) ? setLength(text, part.x[grip.index]!, x) : state.tree.value.text;
        if (grip.of === "level") return isBetween(y, part.levels, grip.index) ? setLength(text, part.levels[grip.index]!, y) : state.tree.value.text;
        const { centre, radius } = part.circle!;
        return setLength(text, radius, Number(Math.max(1e-3, Math.hypot(x - centre[0], y - centre[1])).toFixed(3)));
      };
      state.attempt(name, change, group);
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
  if (hit.kind === "part") {
    const part = state.parts.value.find(({ id }) => id === hit.id);
    return part && hit.grip ? dragPart(part, hit.grip) : null;
  }
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
  const shapes = state.selectedChains.value;
  const part = state.selectedPart.value;
  const round = (value: number) => Number(value.toFixed(9));
  if (vertex) return moveSelectedTo([round(vertex.at[0] + dx), round(vertex.at[1] + dy)], `key ${vertex.corners[0]!.chain}`);
  if (part) return movePartBy(part, dx, dy);
  const now = state.selection.value;
  if (now.kind === "load") {
    const load = state.loads.value[now.index]!;
    const edits = load.x.flatMap((at) => writeLength(at, round(at.value + dx)));
    return void state.attempt("Move a surcharge", () => applyEdits(state.tree.value.text, edits), `key load ${now.index}`);
  }
  if (!shapes.length) return;
  const name = shapes.length > 1 ? `Move ${shapes.length} shapes` : `Move ${shapes[0]!.name}`;
  state.attempt(name, () => mapChains(state.tree.value, state.chains.value, shapes, shiftBy(dx, dy)), `key ${shapes[0]!.id}`);
}

function movePartBy(part: Part, dx: number, dy: number): void {
  const round = (value: number) => Number(value.toFixed(9));
  const edits = [...part.x.flatMap((at) => writeLength(at, round(at.value + dx))), ...part.levels.flatMap((at) => writeLength(at, round(at.value + dy)))];
  if (edits.length) state.attempt(`Move ${part.title.toLowerCase()}`, () => applyEdits(state.tree.value.text, edits), `key ${part.id}`);
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
  const part = state.selectedPart.value;
  if (part) {
    const path = part.key === null ? part.path : [...part.path, part.key];
    return void state.attempt(`Delete ${part.title.toLowerCase()}`, () => applyEdits(state.tree.value.text, removeAt(state.tree.value, path)));
  }
  if (!chain) return;
  const others = state.also.value;
  if (others.length) {
    // From the last entry of a list to the first, so that the paths of the others hold.
    const names = state.selectedChains.value.toSorted((a, b) => Number(b.owner.at(-1)) - Number(a.owner.at(-1)) || 0);
    state.attempt(`Delete ${names.length} shapes`, () => names.reduce((text, one) => deleteChain(readTree(text).tree!, one), state.tree.value.text));
    return;
  }
  state.attempt(`Delete ${chain.name}`, () => deleteChain(state.tree.value, chain));
}

function deleteChain(tree: CaseTree, chain: Chain): string {
  if (chain.kind === "region") return deleteRegion(tree, chain.name);
  if (chain.kind === "water")
    return applyInTurn(tree.text, [
      (now) => removeAt(now, chain.path),
      (now) => removeAt(now, ["initial", "pore_pressure"]),
    ]);
  const own = ["ground", "box", "centres"].includes(chain.kind) ? chain.path : chain.owner;
  return applyEdits(tree.text, removeAt(tree, own));
}
