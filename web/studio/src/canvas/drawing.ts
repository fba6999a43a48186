// SPDX-License-Identifier: MIT
/** Tools that draw: which points they take, and what they do with them. */
import { effect, signal } from "@preact/signals";

import { addChain, addNail, addRegion, addSurcharge, listRegionNames, makeName, setWaterTable, splitRegions } from "../document/operations";
import { insertVertex } from "../document/vertices";
import { type Point } from "../geometry/plane";
import * as state from "../state";

interface ToolText {
  title: string;
  key: string;
  /** Points after which it is finished; Infinity: by Enter or a double click. */
  points: number;
  hint: string;
  /** Path of an icon of 16 by 16. */
  icon: string;
}

export const tools: Record<state.Tool, ToolText> = {
  select: {
    title: "Select and move",
    key: "v",
    points: 0,
    hint: "Drag a vertex or a side. Shift: the whole line. Alt: without snapping.",
    icon: "M3.5 2l9 5.5-4 .8 2 4-1.6.8-2-4.1-3 2.8z",
  },
  region: {
    title: "Draw a region",
    key: "r",
    points: Infinity,
    hint: "Click corners, or type x,y, @dx,dy or length<angle. Enter, or a click on the first corner, closes it.",
    icon: "M2 13V9l4-1 3-5h5v10zM2 13h12",
  },
  split: {
    title: "Split by a line",
    key: "s",
    points: Infinity,
    hint: "Draw a line from side to side of a region; Enter splits it.",
    icon: "M2.5 3.5h11v9h-11zM1 10c4 0 6-5 14-5",
  },
  insert: {
    title: "Insert a vertex",
    key: "i",
    points: 1,
    hint: "Click on a side.",
    icon: "M2 12L14 4M8 1v5M5.5 3.5h5M6.5 9a1.6 1.6 0 103-1 1.6 1.6 0 10-3 1",
  },
  water: {
    title: "Water table",
    key: "w",
    points: Infinity,
    hint: "Click points from left to right; Enter finishes. It is level beyond its ends.",
    icon: "M1.5 9c4 0 5 3 13 3M5 3h6L8 7.5z",
  },
  load: {
    title: "Surcharge",
    key: "l",
    points: 2,
    hint: "Click where it begins and where it ends along x; its value is in the form.",
    icon: "M2 13h12M2.5 3h11M4 3v8M2.5 9L4 11l1.5-2M12 3v8M10.5 9l1.500 2 1.500-2M8 3v8M6.500 9L8 11l1.500-2",
  },
  nail: {
    title: "Nail",
    key: "n",
    points: 2,
    hint: "Click its head on the ground, then its tip. Strengths and spacing are in the form.",
    icon: "M4 3l2 4 8 4M3 7.500l3.500-1",
  },
  line: {
    title: "Named line",
    key: "g",
    points: Infinity,
    hint: "Click points; Enter finishes. Boundary conditions and tractions refer to it by its name.",
    icon: "M2 12l4-6 4 3 4-6",
  },
  surface: {
    title: "Slip surface of your own",
    key: "u",
    points: Infinity,
    hint: "Click points from ground to ground; Enter finishes.",
    icon: "M2 3c1 7 6 9 12 9M2 3h3M11 12h3",
  },
  measure: {
    title: "Measure",
    key: "m",
    points: 2,
    hint: "Click two points: distance, differences and inclination are in the bar below.",
    icon: "M1.500 11.500l10-10 3 3-10 10zM5 8l1.500 1.500M7.500 5.500L9 7M10 3l1.500 1.500",
  },
};

/** What was measured last, as a sentence. */
export const measured = signal("");

export function selectTool(tool: state.Tool): void {
  state.tool.value = tool;
  state.draft.value = [];
  measured.value = "";
  state.notice.value = null;
}

export const lastPoint = (): Point | null => state.draft.value.at(-1) ?? null;

/** Adds a point to what is being drawn; a tool with enough points finishes. */
export function addPoint(at: Point): void {
  const { points } = tools[state.tool.value];
  if (points === 0) return;
  const last = lastPoint();
  if (last && last[0] === at[0] && last[1] === at[1]) return;
  state.draft.value = [...state.draft.value, at];
  if (state.draft.value.length >= points) finishDraft();
}

export function dropPoint(): void {
  state.draft.value = state.draft.value.slice(0, -1);
}

