// SPDX-License-Identifier: MIT
/** Typical values beside the form of a soil: shown with their source, filled in where the user asks; own entries are kept and edited. */
import { useSignal } from "@preact/signals";

import { setValue, writeNumber, writeText } from "../document/edits";
import { findNode, toPlain } from "../document/tree";
import { applyInTurn } from "../document/vertices";
import { findSchema, listFields } from "../forms/schema";
import { TextInput } from "../forms/TextInput";
import { entries, type LibraryEntry, mergeEntries, own, readEntries, source } from "../library/library";
import { schema } from "../session";
import * as state from "../state";
import { findShown, formatShown, readQuantity } from "../units";

const titles: Record<string, string> = { unit_weight: "γ", saturated_unit_weight: "γ sat", cohesion: "c'", friction_angle: "φ'", undrained_strength: "s_u" };
const title = (key: string) => titles[key] ?? key.replaceAll("_", " ");
const middle = ([low, high]: readonly [number, number]) => Number(((low + high) / 2).toPrecision(4));
const plainRange = ([low, high]: readonly [number, number]) => (low === high ? String(low) : `${low} – ${high}`);

/** Units of plain numbers of the keys of a soil. */
function listUnits(): Map<string, string> {
  const table = findSchema(schema.value, ["materials", "soil"]);
  return new Map(table ? listFields(table, {}).map(({ key, unit }) => [key, unit]) : []);
}

function writeRange(range: readonly [number, number], unit: string): string {
  const shown = findShown(unit);
  const [low, high] = range.map((value) => (shown ? Number((value / shown.size).toPrecision(4)) : value)) as [number, number];
  const names: Record<string, string> = { "kN/m3": "kN/m³", deg: "°" };
  return `${plainRange([low, high])} ${shown?.name ?? names[unit] ?? unit}`;
}

const given = (soil: string) => (toPlain(findNode(state.tree.value, ["materials", soil])) ?? {}) as Record<string, unknown>;

/** Fills keys that are not given; what is given stays. */
function fill(soil: string, entry: LibraryEntry): void {
  const known = given(soil);
  const keys = Object.keys(entry.ranges).filter((key) => known[key] === undefined);
  if (!keys.length) {
    state.notice.value = { text: "All of these keys are given already.", bad: false };
    return;
  }
  const comment = (range: readonly [number, number]) => (own.value.includes(entry) ? `# of the own entry ${entry.symbol}` : `# typical of ${entry.symbol}: ${plainRange(range)}; replace by tests`);
  state.attempt(`Fill ${soil} from the library`, () =>
    applyInTurn(state.tree.value.text, [
      ...(entry.model && known.model === undefined ? [(tree: typeof state.tree.value) => setValue(tree, ["materials", soil, "model"], writeText(entry.model!))] : []),
      ...keys.map((key) => (tree: typeof state.tree.value) => {
        const value = entry.ranges[key]!;
        return setValue(tree, ["materials", soil, key], `${writeNumber(middle(value))} ${comment(value)}`);
      }),
    ]),
  );
}

/** An own entry with all numbers of a soil, in the units of plain numbers. */
function keep(soil: string): LibraryEntry {
  const units = listUnits();
  const ranges: LibraryEntry["ranges"] = {};
  for (const [key, value] of Object.entries(given(soil))) {
    const unit = units.get(key) ?? "";
    const plain = typeof value === "number" ? value : typeof value === "string" ? readQuantity(value, unit)?.value : undefined;
    if (plain !== undefined) ranges[key] = [plain, plain];
  }
  const { model } = given(soil);
  return { symbol: soil, name: "own entry", ranges, note: "", ...(typeof model === "string" ? { model } : {}) };
}

