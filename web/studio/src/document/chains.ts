// SPDX-License-Identifier: MIT
/** Lists of points of a case: regions, lines, ground, layers, water, surfaces, each with the places of its numbers in the text. */
import { readQuantity } from "../units";
import { type CaseTree, findNode, type Node, type Path, type Range, toPlain, writePath } from "./tree";

export type ChainKind =
  | "region"
  | "line"
  | "ground"
  | "layer"
  | "water"
  | "piezometric"
  | "drawdown"
  | "surface"
  | "exclude"
  | "through"
  | "window"
  | "monitor"
  | "support"
  | "section"
  | "windowBox"
  | "throughBox"
  | "centres"
  | "centre"
  | "box";

export interface LengthAt {
  /** [m] */
  value: number;
  range: Range;
  /** Unit of a text such as "33 ft", and its length [m]; null for a plain number. */
  unit: { name: string; si: number } | null;
}

export interface ChainPoint {
  x: LengthAt;
  y: LengthAt;
}

export interface Chain {
  id: string;
  kind: ChainKind;
  name: string;
  /** Of the list of points. */
  path: Path;
  /** Of the table that describes it. */
  owner: Path;
  closed: boolean;
  /** A single point `[x, y]` and not a list of points. */
  single: boolean;
  /** Two opposite corners of a rectangle. */
  corners: boolean;
  points: ChainPoint[];
  /** Material of a region. */
  soil: string | null;
}

const lengths: Record<string, number> = { m: 1, cm: 0.01, mm: 0.001, km: 1000, ft: 0.3048, in: 0.0254, yd: 0.9144 };

/** A length as number or as text with a usual unit; null for anything else. */
export function readLength(node: Node | undefined): LengthAt | null {
  if (node?.kind !== "value") return null;
  if (typeof node.value === "number") return { value: node.value, range: node.range, unit: null };
  const parts = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([a-z]+)\s*$/.exec(String(node.value));
  const si = parts ? lengths[parts[2]!] : undefined;
  return parts && si ? { value: Number(parts[1]) * si, range: node.range, unit: { name: parts[2]!, si } } : null;
}

function readPoint(node: Node | undefined): ChainPoint | null {
  if (node?.kind !== "list" || node.items.length < 2) return null;
  const [x, y] = [readLength(node.items[0]), readLength(node.items[1])];
  return x && y ? { x, y } : null;
}

/** Kinds that two opposite corners describe. */
const rectangles: ReadonlySet<ChainKind> = new Set(["box", "windowBox", "throughBox", "centres"]);

interface Source {
  kind: ChainKind;
  path: Path;
  name: string;
  closed?: boolean;
  owner?: Path;
}

function readChain(tree: CaseTree, source: Source): Chain | null {
  const node = findNode(tree, source.path);
  if (node?.kind !== "list" || node.items.length === 0) return null;
  const single = node.items[0]!.kind === "value";
  const points = single ? [readPoint(node)] : node.items.map(readPoint);
  if (points.some((point) => !point)) return null;
  const { kind, path, name, closed = false, owner = path.slice(0, -1) } = source;
  const corners = rectangles.has(kind);
  if (corners && points.length !== 2) return null;
  return { id: writePath(path), kind, name, path, owner, closed, single, corners, points: points as ChainPoint[], soil: null };
}

function listEntries(tree: CaseTree, path: Path): { path: Path; name: string }[] {
  const list = findNode(tree, path);
  if (list?.kind !== "list") return [];
  return list.items.map((item, i) => {
    const name = item.kind === "table" ? item.entries.get("name")?.node : undefined;
    return { path: [...path, i], name: name?.kind === "value" ? String(name.value) : "" };
  });
}

function listSources(tree: CaseTree): Source[] {
  const sources: Source[] = [];
  const addAll = (kind: ChainKind, path: Path, key: string, closed = false, title = "") => {
    for (const entry of listEntries(tree, path))
      sources.push({ kind, path: [...entry.path, key], name: entry.name || title, closed });
  };
  sources.push({ kind: "box", path: ["geometry", "box"], name: "Box" });
  addAll("region", ["geometry", "polygon"], "points", true);
  sources.push({ kind: "ground", path: ["geometry", "ground"], name: "Ground" });
  addAll("layer", ["geometry", "layer"], "bottom");
  addAll("line", ["geometry", "line"], "points");
  sources.push({ kind: "water", path: ["initial", "water_table"], name: "Water table" });
  addAll("piezometric", ["initial", "piezometric_line"], "points", false, "Piezometric line");
  sources.push({ kind: "drawdown", path: ["lem", "drawdown", "water_table"], name: "Water table after drawdown" });
  addAll("surface", ["lem", "surface"], "points", false, "Slip surface");
  addAll("exclude", ["lem", "exclude"], "points", true, "Excluded area");
  addAll("through", ["lem", "through"], "points", false, "Surfaces pass here");
  addAll("throughBox", ["lem", "through"], "box", false, "Surfaces pass here");
  addAll("window", ["lem", "block", "window"], "points", false, "Window");
  addAll("windowBox", ["lem", "block", "window"], "box", false, "Window");
  sources.push({ kind: "centres", path: ["lem", "grid", "corners"], name: "Centres of circles" });
  addAll("centre", ["lem", "surface"], "centre", false, "Slip circle");
  addAll("section", ["seepage", "section"], "points", false, "Line of discharge");
  addAll("monitor", ["output", "monitor"], "at", false, "Monitor");
  const supports = findNode(tree, ["support"]);
  if (supports?.kind === "table")
    for (const name of supports.entries.keys())
      for (const key of ["first", "heads"]) sources.push({ kind: "support", path: ["support", name, key], name });
  return sources;
}

/** All chains in the order of the blocks; regions later in the file replace what they cover. */
export function listChains(tree: CaseTree): Chain[] {
  const chains = listSources(tree).flatMap((source) => readChain(tree, source) ?? []);
  const soils = toPlain(findNode(tree, ["regions"])) as Record<string, unknown> | undefined;
  for (const chain of chains) if (chain.kind === "region") chain.soil = soils?.[chain.name]?.toString() ?? null;
  return chains;
}

/** Names of the materials in the order of the file. */
export function listSoils(tree: CaseTree): string[] {
  const table = findNode(tree, ["materials"]);
  return table?.kind === "table" ? [...table.entries.keys()] : [];
}

export interface Load {
  path: Path;
  name: string;
  x: LengthAt[];
  /** [kPa]; NaN for a text with an unknown unit. */
  values: number[];
}

export function listLoads(tree: CaseTree): Load[] {
  return listEntries(tree, ["surcharge"]).flatMap(({ path, name }) => {
    const read = (key: string) => {
      const list = findNode(tree, [...path, key]);
      return list?.kind === "list" ? list.items : [];
    };
    const x = read("x").map(readLength);
    if (!x.length || x.some((at) => !at)) return [];
    const values = read("load").map((node) => (node.kind !== "value" ? NaN : typeof node.value === "number" ? node.value : (readQuantity(String(node.value), "kPa")?.value ?? NaN)));
    return [{ path, name: name || "Surcharge", x: x as LengthAt[], values }];
  });
}