/** Soil of a new region: that of the selected one, else the first, else a new name that the form then describes. */
function selectSoil(): string {
  const chain = state.selectedChain.value;
  return chain?.soil ?? state.soils.value[0] ?? "soil";
}

function finishRegion(points: Point[]): void {
  const soil = selectSoil();
  let name = "";
  const done = state.attempt("Draw a region", () => {
    const wanted = makeName(state.chains.value.some(({ kind }) => kind === "region") ? "region" : "ground", listRegionNames(state.tree.value));
    const made = addRegion(state.tree.value, points, wanted, soil);
    name = made.name;
    return made.text;
  });
  const made = state.chains.value.find((chain) => chain.kind === "region" && chain.name === name);
  if (done && made) state.selection.value = { kind: "chain", id: made.id };
}

function finishMeasure([a, b]: Point[]): void {
  if (!a || !b) return;
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const angle = (Math.atan2(Math.abs(dy), Math.abs(dx)) * 180) / Math.PI;
  const ratio = dy !== 0 ? `, 1:${Math.abs(dx / dy).toFixed(2)}` : "";
  measured.value = `Length ${Math.hypot(dx, dy).toFixed(3)} m, Δx ${dx.toFixed(3)}, Δy ${dy.toFixed(3)}, ${angle.toFixed(1)}°${ratio}`;
}

const finishers: Partial<Record<state.Tool, { least: number; finish: (points: Point[]) => void }>> = {
  region: { least: 3, finish: finishRegion },
  split: {
    least: 2,
    finish: (line) => {
      const chain = state.selectedChain.value;
      const only = chain?.kind === "region" ? chain.name : null;
      state.attempt("Split by a line", () => splitRegions(state.tree.value, line, only).text);
    },
  },
  water: {
    least: 1,
    finish: (line) => {
      if (state.attempt("Draw the water table", () => setWaterTable(state.tree.value, line)))
        state.selection.value = { kind: "chain", id: "initial.water_table" };
    },
  },
  load: {
    least: 2,
    finish: ([a, b]) => {
      if (state.attempt("Add a surcharge", () => addSurcharge(state.tree.value, a![0], b![0], 10)))
        state.selection.value = { kind: "load", index: state.loads.value.length - 1 };
    },
  },
  nail: {
    least: 2,
    finish: ([head, tip]) => {
      let name = "";
      const done = state.attempt("Add a nail", () => {
        const made = addNail(state.tree.value, head!, tip!);
        name = made.name;
        return made.text;
      });
      if (done) state.selection.value = { kind: "chain", id: `support.${name}.first` };
    },
  },
  line: { least: 2, finish: (line) => void state.attempt("Draw a line", () => addChain(state.tree.value, "line", line)) },
  surface: { least: 2, finish: (line) => void state.attempt("Draw a slip surface", () => addChain(state.tree.value, "surface", line)) },
  measure: { least: 2, finish: finishMeasure },
};

/** Finishes what is being drawn, if it has enough points. */
export function finishDraft(): boolean {
  const found = finishers[state.tool.value];
  const points = state.draft.value;
  if (!found || points.length < found.least) {
    if (found && points.length > 0) state.notice.value = { text: `At least ${found.least} points are needed.`, bad: true };
    return false;
  }
  state.draft.value = [];
  found.finish(points);
  if (state.tool.value !== "measure" && !state.notice.value?.bad) state.tool.value = "select";
  return true;
}

/** A vertex in the sides that pass through a place. */
export function insertAt(at: Point, chainId: string): void {
  const only = state.chains.value.findIndex(({ id }) => id === chainId);
  if (only < 0) return;
  if (state.attempt("Insert a vertex", () => insertVertex(state.tree.value, state.chains.value, at, only)))
    state.selection.value = { kind: "vertex", at };
}

/** A selection whose chain is gone ends. */
export function watchSelection(): void {
  effect(() => {
    const now = state.selection.value;
    if (now.kind === "chain" && !state.chains.value.some(({ id }) => id === now.id)) state.selection.value = { kind: "none" };
    if (now.kind === "load" && now.index >= state.loads.value.length) state.selection.value = { kind: "none" };
    if (now.kind === "vertex" && !state.selectedVertex.value && !state.fault.value) state.selection.value = { kind: "none" };
  });
}