/** Name, remark and ranges of an own entry, in the units of plain numbers of the case file. */
function OwnEntry({ entry, change }: { entry: LibraryEntry; change: (after: LibraryEntry | null) => void }) {
  const units = listUnits();
  const setRange = (key: string, index: 0 | 1, typed: string) => {
    const value = Number(typed.replace("−", "-"));
    if (typed.trim() === "" || Number.isNaN(value)) return false;
    const range: [number, number] = [...entry.ranges[key]!];
    range[index] = value;
    if (range[0] > range[1]) range[1 - index] = value;
    change({ ...entry, ranges: { ...entry.ranges, [key]: range } });
    return true;
  };
  return (
    <>
      <label class="plain-field">
        Name of the entry
        <TextInput value={entry.symbol} commit={(typed) => (typed.trim() ? change({ ...entry, symbol: typed.trim() }) : false)} />
      </label>
      <label class="plain-field">
        Source or remark
        <TextInput value={entry.note} commit={(typed) => change({ ...entry, note: typed.trim() })} />
      </label>
      <table class="points">
        <caption>From and to, in the units of the case file</caption>
        <tbody>
          {Object.entries(entry.ranges).map(([key, range]) => (
            <tr key={key}>
              <th scope="row" class="wide">
                {title(key)} {units.get(key)}
              </th>
              {([0, 1] as const).map((index) => (
                <td key={index}>
                  <TextInput aria-label={`${title(key)}, ${index ? "to" : "from"}`} value={formatShown(range[index])} commit={(typed) => setRange(key, index, typed)} />
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

function download(all: readonly LibraryEntry[]): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([JSON.stringify(all, null, 2)], { type: "application/json" }));
  link.download = "talus-library.json";
  link.click();
  URL.revokeObjectURL(link.href);
}

async function read(found: File | undefined): Promise<void> {
  if (!found) return;
  let more: LibraryEntry[] = [];
  try {
    more = readEntries(JSON.parse(await found.text()));
  } catch {
    // Reported below.
  }
  if (more.length) own.value = mergeEntries(own.value, more);
  state.notice.value = more.length ? { text: `${more.length} own entries of ${found.name} are in the library.`, bad: false } : { text: `“${found.name}” is no material library of the studio.`, bad: true };
}

export function LibraryPart({ soil }: { soil: string }) {
  const chosen = useSignal("");
  const entry = [...own.value, ...entries].find(({ symbol }) => symbol === chosen.value);
  const isOwn = entry !== undefined && own.value.includes(entry);
  const units = entry ? listUnits() : new Map<string, string>();
  const change = (after: LibraryEntry | null) => {
    own.value = own.value.flatMap((other) => (other === entry ? (after ? [after] : []) : [other]));
    chosen.value = after?.symbol ?? "";
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
          {isOwn ? (
            <OwnEntry key={entry.symbol} entry={entry} change={change} />
          ) : (
            <ul class="typical">
              {Object.entries(entry.ranges).map(([key, range]) => (
                <li key={key}>
                  {title(key)} = {writeRange(range, units.get(key) ?? "")}
                </li>
              ))}
              {entry.note && <li>{entry.note}</li>}
            </ul>
          )}
          <p class="field-note">{isOwn ? "Your own entry." : `${source}. They replace no tests.`}</p>
          <p class="tools">
            <button type="button" onClick={() => fill(soil, entry)}>
              Fill in what is missing
            </button>
            {isOwn && (
              <button type="button" onClick={() => change(null)}>
                Delete this entry
              </button>
            )}
          </p>
        </>
      )}
      <p class="tools">
        <button
          type="button"
          onClick={() => {
            own.value = mergeEntries(own.value, [keep(soil)]);
            chosen.value = soil;
          }}
        >
          Keep “{soil}” as an own entry
        </button>
        {own.value.length > 0 && (
          <button type="button" onClick={() => download(own.value)}>
            Write own entries to a file
          </button>
        )}
      </p>
      <label class="plain-field">
        Read own entries from a file
        <input type="file" accept=".json,application/json" onChange={(e) => void read(e.currentTarget.files?.[0])} />
      </label>
    </details>
  );
}
