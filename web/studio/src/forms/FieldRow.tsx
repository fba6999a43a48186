// SPDX-License-Identifier: MIT
/** One key of a form: name, value, unit, usual range, default, meaning, and the messages about it. */
import { useSignal } from "@preact/signals";

import { applyEdits, removeAt, setValue } from "../document/edits";
import { findNode, type Path, readTree, writePath } from "../document/tree";
import * as state from "../state";
import { findShown, readQuantity, showQuantity, showRange, writeQuantity } from "../units";
import { pasteWhole, RowsField } from "./RowsField";
import { countColumns, readRows } from "./rows";
import { checkTyped, type Field, writeTyped } from "./schema";
import { TextInput } from "./TextInput";

/** The value as it is typed: a text without its quotes, everything else as written. */
export function readTyped(path: Path): string {
  const node = findNode(state.tree.value, path);
  if (!node) return "";
  if (node.kind === "value") return String(node.value);
  return state.tree.value.text.slice(...node.range);
}

/** Writes a typed value at a path; an empty one removes the key. */
export function writeField(path: Path, field: Field, typed: string): boolean {
  const name = `${typed === "" ? "Remove" : "Set"} ${writePath(path)}`;
  return state.attempt(name, () => {
    const tree = state.tree.value;
    if (typed === "") return applyEdits(tree.text, removeAt(tree, path));
    return applyEdits(tree.text, setValue(tree, path, writeTyped(field, typed)));
  });
}

/** "unit_weight" as "Unit weight". */
export const titleOf = (key: string): string => key.replaceAll("_", " ").replace(/^./, (c) => c.toUpperCase());

const units: Record<string, string> = { "kN/m3": "kN/m³", "kg/m3": "kg/m³", deg: "°", m2: "m²", "-": "", "1": "" };
export const showUnit = (unit: string): string => units[unit] ?? unit;

export const makeFieldId = (path: Path): string => `field-${writePath(path).replace(/[^\w-]/g, "-")}`;

function findFault(field: Field, typed: string): string {
  if ((field.kind === "list" || field.kind === "table") && typed !== "" && readTree(`a = ${typed.replaceAll("\n", " ")}`).fault)
    return "This is not a list of TOML, such as [1, 2].";
  return checkTyped(field, typed);
}

function describeEmpty(field: Field): string {
  if (field.default !== "") return `default ${Number.isNaN(Number(field.default)) ? field.default : showQuantity(Number(field.default), field.unit).text}`;
  return field.required ? "required" : "not given";
}

/** Names in backticks as code. */
function Marked({ text }: { text: string }) {
  return <>{text.split("`").map((part, i) => (i % 2 ? <code key={i}>{part}</code> : part))}</>;
}

/** The value of a key in the unit of display, and how a typed one is written in the file. */
function useUnits(path: Path, field: Field) {
  const node = findNode(state.tree.value, path);
  const before = node?.kind === "value" ? node.value : null;
  const isNumber = field.kind === "quantity" || field.kind === "number";
  const shown = isNumber && (!node || before !== null) ? findShown(field.unit) : null;
  const typed = readTyped(path);
  if (!shown) return { typed, unit: typeof before === "string" && isNumber && readQuantity(before, field.unit) ? "" : field.unit, write: (text: string) => text, check: (text: string) => text };
  const now = before === null ? { text: "", converted: true } : showQuantity(before, field.unit);
  return {
    typed: now.text,
    unit: now.converted ? shown.name : "",
    write: (text: string) => writeQuantity(text, field.unit, before, field.kind === "quantity"),
    /** In the unit of plain numbers, for the limits of the schema. */
    check: (text: string) => writeQuantity(text, field.unit, 0, false),
  };
}

export function FieldRow({ path, field }: { path: Path; field: Field }) {
  const id = makeFieldId(path);
  const fault = useSignal("");
  const { typed, unit, write, check } = useUnits(path, field);
  const key = writePath(path);
  const messages = state.messages.value.filter((message) => message.key === key);
  const commit = (value: string) => {
    const clean = value.trim();
    fault.value = findFault(field, check(clean));
    if (fault.value !== "") return false;
    return clean === typed || writeField(path, field, write(clean));
  };
  const isBad = fault.value !== "" || messages.some(({ severity }) => severity === "error");
  const noteId = `${id}-note`;
  const shared = { id, "aria-describedby": noteId, "aria-invalid": isBad };
  const columns = countColumns(field);
  const rows = columns > 0 ? readRows(state.tree.value, path) : null;
  const missing = field.required && typed === "";
  return (
    <div class={`field${isBad ? " bad-field" : ""}${missing ? " missing" : ""}`}>
      {rows ? <span class="label" title={field.key}>{titleOf(field.key)}{unit && ` [${showUnit(unit)}]`}</span> : <label for={id} title={field.key}>
        {titleOf(field.key)}
        {field.required && <span class="mark" title="required"> *</span>}
      </label>}
      {field.kind === "choice" ? (
        <select {...shared} value={typed} onChange={(e) => void commit(e.currentTarget.value)}>
          <option value="">{describeEmpty(field)}</option>
          {field.choices.map(({ value }) => (
            <option key={value} value={value}>
              {value.replaceAll("_", " ")}
            </option>
          ))}
        </select>
      ) : field.kind === "flag" ? (
        <select {...shared} value={typed} onChange={(e) => void commit(e.currentTarget.value)}>
          <option value="">{describeEmpty(field)}</option>
          <option value="true">true</option>
          <option value="false">false</option>
        </select>
      ) : rows ? (
        <RowsField path={path} rows={rows} id={id} noteId={noteId} label={titleOf(field.key)} />
      ) : (
        <span class="input-with-unit" onPaste={(e) => columns > 0 && pasteWhole(e, path, columns as 1 | 2)}>
          <TextInput
            {...shared}
            value={typed}
            placeholder={describeEmpty(field)}
            inputMode={field.kind === "number" || field.kind === "whole" ? "decimal" : undefined}
            commit={commit}
          />
          {unit && <span class="unit">{showUnit(unit)}</span>}
        </span>
      )}
      <p class="field-note" id={noteId}>
        {fault.value && <span class="bad">{fault.value} </span>}
        {messages.map(({ text, severity }) => (
          <span key={text} class={severity === "error" ? "bad" : "warn"}>
            {text}{" "}
          </span>
        ))}
        <Marked text={(field.kind === "choice" && field.choices.find(({ value }) => value === typed)?.meaning) || field.meaning} />
        {field.usual && <span class="usual"> Usually {showRange(field.usual, field.unit)}.</span>}
      </p>
    </div>
  );
}
