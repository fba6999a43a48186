// SPDX-License-Identifier: MIT
/** State of the page: the text with its history, what it describes, the selection, and the answers of the engine. */
import { batch, computed, signal } from "@preact/signals";

import { type Chain, listChains, listLoads, listSoils } from "./document/chains";
import { EditFault } from "./document/edits";
import { listParts } from "./document/parts";
import { emptyCase } from "./document/operations";
import { type CaseTree, findNode, readTree, toPlain } from "./document/tree";
import { listVertices, pointsOf, segmentsOf, type Vertex } from "./document/vertices";
import type { Message, Section, Solved } from "./engine/engine";
import type { SnapTargets } from "./geometry/snap";
import { type Point, type Segment } from "./geometry/plane";
import { History } from "./history/history";
import { length, system } from "./units";

let history = new History(emptyCase);

/** The text, the truth of everything below. */
export const text = signal(history.text);
export const undoNames = signal<string[]>([]);
export const redoNames = signal<string[]>([]);

/** Chains and vertices during a drag, without reading the text anew for every place of the mouse; null otherwise. */
export const live = signal<{ chains: Chain[]; vertices: Vertex[] } | null>(null);

let lastRead = readTree(emptyCase);
const lastTree: { tree: CaseTree } = { tree: lastRead.tree! };
const read = computed(() => {
  if (live.value) return lastRead;
  lastRead = readTree(text.value);
  if (lastRead.tree) lastTree.tree = lastRead.tree;
  return lastRead;
});
/** The last text that could be read; of the present one where `fault` is null. */
export const tree = computed<CaseTree>(() => read.value.tree ?? lastTree.tree);
export const fault = computed(() => read.value.fault);

export const chains = computed<Chain[]>(() => live.value?.chains ?? listChains(tree.value));
export const vertices = computed<readonly Vertex[]>(() => live.value?.vertices ?? listVertices(chains.value));
export const loads = computed(() => listLoads(tree.value));
export const soils = computed(() => listSoils(tree.value));
export const title = computed(() => String(toPlain(findNode(tree.value, ["title"])) ?? ""));

/** Answers of the engine, of a text that may be a moment older. */
export const section = signal<Section | null>(null);
/** Messages of the checker, and those of the methods, which follow later and are of one text. */
export const textMessages = signal<Message[]>([]);
export const methodMessages = signal<{ text: string; messages: Message[] }>({ text: "", messages: [] });
export const messages = computed<Message[]>(() => {
  const later = methodMessages.value.text === text.value ? methodMessages.value.messages : [];
  const known = new Set(textMessages.value.map((message) => message.text));
  return [...textMessages.value, ...later.filter((message) => !known.has(message.text))];
});
export const isReady = signal(false);
export const solved = signal<Solved | null>(null);
export const solveFault = signal("");
export const isSolving = signal(false);
/** Milliseconds of the last quick search, and updates in the last second of a drag. */
export const solveTime = signal(0);

export type Tool =
  | "select" | "region" | "split" | "insert" | "water" | "load" | "nail" | "line" | "surface" | "measure"
  | "circle" | "entry" | "exit" | "window" | "through" | "exclude" | "centres" | "tangent" | "monitor" | "section" | "heave" | "slurry" | "picture";
export const tool = signal<Tool>("select");
/** Points of what is being drawn. */
export const draft = signal<Point[]>([]);

export type Selection =
  | { kind: "none" }
  | { kind: "vertex"; at: Point }
  | { kind: "chain"; id: string }
  | { kind: "load"; index: number }
  | { kind: "part"; id: string };
export const selection = signal<Selection>({ kind: "none" });
/** Lines and regions that are selected besides the one of `selection`. */
export const also = signal<readonly string[]>([]);

/** One sentence for the user: what went wrong, or what was done. */
export const notice = signal<{ text: string; bad: boolean } | null>(null);
/** Distance of the lines of the grid [m]; set by the zoom. */
export const gridStep = signal(1);
export const snapping = signal(true);

/** The selected line or region, then those that were added to it. */
export const selectedChains = computed<Chain[]>(() => {
  const first = selectedChain.value;
  return first ? [first, ...chains.value.filter(({ id }) => id !== first.id && also.value.includes(id))] : [];
});

