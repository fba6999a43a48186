// SPDX-License-Identifier: MIT
/** Writes the input back as a case file: what was given, or every value. */
import { isValue, type InputNode } from "./inputRows";
import type { InputTable } from "../contract";

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
