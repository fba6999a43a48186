// SPDX-License-Identifier: MIT
/** The points of a region or line as a table: typed, inserted, deleted, pasted from a spreadsheet. */
import type { Chain } from "../document/chains";
import { applyEdits, writeNumber } from "../document/edits";
import { deleteVertex, insertVertex, moveVertices, pointsOf, replacePoints } from "../document/vertices";
import { TextInput } from "../forms/TextInput";
import { readPastedPoints } from "../geometry/coordinates";
import * as state from "../state";
import { fromShownLength, length, toShownLength } from "../units";

/** A coordinate in the unit of display. */
export const writeShown = (metres: number): string => writeNumber(Number(toShownLength(metres).toFixed(6)));

/** A coordinate of a vertex; all that shares it moves. */
function PointRow({ chain, index }: { chain: Chain; index: number }) {
  const { x, y } = chain.points[index]!;
  const c = state.chains.value.indexOf(chain);
  const vertex = state.vertices.value.find(({ corners }) => corners.some((corner) => corner.chain === c && corner.index === index));
  if (!vertex) return null;
  const set = (which: 0 | 1, typed: string) => {
    const value = Number(typed.replace("−", "-"));
    if (typed.trim() === "" || Number.isNaN(value)) {
      state.notice.value = { text: `“${typed}” is not a coordinate.`, bad: true };
      return;
    }
    const metres = Number(fromShownLength(value).toFixed(9));
    const to = which === 0 ? ([metres, vertex.at[1]] as const) : ([vertex.at[0], metres] as const);
    state.attempt("Move a vertex", () => moveVertices(state.tree.value, state.chains.value, [{ vertex, to }], state.vertices.value));
  };
  const add = () => {
    const points = pointsOf(chain);
    const next = points[(index + 1) % points.length]!;
    const at = [(vertex.at[0] + next[0]) / 2, (vertex.at[1] + next[1]) / 2] as const;
    state.attempt("Insert a vertex", () => insertVertex(state.tree.value, state.chains.value, at, c));
  };
  const isLast = !chain.closed && index === chain.points.length - 1;
  const name = `Point ${index + 1}`;
  return (
    <tr class={state.selectedVertex.value === vertex ? "chosen" : undefined}>
      <th scope="row">{index + 1}</th>
      <td>
        <TextInput aria-label={`${name}, x`} value={writeShown(x.value)} commit={(typed) => set(0, typed)} />
      </td>
      <td>
        <TextInput aria-label={`${name}, y`} value={writeShown(y.value)} commit={(typed) => set(1, typed)} />
      </td>
      <td class="row-tools">
        <button type="button" title="Insert a point after this one" aria-label={`Insert a point after ${index + 1}`} disabled={isLast || chain.single || chain.corners} onClick={add}>
          +
        </button>
        <button
          type="button"
          title="Delete this point"
          aria-label={`Delete point ${index + 1}`}
          onClick={() => state.attempt("Delete a vertex", () => deleteVertex(state.tree.value, state.chains.value, vertex))}
        >
          −
        </button>
      </td>
    </tr>
  );
}

export function PointTable({ chain }: { chain: Chain }) {
  const paste = (event: ClipboardEvent) => {
    const points = readPastedPoints(event.clipboardData?.getData("text/plain") ?? "", length.value.size);
    // A single number goes into its cell.
    if (!points || points.length < 2) return;
    event.preventDefault();
    state.attempt(`Paste ${points.length} points`, () => applyEdits(state.tree.value.text, replacePoints(state.tree.value, chain, points)));
  };
  return (
    <table class="points" onPaste={paste}>
      <caption>Points. A table pasted from a spreadsheet replaces them.</caption>
      <thead>
        <tr>
          <th scope="col">
            <span class="unseen">Number</span>
          </th>
          <th scope="col">x [{length.value.name}]</th>
          <th scope="col">y [{length.value.name}]</th>
          <th scope="col">
            <span class="unseen">Change</span>
          </th>
        </tr>
      </thead>
      <tbody>
        {chain.points.map((_, index) => (
          <PointRow key={index} chain={chain} index={index} />
        ))}
      </tbody>
    </table>
  );
}