export const selectedChain = computed(() => {
  const now = selection.value;
  return now.kind === "chain" ? (chains.value.find(({ id }) => id === now.id) ?? null) : null;
});

/** The vertex at the selected place; the place is kept while texts change. */
export const selectedVertex = computed(() => {
  const now = selection.value;
  if (now.kind !== "vertex") return null;
  return vertices.value.find(({ at }) => Math.abs(at[0] - now.at[0]) < 1e-9 && Math.abs(at[1] - now.at[1]) < 1e-9) ?? null;
});

function publish(): void {
  batch(() => {
    text.value = history.text;
    undoNames.value = history.undoNames;
    redoNames.value = history.redoNames;
  });
}

/** Changes the text under a name; changes with one `group` that follow one another are one step. */
export function change(name: string, after: string, group: string | null = null): void {
  notice.value = null;
  if (history.change(name, after, group)) publish();
}

/** Does an edit; one that is refused changes nothing and shows its reason. */
export function attempt(name: string, edit: () => string, group: string | null = null): boolean {
  try {
    change(name, edit(), group);
    return true;
  } catch (error) {
    if (!(error instanceof EditFault)) throw error;
    notice.value = { text: error.message, bad: true };
    return false;
  }
}

export const sealChange = (): void => history.seal();

export function undo(): void {
  const step = history.undo();
  if (!step) return;
  live.value = null;
  publish();
  notice.value = { text: `Undone: ${step.name}`, bad: false };
}

export function redo(): void {
  const step = history.redo();
  if (!step) return;
  live.value = null;
  publish();
  notice.value = { text: `Redone: ${step.name}`, bad: false };
}

/** Counts texts that were opened: the canvas then shows all of the section. */
export const opened = signal(0);

/** Opens another text: its history is empty. */
export function openText(found: string): void {
  history = new History(found);
  batch(() => {
    live.value = null;
    selection.value = { kind: "none" };
    draft.value = [];
    tool.value = "select";
    solved.value = null;
    section.value = null;
    textMessages.value = [];
    notice.value = null;
    publish();
    ++opened.value;
  });
  followUnits();
}

/** Regions: those of the text, or those that the engine builds from layers. */
export const regions = computed<{ id: string; name: string; soil: string; points: Point[] }[]>(() => {
  const own = chains.value.filter(({ kind }) => kind === "region");
  if (own.length) return own.map((chain) => ({ id: chain.id, name: chain.name, soil: chain.soil ?? "", points: pointsOf(chain) }));
  return (section.value?.regions ?? []).map(({ name, soil, polygon }, i) => ({ id: `section.${i}`, name, soil, points: polygon }));
});

/** Conditions, ranges of the search and the like. */
export const parts = computed(() => {
  const built = regions.value.filter(({ id }) => id.startsWith("section.")).map(({ points }) => points);
  return listParts(tree.value, chains.value, built);
});
export const selectedPart = computed(() => {
  const now = selection.value;
  return now.kind === "part" ? (parts.value.find(({ id }) => id === now.id) ?? null) : null;
});

/** Selects a line or region; with `more` it is added to the selected ones, or taken away from them. */
export function selectChain(id: string, more = false): void {
  const now = selection.value;
  if (!more || now.kind !== "chain") {
    also.value = [];
    selection.value = { kind: "chain", id };
  } else if (now.id !== id) also.value = also.value.includes(id) ? also.value.filter((other) => other !== id) : [...also.value, id];
}

/** Vertices and lines to snap to, without those at a place that is being dragged. */
export function listTargets(without: Point | null): SnapTargets {
  const isDragged = (p: Point) => without !== null && p[0] === without[0] && p[1] === without[1];
  const segments: Segment[] = chains.value.flatMap(segmentsOf).filter(([a, b]) => !isDragged(a) && !isDragged(b));
  return {
    vertices: vertices.value.map(({ at }) => at).filter((at) => !isDragged(at)),
    segments,
    grid: gridStep.value,
    unit: length.value.size,
  };
}

/** Units of display follow those of the report where a case is opened. */
export function followUnits(): void {
  const unit = toPlain(findNode(tree.value, ["output", "length_unit"]));
  system.value = unit === "ft" || unit === "in" || unit === "yd" ? "us" : "si";
}
