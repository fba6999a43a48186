// SPDX-License-Identifier: MIT
/** Typical values beside the form of a soil: shown with their source, and filled in where the user asks for it. */
import { useSignal } from "@preact/signals";

import { setValue, writeNumber } from "../document/edits";
import { findNode, toPlain } from "../document/tree";
import { applyInTurn } from "../document/vertices";
import { entries, type LibraryEntry, readOwn, source, writeOwn } from "../library/library";
import * as state from "../state";

const titles: Record<string, [string, string]> = {
  unit_weight: ["γ", "kN/m³"],
  cohesion: ["c'", "kPa"],
  friction_angle: ["φ'", "°"],
};

const writeRange = ([low, high]: readonly [number, number]) => (low === high ? String(low) : `${low} – ${high}`);
const middle = ([low, high]: readonly [number, number]) => Number(((low + high) / 2).toFixed(1));

/** Fills keys that are not given; what is given stays. */
function fill(soil: string, entry: LibraryEntry): void {
  const given = (toPlain(findNode(state.tree.value, ["materials", soil])) ?? {}) as Record<string, unknown>;
  const keys = Object.keys(entry.ranges).filter((key) => given[key] === undefined);
  if (!keys.length) {
    state.notice.value = { text: "All of these keys are given already.", bad: false };
    return;
  }
  state.attempt(`Fill ${soil} from the library`, () =>
    applyInTurn(
      state.tree.value.text,
      keys.map((key) => (tree) => {
        const value = entry.ranges[key]!;
        return setValue(tree, ["materials", soil, key], `${writeNumber(middle(value))} # typical of ${entry.symbol}: ${writeRange(value)}; replace by tests`);
      }),
    ),
  );
}

function keep(soil: string, own: readonly LibraryEntry[]): LibraryEntry[] {
  const given = (toPlain(findNode(state.tree.value, ["materials", soil])) ?? {}) as Record<string, unknown>;
  const ranges: LibraryEntry["ranges"] = {};
  for (const key of Object.keys(titles)) if (typeof given[key] === "number") ranges[key] = [given[key], given[key]];
  const entry: LibraryEntry = { symbol: soil, name: "own entry", ranges, note: "" };
  return [...own.filter(({ symbol }) => symbol !== soil), entry];
}

export function LibraryPart({ soil }: { soil: string }) {
  const chosen = useSignal("");
  const own = useSignal(readOwn());
  const entry = [...own.value, ...entries].find(({ symbol }) => symbol === chosen.value);
  const isOwn = entry !== undefined && own.value.includes(entry);
  const store = (all: LibraryEntry[]) => {
    own.value = all;
    writeOwn(all);
  };
  return (
    <details class="library">
      <summary>Typical values</summary>
      <label class="plain-field">
        Class
        <select value={chosen.value} onChange={(e) => (chosen.value = e.currentTarget.value)}>
          <option value="">choose …</option>
          {own.value.map(({ symbol }) => (
            <option key={symbol} value={symbol}>
              {symbol} (own)
            </option>
          ))}
          {entries.map(({ symbol, name }) => (
            <option key={symbol} value={symbol}>
              {symbol}: {name}
            </option>
          ))}
        </select>
      </label>
      {entry && (
        <>
          <ul class="typical">
            {Object.entries(entry.ranges).map(([key, range]) => (
              <li key={key}>
                {titles[key]?.[0] ?? key} = {writeRange(range)} {titles[key]?.[1] ?? ""}
              </li>
            ))}
            {entry.note && <li>{entry.note}</li>}
          </ul>
          <p class="field-note">{isOwn ? "Your own entry in this browser." : `${source}. They replace no tests.`}</p>
          <p class="tools">
            <button type="button" onClick={() => fill(soil, entry)}>
              Fill in what is missing
            </button>
            {isOwn && (
              <button type="button" onClick={() => store(own.value.filter((other) => other !== entry))}>
                Delete this entry
              </button>
            )}
          </p>
        </>
      )}
      <p class="tools">
        <button type="button" onClick={() => store(keep(soil, own.value))}>
          Keep “{soil}” as an own entry
        </button>
      </p>
    </details>
  );
}
