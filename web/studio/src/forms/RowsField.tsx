// SPDX-License-Identifier: MIT
/** A list of numbers or pairs as a table: cells are typed, rows added and deleted, tables pasted from a spreadsheet. */
import { applyEdits, insertItem, removeAt, setValue } from "../document/edits";
import { type Path, writePath } from "../document/tree";
import * as state from "../state";
import { isCell, pasteInto, readPasted, type Rows, writeCell, writeRow, writeRows } from "./rows";
import { TextInput } from "./TextInput";

interface Props {
  path: Path;
  rows: Rows;
  id: string;
  noteId: string;
  label: string;
}

const refuse = (text: string) => {
  state.notice.value = { text, bad: true };
  return false;
};

/** A table of the clipboard as the whole value of a key that has none yet. */
export function pasteWhole(event: ClipboardEvent, path: Path, columns: 1 | 2): void {
  const pasted = readPasted(event.clipboardData?.getData("text/plain") ?? "");
  if (!pasted) return;
  const cells = pasteInto({ columns, cells: [] }, pasted, 0, 0);
  if (!cells) return void refuse(`The table has ${pasted[0]!.length} columns; ${writePath(path)} takes ${columns}.`);
  event.preventDefault();
  state.attempt(`Paste ${cells.length} rows`, () => applyEdits(state.tree.value.text, setValue(state.tree.value, path, writeRows(cells))));
}

export function RowsField({ path, rows, id, noteId, label }: Props) {
  const { columns, cells } = rows;
  const name = writePath(path);
  const set = (i: number, k: number, typed: string) => {
    const clean = typed.trim();
    if (!isCell(clean)) return refuse(`“${typed}” is not a number or a number with a unit.`);
    const at = columns === 1 ? [...path, i] : [...path, i, k];
    return state.attempt(`Set ${name}`, () => applyEdits(state.tree.value.text, setValue(state.tree.value, at, writeCell(clean))));
  };
  const add = (i: number) => state.attempt(`Add a row to ${name}`, () => applyEdits(state.tree.value.text, insertItem(state.tree.value, path, i + 1, writeRow(cells[i]!))));
  const remove = (i: number) => {
    const at = cells.length === 1 ? path : [...path, i];
    return state.attempt(`Delete a row of ${name}`, () => applyEdits(state.tree.value.text, removeAt(state.tree.value, at)));
  };
  const paste = (event: ClipboardEvent, i: number, k: number) => {
    const pasted = readPasted(event.clipboardData?.getData("text/plain") ?? "");
    if (!pasted) return;
    event.preventDefault();
    const after = pasteInto(rows, pasted, i, k);
    if (!after) return void refuse(`The table has ${pasted[0]!.length} columns and ${pasted.length} rows, which do not fit here.`);
    state.attempt(`Paste ${pasted.length} rows`, () => applyEdits(state.tree.value.text, setValue(state.tree.value, path, writeRows(after))));
  };
  return (
    <details class="rows-field" open={cells.length <= 4}>
      <summary id={id} aria-describedby={noteId}>
        {cells.length} {columns === 1 ? (cells.length === 1 ? "value" : "values") : cells.length === 1 ? "row" : "rows"}
      </summary>
      <table class="points">
        <caption class="unseen">{label}</caption>
        <tbody>
          {cells.map((row, i) => (
            <tr key={i}>
              <th scope="row">{i + 1}</th>
              {row.map((cell, k) => (
                <td key={k} onPaste={(e) => paste(e, i, k)}>
                  <TextInput aria-label={`${label}, row ${i + 1}${columns === 2 ? `, column ${k + 1}` : ""}`} value={cell} commit={(typed) => set(i, k, typed)} />
                </td>
              ))}
              <td class="row-tools">
                <button type="button" title="Add a row after this one" aria-label={`${label}: add a row after ${i + 1}`} onClick={() => add(i)}>
                  +
                </button>
                <button type="button" title="Delete this row" aria-label={`${label}: delete row ${i + 1}`} onClick={() => remove(i)}>
                  −
                </button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}
