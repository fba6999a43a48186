// SPDX-License-Identifier: MIT
/** Tools that draw: which points they take, and what they do with them. */
import { effect, signal } from "@preact/signals";

import { background, marks } from "../background/background";
import type { ChainKind } from "../document/chains";
import {
  addChain,
  addCircle,
  addHeave,
  addMonitor,
  addNail,
  addRegion,
  addSlurry,
  addSurcharge,
  addWindow,
  listRegionNames,
  makeName,
  setCentres,
  setGroundRange,
  setTangent,
  setWaterTable,
  splitRegions,
} from "../document/operations";
import { splitLineBy } from "../document/transform";
import type { CaseTree } from "../document/tree";
import { insertVertex } from "../document/vertices";
import { type Point } from "../geometry/plane";
import { openTab } from "../panels/tabs";
import * as state from "../state";
import { toShownLength, writeLengthShown } from "../units";
import { tools } from "./tools";

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

/** Two points of the picture are marked; the form then asks for their coordinates. */
function finishPicture(a: Point, b: Point): void {
  if (!background.value) {
    state.notice.value = { text: "There is no background picture: drop one on the page.", bad: true };
    return;
  }
  marks.value = [a, b];
  state.selection.value = { kind: "none" };
  openTab("selection");
  setTimeout(() => document.getElementById("picture-point-1")?.focus());
}

/** Does an edit and selects what it has added: a line, a rectangle, or another part. */
function drawPart(name: string, edit: (tree: CaseTree) => string): void {
  const before = new Set([...state.chains.value, ...state.parts.value].map(({ id }) => id));
  if (!state.attempt(name, () => edit(state.tree.value))) return;
  const part = state.parts.value.find(({ id }) => !before.has(id));
  const chain = state.chains.value.find(({ id }) => !before.has(id));
  if (part) state.selection.value = { kind: "part", id: part.id };
  else if (chain) state.selectChain(chain.id);
}

const drawChain = (name: string, kind: ChainKind, line: readonly Point[]): void => drawPart(name, (tree) => addChain(tree, kind, line));

function finishMeasure([a, b]: Point[]): void {
  if (!a || !b) return;
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const angle = (Math.atan2(Math.abs(dy), Math.abs(dx)) * 180) / Math.PI;
  const ratio = dy !== 0 ? `, 1:${Math.abs(dx / dy).toFixed(2)}` : "";
  const [lx, ly] = [dx, dy].map((value) => toShownLength(value).toFixed(3));
  measured.value = `Length ${writeLengthShown(Math.hypot(dx, dy), 3)}, Δx ${lx}, Δy ${ly}, ${angle.toFixed(1)}°${ratio}`;
}

const finishers: Partial<Record<state.Tool, { least: number; finish: (points: Point[]) => void }>> = {
  region: { least: 3, finish: finishRegion },
  split: {
    least: 2,
    finish: (line) => {
      const chain = state.selectedChain.value;
      const only = chain?.kind === "region" ? chain.name : null;
      if (chain && ["line", "section", "through"].includes(chain.kind)) {
        state.attempt(`Split ${chain.name}`, () => splitLineBy(state.tree.value, chain, line));
        return;
      }
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
  line: { least: 2, finish: (line) => drawChain("Draw a line", "line", line) },
  surface: { least: 2, finish: (line) => drawChain("Draw a slip surface", "surface", line) },
  through: { least: 2, finish: (line) => drawChain("Draw a line that surfaces cross", "through", line) },
  exclude: { least: 3, finish: (line) => drawChain("Draw an excluded area", "exclude", line) },
  section: { least: 2, finish: (line) => drawChain("Draw a line of discharge", "section", line) },
  circle: { least: 2, finish: ([a, b]) => drawPart("Draw a slip circle", (tree) => addCircle(tree, a!, b!)) },
  entry: { least: 2, finish: ([a, b]) => drawPart("Set the entry range", (tree) => setGroundRange(tree, "entry", a![0], b![0])) },
  exit: { least: 2, finish: ([a, b]) => drawPart("Set the exit range", (tree) => setGroundRange(tree, "exit", a![0], b![0])) },
  tangent: { least: 2, finish: ([a, b]) => drawPart("Set the tangent levels", (tree) => setTangent(tree, a![1], b![1])) },
  heave: { least: 2, finish: ([a, b]) => drawPart("Draw a block of heave", (tree) => addHeave(tree, a!, b!)) },
  slurry: { least: 2, finish: ([a, b]) => drawPart("Draw a slurry", (tree) => addSlurry(tree, a!, b!)) },
  window: { least: 2, finish: ([a, b]) => drawPart("Draw a window", (tree) => addWindow(tree, a!, b!)) },
  centres: { least: 2, finish: ([a, b]) => drawPart("Draw the grid of centres", (tree) => setCentres(tree, a!, b!)) },
  monitor: { least: 1, finish: ([a]) => drawPart("Add a monitor", (tree) => addMonitor(tree, a!)) },
  measure: { least: 2, finish: finishMeasure },
  picture: { least: 2, finish: ([a, b]) => finishPicture(a!, b!) },
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
    if (now.kind === "part" && !state.selectedPart.value && !state.fault.value) state.selection.value = { kind: "none" };
    if (now.kind === "chain" && !state.chains.value.some(({ id }) => id === now.id)) state.selection.value = { kind: "none" };
    if (now.kind === "load" && now.index >= state.loads.value.length) state.selection.value = { kind: "none" };
    if (now.kind === "vertex" && !state.selectedVertex.value && !state.fault.value) state.selection.value = { kind: "none" };
  });
}
