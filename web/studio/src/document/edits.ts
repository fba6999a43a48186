// SPDX-License-Identifier: MIT
/** Edits of a case text by ranges: values are replaced, keys and blocks added and removed, everything else stays as typed. */
import { type CaseTree, findEntry, findNode, type Node, type Path, type Range, type TableNode } from "./tree";

export interface Edit {
  from: number;
  to: number;
  insert: string;
}

/** Thrown where a text is written in a way that the page does not edit; the sentence is shown to the user. */
export class EditFault extends Error {}

/** Applies edits that do not overlap; insertions at one place keep their order. */
export function applyEdits(text: string, edits: readonly Edit[]): string {
  const sorted = edits.map((edit, i) => ({ ...edit, i })).sort((a, b) => a.from - b.from || a.i - b.i);
  let result = "";
  let at = 0;
  for (const { from, to, insert } of sorted) {
    if (from < at) throw new EditFault("Two edits of the text overlap.");
    result += text.slice(at, from) + insert;
    at = to;
  }
  return result + text.slice(at);
}

/** The smallest single edit from one text to another. */
export function findDifference(before: string, after: string): Edit {
  const shorter = Math.min(before.length, after.length);
  let from = 0;
  while (from < shorter && before.charCodeAt(from) === after.charCodeAt(from)) ++from;
  let tail = 0;
  while (tail < shorter - from && before.charCodeAt(before.length - 1 - tail) === after.charCodeAt(after.length - 1 - tail))
    ++tail;
  return { from, to: before.length - tail, insert: after.slice(from, after.length - tail) };
}

/** A coordinate or value with at most nine decimals and without an exponent where one is not needed. */
export function writeNumber(value: number): string {
  const text = String(Number(value.toFixed(9)));
  return text === "-0" ? "0" : text;
}

export const writePoint = ([x, y]: readonly [number, number]): string => `[${writeNumber(x)}, ${writeNumber(y)}]`;

export const writePoints = (points: readonly (readonly [number, number])[]): string =>
  `[${points.map(writePoint).join(", ")}]`;

export const writeText = (text: string): string => JSON.stringify(text).replace(/\u007f/g, "\\u007F");

export const writeKey = (name: string): string => (/^[A-Za-z0-9_-]+$/.test(name) ? name : writeText(name));

const endOfLine = (text: string, at: number) => {
  const found = text.indexOf("\n", at);
  return found < 0 ? text.length : found;
};

const startOfLine = (text: string, at: number) => text.lastIndexOf("\n", at - 1) + 1;

/** The last place of a table with all the tables below it. */
function findEnd(node: Node): number {
  if (node.kind === "value") return node.range[1];
  const inner = node.kind === "list" ? node.items : [...node.entries.values()].map((entry) => entry.node);
  const own = node.kind === "table" ? (node.inline ? node.range[1] : node.end) : node.headers ? 0 : node.range[1];
  return Math.max(own, ...inner.map(findEnd));
}

function insertKey(tree: CaseTree, table: TableNode, key: string, value: string): Edit {
  if (table.inline) {
    const at = table.range[1] - 1;
    const spaced = tree.text[at - 1] === " " ? at - 1 : at;
    return { from: spaced, to: spaced, insert: `${table.entries.size ? ", " : " "}${writeKey(key)} = ${value}${spaced === at ? " " : ""}` };
  }
  if (table === tree.root && table.end === 0) return { from: 0, to: 0, insert: `${writeKey(key)} = ${value}\n` };
  const at = endOfLine(tree.text, table.end);
  return { from: at, to: at, insert: `\n${writeKey(key)} = ${value}` };
}

/** Blocks are appended after the block that precedes them in this order. */
const order = [
  "title", "format", "unusual", "project", "geometry", "mesh", "materials", "regions", "boundary", "traction", "support",
  "surcharge", "slurry", "earthquake", "water", "hydraulic", "roots", "gravity", "initial", "seepage", "stage", "rest",
  "analysis", "lem", "fem", "bounds", "strength_reduction", "partial_factors", "output", "compare", "study", "calibration",
];

/** The end of the block after which a new block `name` belongs. */
function findPlace(tree: CaseTree, path: Path): number {
  for (let depth = path.length; depth > 0; --depth) {
    const node = findNode(tree, path.slice(0, depth));
    if (node) return findEnd(node);
  }
  const rank = order.indexOf(String(path[0]));
  let best = -1;
  let end = tree.root.end;
  for (const [name, { node }] of tree.root.entries) {
    const other = order.indexOf(name);
    if (other <= rank && other >= best && findEnd(node) >= end) {
      best = other;
      end = findEnd(node);
    }
  }
  return end;
}

function insertBlock(tree: CaseTree, path: Path, list: boolean, lines: readonly string[]): Edit {
  const name = path.map((step) => writeKey(String(step))).join(".");
  const at = endOfLine(tree.text, findPlace(tree, path));
  const body = [list ? `[[${name}]]` : `[${name}]`, ...lines].join("\n");
  const before = at === 0 ? "" : tree.text.slice(0, at).endsWith("\n") ? "\n" : "\n\n";
  return { from: at, to: at, insert: before + body + (at === tree.text.length || at === 0 ? "\n" : "") };
}

function checkOpen(tree: CaseTree, path: Path): void {
  for (let depth = 1; depth <= path.length; ++depth) {
    const node = findNode(tree, path.slice(0, depth));
    if ((node?.kind === "table" && node.inline) || (node?.kind === "list" && !node.headers))
      throw new EditFault(`'${path.slice(0, depth).join(".")}' is written on one line, so no block can follow it. Edit it in the text.`);
  }
}

