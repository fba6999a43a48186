// SPDX-License-Identifier: MIT
/** Settings of this calculation, looked up in the input echo: those that the methods section quotes, and the selected methods. */
import { findMethods } from "../../compared/methodTable";
import type { InputTable, Method, Report } from "../../contract";
import { type InputNode, isValue } from "../inputRows";

/** The value at a path such as "strength_reduction.frozen.damping", or undefined. */
export function findSetting(input: InputTable, path: string): unknown {
  let node: InputNode | undefined = input;
  for (const key of path.split(".")) {
    if (node === undefined || Array.isArray(node) || isValue(node)) return undefined;
    node = node[key];
  }
  return node !== undefined && !Array.isArray(node) && isValue(node) ? node.value : undefined;
}

/** A number of the input as text; `otherwise` where the input does not name it. */
export function quoteNumber(input: InputTable, path: string, otherwise: string): string {
  const value = findSetting(input, path);
  return typeof value === "number" ? writeNumber(value) : otherwise;
}

function writeNumber(value: number): string {
  const [mantissa, exponent] = value !== 0 && Math.abs(value) < 1e-2 ? value.toExponential().split("e") : [];
  if (mantissa === undefined) return String(Number(value.toPrecision(6)));
  return mantissa === "1" ? `$10^{${Number(exponent)}}$` : `$${mantissa}\\times10^{${Number(exponent)}}$`;
}

/** Stages and trials of a setting: their place in the input, and their name in a sentence. */
function listCalculations(input: InputTable): { table: InputTable; name: string }[] {
  const found: { table: InputTable; name: string }[] = [];
  const stages = input.stage;
  if (Array.isArray(stages)) {
    stages.forEach((table, i) => {
      const name = table.name && isValue(table.name) ? String(table.name.value) : String(i + 1);
      found.push({ table, name: `stage “${name}”` });
    });
  }
  for (const [key, name] of [
    ["curve", "the trials of the curve"],
    ["frozen", "the trials at frozen geometry"],
  ] as const) {
    const block = input.strength_reduction;
    const table = block && !Array.isArray(block) && !isValue(block) ? block[key] : undefined;
    const analysed = findSetting(input, "analysis.kind") === "strength_reduction";
    if (analysed && table && !Array.isArray(table) && !isValue(table) && findSetting(table, "enabled") !== false)
      found.push({ table, name });
  }
  return found;
}

const join = (parts: string[]) =>
  parts.length < 2 ? (parts[0] ?? "") : `${parts.slice(0, -1).join(", ")} and ${parts.at(-1)}`;

/** "stage “gravity” and the trials at frozen geometry": where a setting is a word. */
export function quoteWhere(input: InputTable, key: string, word: string): string {
  return join(listCalculations(input).flatMap(({ table, name }) => (findSetting(table, key) === word ? [name] : [])));
}

/** The words that the blocks of a list, or of a table of named blocks, have under a key; each once. */
export function findWords(input: InputTable, list: string, key: string): string[] {
  const blocks = input[list];
  if (blocks === undefined || (!Array.isArray(blocks) && isValue(blocks))) return [];
  const tables = Array.isArray(blocks) ? blocks : Object.values(blocks);
  const words = tables.map((table) => (Array.isArray(table) || isValue(table) ? undefined : findSetting(table, key)));
  return [...new Set(words.filter((word) => typeof word === "string"))];
}

/** "0.75 in stage “gravity” and 0.05 in the trials of the curve"; empty where nothing is known. */
export function quoteEach(input: InputTable, key: string): string {
  const groups = new Map<string, string[]>();
  for (const { table, name } of listCalculations(input)) {
    const value = findSetting(table, key);
    if (typeof value !== "number") continue;
    const text = writeNumber(value);
    groups.set(text, [...(groups.get(text) ?? []), name]);
  }
  if (groups.size === 1) return `${[...groups.keys()][0]} throughout`;
  return join([...groups].map(([text, names]) => `${text} in ${join(names)}`));
}

/** Returns whether a switch is on, or a number is not 0, in any stage or trial; undefined where the input does not name it. */
export function isOnAnywhere(input: InputTable, key: string): boolean | undefined {
  const values = listCalculations(input).map(({ table }) => findSetting(table, key));
  const known = values.filter((value) => typeof value === "boolean" || typeof value === "number");
  return known.length === 0 ? undefined : known.some(Boolean);
}

/** A report that names none is one of MPM. */
export function selectsMethod(report: Report, method: Method): boolean {
  const given = findSetting(report.result.input, "analysis.methods");
  const asked = findMethods(report)?.asked ?? (Array.isArray(given) ? given : []);
  return asked.length > 0 ? asked.includes(method) : method === "mpm";
}
