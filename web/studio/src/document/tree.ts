// SPDX-License-Identifier: MIT
/** A case text as a tree of values with their places in the text [UTF-16 units], so that edits replace values and keep comments. */
import { type AST, parseTOML } from "toml-eslint-parser";

export type Range = readonly [number, number];
export type Path = readonly (string | number)[];

export interface Entry {
  node: Node;
  key: Range;
  /** `key = value`; null for a table with a header of its own. */
  line: Range | null;
}

export interface ValueNode {
  kind: "value";
  value: string | number | boolean;
  range: Range;
}
export interface ListNode {
  kind: "list";
  items: Node[];
  range: Range;
  /** Its items are tables with headers `[[…]]`. */
  headers: boolean;
}
export interface TableNode {
  kind: "table";
  entries: Map<string, Entry>;
  range: Range;
  /** The range of the header line; null for a table on one line, or one that only dotted keys or deeper headers imply. */
  header: Range | null;
  inline: boolean;
  /** New keys are inserted here. */
  end: number;
}
export type Node = ValueNode | ListNode | TableNode;

export interface CaseTree {
  text: string;
  root: TableNode;
}

export interface TextFault {
  text: string;
  at: number;
}

const keyName = (key: AST.TOMLBare | AST.TOMLQuoted) => (key.type === "TOMLBare" ? key.name : key.value);

function makeTable(range: Range, header: Range | null, inline: boolean): TableNode {
  return { kind: "table", entries: new Map(), range, header, inline, end: range[1] };
}

function readValue(node: AST.TOMLContentNode): Node {
  if (node.type === "TOMLArray")
    return { kind: "list", items: node.elements.map(readValue), range: node.range, headers: false };
  if (node.type === "TOMLInlineTable") {
    const table = makeTable(node.range, null, true);
    for (const pair of node.body) addPair(table, pair);
    return table;
  }
  const value = node.kind === "integer" || node.kind === "float" ? Number(node.value) : node.value;
  const known = typeof value === "string" || typeof value === "number" || typeof value === "boolean";
  return { kind: "value", value: known ? value : "datetime" in node ? node.datetime : String(value), range: node.range };
}

function addPair(table: TableNode, pair: AST.TOMLKeyValue): void {
  let at = table;
  const keys = pair.key.keys;
  for (const key of keys.slice(0, -1)) {
    const found = at.entries.get(keyName(key))?.node;
    if (found?.kind === "table") at = found;
    else {
      const made = makeTable(pair.range, null, false);
      at.entries.set(keyName(key), { node: made, key: key.range, line: null });
      at = made;
    }
  }
  const last = keys.at(-1)!;
  at.entries.set(keyName(last), { node: readValue(pair.value), key: last.range, line: pair.range });
}

/** The table that a header names; tables on the way are made. */
function openTable(root: TableNode, found: AST.TOMLTable): TableNode {
  let at = root;
  const made = makeTable(found.range, findLine(found), false);
  const names = found.key.keys;
  names.forEach((name, i) => {
    const last = i === names.length - 1;
    const known = at.entries.get(keyName(name));
    if (!last) {
      let next = known?.node;
      if (next?.kind === "list") next = next.items.at(-1);
      if (next?.kind !== "table") {
        next = makeTable(found.range, null, false);
        at.entries.set(keyName(name), { node: next, key: name.range, line: null });
      }
      at = next;
    } else if (found.kind === "array") {
      if (known?.node.kind === "list") {
        known.node.items.push(made);
        known.node.range = [known.node.range[0], found.range[1]];
      } else {
        const list: ListNode = { kind: "list", items: [made], range: found.range, headers: true };
        at.entries.set(keyName(name), { node: list, key: name.range, line: null });
      }
    } else if (known?.node.kind === "table") {
      // Deeper headers came first.
      at = Object.assign(known.node, { header: made.header, range: made.range, end: made.end });
    } else at.entries.set(keyName(name), { node: made, key: name.range, line: null });
  });
  return at.header === made.header ? at : made;
}

function findLine(table: AST.TOMLTable): Range {
  return [table.range[0], table.key.range[1] + (table.kind === "array" ? 2 : 1)];
}

/** Reads a text; a text that is not TOML gives its first fault. */
export function readTree(text: string): { tree: CaseTree; fault: null } | { tree: null; fault: TextFault } {
  try {
    const top = parseTOML(text).body[0];
    const root = makeTable([0, text.length], null, false);
    root.end = 0;
    for (const part of top.body) {
      if (part.type === "TOMLKeyValue") {
        addPair(root, part);
        root.end = part.range[1];
      } else {
        const table = openTable(root, part);
        for (const pair of part.body) addPair(table, pair);
        table.end = part.body.at(-1)?.range[1] ?? part.range[1];
      }
    }
    return { tree: { text, root }, fault: null };
  } catch (error) {
    const { message, index } = error as { message: string; index?: number };
    return { tree: null, fault: { text: message, at: Math.min(index ?? 0, text.length) } };
  }
}

export function findNode(tree: CaseTree, path: Path): Node | null {
  let at: Node | undefined = tree.root;
  for (const step of path) {
    if (at?.kind === "table" && typeof step === "string") at = at.entries.get(step)?.node;
    else if (at?.kind === "list" && typeof step === "number") at = at.items[step];
    else return null;
  }
  return at ?? null;
}

export function findEntry(tree: CaseTree, path: Path): Entry | null {
  const table = findNode(tree, path.slice(0, -1));
  const key = path.at(-1);
  return table?.kind === "table" && typeof key === "string" ? (table.entries.get(key) ?? null) : null;
}

/** Plain values: tables become objects, lists arrays. */
export function toPlain(node: Node | null): unknown {
  if (!node) return undefined;
  if (node.kind === "value") return node.value;
  if (node.kind === "list") return node.items.map(toPlain);
  return Object.fromEntries([...node.entries].map(([key, entry]) => [key, toPlain(entry.node)]));
}

export const writePath = (path: Path): string => path.join(".");