/** Appends an entry `[[path]]` with the given keys. */
export function appendEntry(tree: CaseTree, path: Path, values: Record<string, string>): Edit[] {
  checkOpen(tree, path);
  const lines = Object.entries(values).map(([key, value]) => `${writeKey(key)} = ${value}`);
  return [insertBlock(tree, path, true, lines)];
}

/** Sets `path` to a value that is written as TOML; missing tables are added. */
export function setValue(tree: CaseTree, path: Path, value: string): Edit[] {
  const node = findNode(tree, path);
  if (node && !(node.kind === "list" && node.headers)) return [{ from: node.range[0], to: node.range[1], insert: value }];
  const parent = path.slice(0, -1);
  const key = String(path.at(-1));
  const table = findNode(tree, parent);
  if (table?.kind === "table" && (table.inline || table.header || table === tree.root || hasOwnLines(table)))
    return [insertKey(tree, table, key, value)];
  if (parent.some((step) => typeof step === "number")) {
    // [a.b] below the last [[a]] only belongs to that entry.
    const at = parent.findLastIndex((step) => typeof step === "number");
    const list = findNode(tree, parent.slice(0, at));
    if (list?.kind === "list" && parent[at] !== list.items.length - 1) {
      const owner = findNode(tree, parent.slice(0, at + 1));
      if (owner?.kind !== "table") throw new EditFault(`'${path.join(".")}' cannot be added here. Edit it in the text.`);
      const inner = parent.slice(at + 1).map(String);
      return [insertKey(tree, owner, inner[0]!, `{ ${[...inner.slice(1), key].map(writeKey).join(".")} = ${value} }`)];
    }
  }
  checkOpen(tree, parent);
  const names = parent.filter((step) => typeof step === "string");
  return [insertBlock(tree, names, false, [`${writeKey(key)} = ${value}`])];
}

/** A table without a header whose keys are dotted lines: new keys cannot be appended to it, but a header would be refused. */
function hasOwnLines(table: TableNode): boolean {
  return !table.header && [...table.entries.values()].some((entry) => entry.line !== null);
}

/** Removes a whole line where nothing but a comment stays on it. */
function removeLines(text: string, [from, to]: Range): Edit {
  const start = startOfLine(text, from);
  const end = endOfLine(text, to);
  const alone = text.slice(start, from).trim() === "" && /^\s*(#.*)?$/.test(text.slice(to, end));
  return alone ? { from: start, to: Math.min(text.length, end + 1), insert: "" } : { from, to, insert: "" };
}

/** Removes an element of a list on one line with the comma beside it. */
function removeItem(list: ListLike, index: number): Edit {
  const item = list.items[index]!;
  const next = list.items[index + 1];
  if (next) return { from: item.range[0], to: next.range[0], insert: "" };
  const before = list.items[index - 1];
  return { from: before ? before.range[1] : item.range[0], to: item.range[1], insert: "" };
}
type ListLike = { items: readonly { range: Range }[] };

/** Removes a key, an element of a list, or a block with everything below it. Nothing happens where there is none. */
export function removeAt(tree: CaseTree, path: Path): Edit[] {
  const node = findNode(tree, path);
  if (!node) return [];
  const last = path.at(-1);
  if (typeof last === "number") {
    const list = findNode(tree, path.slice(0, -1));
    if (list?.kind === "list" && !list.headers) return [removeItem(list, last)];
    return listBlocks(node).map((range) => removeBlock(tree.text, range));
  }
  const entry = findEntry(tree, path)!;
  if (entry.line) {
    const table = findNode(tree, path.slice(0, -1));
    if (table?.kind === "table" && table.inline) {
      const items = [...table.entries.values()].map(({ line }) => ({ range: line! }));
      return [removeItem({ items }, items.findIndex(({ range }) => range[0] === entry.line![0]))];
    }
    return [removeLines(tree.text, entry.line)];
  }
  return listBlocks(node).map((range) => removeBlock(tree.text, range));
}

/** Ranges of all headers with their keys at and below a node. */
function listBlocks(node: Node): Range[] {
  if (node.kind === "value") return [];
  if (node.kind === "list") return node.items.flatMap(listBlocks);
  const own: Range[] = node.header ? [[node.header[0], node.end]] : [];
  return [...own, ...[...node.entries.values()].flatMap((entry) => (entry.line ? [] : listBlocks(entry.node)))];
}

function removeBlock(text: string, [from, to]: Range): Edit {
  let end = Math.min(text.length, endOfLine(text, to) + 1);
  // One empty line of the two around the block goes with it.
  if (text[end] === "\n") ++end;
  return { from: startOfLine(text, from), to: end, insert: "" };
}

/** Inserts an element into a list of values before `index`. */
export function insertItem(tree: CaseTree, path: Path, index: number, value: string): Edit[] {
  const list = findNode(tree, path);
  if (list?.kind !== "list" || list.headers) throw new EditFault(`'${path.join(".")}' is not a list of points in the text.`);
  const before = list.items[index - 1];
  if (before) return [{ from: before.range[1], to: before.range[1], insert: `, ${value}` }];
  const after = list.items[index];
  const at = after ? after.range[0] : list.range[0] + 1;
  return [{ from: at, to: at, insert: after ? `${value}, ` : value }];
}
