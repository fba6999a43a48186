// SPDX-License-Identifier: MIT
/** Parts of a case that act on lines or lie along x: conditions, ranges of the search, blocks of heave, slurries, levels, circles. */
import type { Point } from "../geometry/plane";
import { type Chain, type LengthAt, readLength } from "./chains";
import { type CaseTree, findNode, type Node, type Path, toPlain, writePath } from "./tree";
import { pointsOf } from "./vertices";

export type PartKind = "boundary" | "traction" | "hydraulic" | "roots" | "entry" | "exit" | "slurry" | "heave" | "tangent" | "levels" | "circle";

export interface Part {
  id: string;
  kind: PartKind;
  /** Of the table that describes it. */
  path: Path;
  /** Key that is deleted with it; null for the whole table. */
  key: string | null;
  title: string;
  /** "full", "rain": what a condition does. */
  word: string;
  /** Name of the side or line; empty for none. */
  on: string;
  /** Of a traction, as far as it is written in numbers. */
  direction: Point | null;
  /** Along which a condition acts [m]. */
  line: Point[];
  /** From and to along x. */
  x: LengthAt[];
  /** Horizontal lines. */
  levels: LengthAt[];
  circle: { centre: Point; radius: LengthAt } | null;
}

export const titles: Record<PartKind, string> = {
  boundary: "Fixity",
  traction: "Traction",
  hydraulic: "Water condition",
  roots: "Roots",
  entry: "Entry range",
  exit: "Exit range",
  slurry: "Slurry",
  heave: "Block of heave",
  tangent: "Tangent levels",
  levels: "Deepest points of circles",
  circle: "Slip circle",
};

export const sideNames = ["left", "right", "bottom", "top"] as const;

/** The sides of the box, or without one of the rectangle around all regions, by their names. Without MPM they end where the soil does. */
export function listSides(tree: CaseTree, chains: readonly Chain[], built: readonly (readonly Point[])[]): Map<string, Point[]> {
  const box = chains.find(({ kind }) => kind === "box");
  const soil = [...chains.filter(({ kind }) => kind === "region").flatMap(pointsOf), ...built.flat()];
  const points = box ? pointsOf(box) : soil;
  if (points.length < 2) return new Map();
  const [xs, ys] = [points.map((p) => p[0]), points.map((p) => p[1])];
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const methods = toPlain(findNode(tree, ["analysis", "methods"]));
  const isMpm = !Array.isArray(methods) || methods.includes("mpm");
  const upright = (x: number): Point[] => {
    const levels = isMpm ? [] : soil.filter((p) => Math.abs(p[0] - x) <= 1e-9 * (x1 - x0)).map((p) => p[1]);
    const [low, high] = [Math.min(...levels), Math.max(...levels)];
    return high > low ? [[x, low], [x, high]] : [[x, y0], [x, y1]];
  };
  return new Map<string, Point[]>([
    ["left", upright(x0)],
    ["right", upright(x1)],
    ["bottom", [[x0, y0], [x1, y0]]],
    ["top", [[x0, y1], [x1, y1]]],
  ]);
}

const textAt = (tree: CaseTree, path: Path): string => {
  const value = toPlain(findNode(tree, path));
  return value === undefined ? "" : String(value);
};

function readLengths(node: Node | null): LengthAt[] {
  const items = node?.kind === "list" ? node.items : node ? [node] : [];
  const read = items.map(readLength);
  return read.every((value) => value !== null) ? read : [];
}

const empty = { word: "", on: "", direction: null, line: [], x: [], levels: [], circle: null, key: null };

function listConditions(tree: CaseTree, lines: ReadonlyMap<string, Point[]>): Part[] {
  const blocks = [
    ["boundary", "on", "fix"],
    ["traction", "on", "carrier"],
    ["hydraulic", "on", "condition"],
    ["roots", "ground", "profile"],
  ] as const;
  return blocks.flatMap(([kind, key, word]) => {
    const list = findNode(tree, [kind]);
    if (list?.kind !== "list") return [];
    return list.items.map((_, i): Part => {
      const path = [kind, i];
      const on = textAt(tree, [...path, key]);
      const load = toPlain(findNode(tree, [...path, "traction"]));
      const numbers = Array.isArray(load) ? load.map((value) => parseFloat(String(value))) : [];
      const direction: Point | null = numbers.length >= 2 && Number.isFinite(numbers[0]) && Number.isFinite(numbers[1]) ? [numbers[0]!, numbers[1]!] : null;
      return { ...empty, id: writePath(path), kind, path, on, word: textAt(tree, [...path, word]), direction, line: lines.get(on) ?? [], title: `${titles[kind]} on ${on || "no line"}` };
    });
  });
}

function listRanges(tree: CaseTree): Part[] {
  const parts: Part[] = [];
  const add = (kind: PartKind, path: Path, key: string | null, more: Partial<Part>, name = "") => {
    const part: Part = { ...empty, id: writePath(key === null ? path : [...path, key]), kind, path, key, title: name ? `${titles[kind]} “${name}”` : titles[kind], ...more };
    if (part.x.length || part.levels.length || part.circle) parts.push(part);
  };
  for (const kind of ["entry", "exit"] as const) {
    const x = readLengths(findNode(tree, ["lem", "entry_exit", kind]));
    add(kind, ["lem", "entry_exit"], kind, { x: x.length === 2 ? x : [] });
  }
  add("tangent", ["lem", "tangent"], null, { levels: readLengths(findNode(tree, ["lem", "tangent", "levels"])) });
  add("levels", ["lem", "grid"], "levels", { levels: readLengths(findNode(tree, ["lem", "grid", "levels"])) });
  for (const [kind, path] of [["slurry", ["slurry"]], ["heave", ["seepage", "heave"]]] as const) {
    const list = findNode(tree, path);
    if (list?.kind !== "list") continue;
    list.items.forEach((_, i) => {
      const at = [...path, i];
      const x = readLengths(findNode(tree, [...at, "x"]));
      add(kind, at, null, { x: x.length === 2 ? x : [], levels: readLengths(findNode(tree, [...at, "level"])) }, textAt(tree, [...at, "name"]));
    });
  }
  const surfaces = findNode(tree, ["lem", "surface"]);
  if (surfaces?.kind === "list")
    surfaces.items.forEach((_, i) => {
      const at = ["lem", "surface", i];
      const [x, y] = readLengths(findNode(tree, [...at, "centre"]));
      const radius = readLength(findNode(tree, [...at, "radius"]) ?? undefined);
      if (x && y && radius) add("circle", at, null, { circle: { centre: [x.value, y.value], radius } }, textAt(tree, [...at, "name"]));
    });
  return parts;
}

/** All parts in the order of the kinds; `built` are regions that the engine makes of layers. */
export function listParts(tree: CaseTree, chains: readonly Chain[], built: readonly (readonly Point[])[]): Part[] {
  const lines = listSides(tree, chains, built);
  for (const chain of chains) if (chain.kind === "line") lines.set(chain.name, pointsOf(chain));
  return [...listConditions(tree, lines), ...listRanges(tree)];
}
