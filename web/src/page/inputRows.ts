// SPDX-License-Identifier: MIT
/** The input as rows: each value with its key, its unit, and whether the case file gave it; and as a case file. */
import type { InputTable, InputValue } from "../contract";

export interface InputRow {
  /** Path inside its block: "curve.from". */
  key: string;
  value: unknown;
  unit: string;
  given: boolean;
}

/** Rows under one heading: a table, or one of several of the same name. */
interface InputGroup {
  /** "stage 2 (real strength)", or empty for the block itself. */
  title: string;
  rows: InputRow[];
}

export interface InputBlock {
  name: string;
  groups: InputGroup[];
}

export type InputNode = InputTable | InputTable[] | InputValue;

/** A leaf has the two keys of InputValue; a table of the case with a key "given" would hold a table there. */
export function isValue(node: InputNode): node is InputValue {
  return !Array.isArray(node) && typeof (node as InputValue).given === "boolean";
}

function gather(node: InputNode, path: string[], group: InputGroup, groups: InputGroup[]) {
  if (isValue(node)) {
    group.rows.push({ key: path.join("."), value: node.value, unit: node.unit ?? "", given: node.given });
  } else if (Array.isArray(node)) {
    node.forEach((table, i) => {
      const name = table.name && isValue(table.name) && table.name.value ? ` (${String(table.name.value)})` : "";
      const own: InputGroup = { title: `${path.join(".")} ${i + 1}${name}`.trim(), rows: [] };
      groups.push(own);
      for (const [key, child] of Object.entries(table)) gather(child, [key], own, groups);
    });
  } else {
    for (const [key, child] of Object.entries(node)) gather(child, [...path, key], group, groups);
  }
}

/** One block for each top-level table; single values of the top level come first, together. */
export function listBlocks(input: InputTable): InputBlock[] {
  const single: InputGroup = { title: "", rows: [] };
  const blocks: InputBlock[] = [];
  for (const [name, node] of Object.entries(input)) {
    if (isValue(node)) {
      gather(node, [name], single, []);
      continue;
    }
    const first: InputGroup = { title: "", rows: [] };
    const groups: InputGroup[] = [];
    if (Array.isArray(node)) {
      gather(node, [name], first, groups);
    } else {
      for (const [key, child] of Object.entries(node)) gather(child, [key], first, groups);
    }
    const filled = [first, ...groups].filter((group) => group.rows.length > 0);
    if (filled.length > 0) blocks.push({ name, groups: filled });
  }
  return single.rows.length > 0 ? [{ name: "case", groups: [single] }, ...blocks] : blocks;
}

/** A value as text: lists in brackets, nothing as a dash. */
export function formatInput(value: unknown): string {
  if (value === null || value === undefined) return "–";
  if (value === "") return "(empty)";
  if (Array.isArray(value)) return value.length === 0 ? "(none)" : `[${value.map(formatInput).join(", ")}]`;
  if (typeof value === "number") return String(Number(value.toPrecision(10)));
  if (typeof value === "object") return JSON.stringify(value);
  return String(value);
}

const quoteKey = (key: string) => (/^[A-Za-z0-9_-]+$/.test(key) ? key : JSON.stringify(key));

function writeValue(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(writeValue).join(", ")}]`;
  if (typeof value === "number") return String(Number(value.toPrecision(15)));
  if (typeof value === "object" && value !== null) {
    const pairs = Object.entries(value).map(([key, child]) => `${quoteKey(key)} = ${writeValue(child)}`);
    return `{ ${pairs.join(", ")} }`;
  }
  return typeof value === "boolean" ? String(value) : JSON.stringify(String(value));
}

/** Plain numbers are in the unit that the manual names, which is the unit of the echo. */
function writeTable(table: InputTable, path: string[], head: string | null, onlyGiven: boolean): string[] {
  const own: string[] = [];
  const below: string[] = [];
  for (const [key, node] of Object.entries(table) as [string, InputNode][]) {
    const here = [...path, quoteKey(key)];
    if (isValue(node)) {
      if (node.value === null || (onlyGiven && !node.given)) continue;
      // An empty list may mean no tables, which a case file does not write.
      if (Array.isArray(node.value) && node.value.length === 0) continue;
      own.push(`${quoteKey(key)} = ${writeValue(node.value)}${node.unit ? `  # ${node.unit}` : ""}`);
    } else if (Array.isArray(node)) {
      for (const child of node) below.push(...writeTable(child, here, `[[${here.join(".")}]]`, onlyGiven));
    } else {
      below.push(...writeTable(node, here, `[${here.join(".")}]`, onlyGiven));
    }
  }
  const needsHead = head !== null && (own.length > 0 || head.startsWith("[["));
  return [...(needsHead ? ["", head] : []), ...own, ...below];
}

export function writeToml(input: InputTable, onlyGiven: boolean): string {
  return `${writeTable(input, [], null, onlyGiven).join("\n").trim()}\n`;
}
