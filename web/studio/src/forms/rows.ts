// SPDX-License-Identifier: MIT
/** Lists of numbers and of pairs of numbers as tables: read from the text, from the clipboard, and written as TOML. */
import { findNode, type CaseTree, type Node, type Path } from "../document/tree";
import type { Field } from "./schema";

/** A cell as it is typed: a number, or a number with a unit. */
export interface Rows {
  columns: 1 | 2;
  cells: string[][];
}

const quantity = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?:\s*[^\s\d+.,;-].*)?$/;
export const isCell = (cell: string): boolean => quantity.test(cell.replace("−", "-"));

const readCell = (node: Node): string | null => (node.kind === "value" && typeof node.value !== "boolean" && isCell(String(node.value)) ? String(node.value) : null);

/** The value at a path as a table; null for anything but a list of numbers or of pairs. */
export function readRows(tree: CaseTree, path: Path): Rows | null {
  const list = findNode(tree, path);
  if (list?.kind !== "list" || list.headers || !list.items.length) return null;
  const cells = list.items.map((item) => (item.kind === "list" ? item.items.map(readCell) : [readCell(item)]));
  const columns = cells[0]!.length;
  if ((columns !== 1 && columns !== 2) || cells.some((row) => row.length !== columns || row.includes(null))) return null;
  // A point [x, y] is a list of two numbers, and not a table.
  return { columns, cells: cells as string[][] };
}

/** Columns of the tables that a key takes; 0 for a key that takes none. */
export function countColumns(field: Field): 0 | 1 | 2 {
  const found = [field.schema, ...(field.schema.anyOf ?? [])].find((part) => part.type === "array" && part.items);
  const items = found?.items;
  if (!items || items.enum || items.type === "string" || items.properties) return 0;
  return items.type === "array" ? 2 : 1;
}

/** Numbers plain, numbers with a unit as text. */
export function writeCell(cell: string): string {
  const clean = cell.trim().replace("−", "-");
  return Number.isNaN(Number(clean)) ? JSON.stringify(clean) : clean.replace(/^\+/, "").replace(/^(-?)\./, "$10.").replace(/\.$/, "");
}

export const writeRow = (row: readonly string[]): string => (row.length === 1 ? writeCell(row[0]!) : `[${row.map(writeCell).join(", ")}]`);
export const writeRows = (cells: readonly (readonly string[])[]): string => `[${cells.map(writeRow).join(", ")}]`;

/**
 * Cells of a table pasted from a spreadsheet: rows on lines, columns between tabs, semicolons, commas or blanks. Headings are
 * left out. Null for a text of one cell, or one that is no table of numbers.
 */
export function readPasted(text: string): string[][] | null {
  const rows = text
    .trim()
    .split(/\r?\n/)
    .map((row) => {
      const separator = ["\t", ";"].find((mark) => row.includes(mark));
      // A comma is decimal where tabs or semicolons separate the columns, or where there is one column of such numbers.
      if (separator) return row.split(separator).map((cell) => cell.trim().replace(/^([+-]?\d*),(\d+)/, "$1.$2"));
      return row.trim().split(/\s*,\s*|\s+(?=[+-]?[\d.])/).map((cell) => cell.trim());
    })
    .filter((row) => row.some((cell) => cell !== ""));
  const body = rows[0] && !rows[0].every(isCell) ? rows.slice(1) : rows;
  if (!body.length || body.some((row) => row.length !== body[0]!.length || !row.every(isCell))) return null;
  return body.length * body[0]!.length > 1 ? body : null;
}

/** Pasted cells in a table from a row and a column on; the table grows as needed. Null where they do not fit. */
export function pasteInto({ columns, cells }: Rows, pasted: readonly (readonly string[])[], row: number, column: number): string[][] | null {
  const width = pasted[0]!.length;
  // A row of values in a table of one column stands below each other.
  if (columns === 1 && pasted.length === 1 && width > 1) return pasteInto({ columns, cells }, pasted[0]!.map((cell) => [cell]), row, column);
  if (column + width > columns) return null;
  const after = cells.map((one) => [...one]);
  pasted.forEach((line, i) => {
    const at = row + i;
    if (!after[at]) {
      if (width < columns) return;
      after[at] = Array.from({ length: columns }, () => "0");
    }
    line.forEach((cell, k) => (after[at]![column + k] = cell));
  });
  return after.length >= row + pasted.length ? after : null;
}
