// SPDX-License-Identifier: MIT
/** Conditions on sides and lines, ranges and levels of the search: their forms, and how conditions are added. */
import { useSignal } from "@preact/signals";

import { deleteSelected } from "../canvas/moving";
import { addCondition } from "../document/operations";
import { type Part, sideNames } from "../document/parts";
import { findSchema } from "../forms/schema";
import { TableForm } from "../forms/TableForm";
import { schema } from "../session";
import * as state from "../state";

type ConditionKind = "boundary" | "traction" | "hydraulic";

const actions: Record<ConditionKind, string> = { boundary: "Fixity", traction: "Traction", hydraulic: "Water condition" };

/** Keys that are shown first. */
const first: Partial<Record<Part["kind"], readonly string[]>> = {
  boundary: ["on", "fix"],
  traction: ["on", "traction"],
  hydraulic: ["on", "condition", "head", "pressure", "rate"],
  roots: ["ground", "depth"],
  entry: ["entry", "exit"],
  exit: ["exit", "entry"],
  slurry: ["name", "x", "level", "unit_weight"],
  heave: ["name", "x", "level"],
  tangent: ["levels", "layer"],
  levels: ["levels"],
  circle: ["name", "centre", "radius", "ends"],
};

export function DeleteButton({ what }: { what: string }) {
  return (
    <p class="tools">
      <button type="button" onClick={deleteSelected}>
        Delete {what}
      </button>
    </p>
  );
}

export function PartPanel({ part }: { part: Part }) {
  const table = findSchema(schema.value, part.path);
  const isLost = part.on !== "" && part.line.length === 0;
  return (
    <>
      <h2>{part.title}</h2>
      {isLost && <p class="warn">There is no side or line “{part.on}”: draw a named line of this name, or choose another one.</p>}
      {table && <TableForm path={part.path} schema={table} always={first[part.kind] ?? []} />}
      <DeleteButton what={part.title.toLowerCase()} />
    </>
  );
}

function add(kind: ConditionKind, on: string): void {
  if (!state.attempt(`Add a ${actions[kind].toLowerCase()} on ${on}`, () => addCondition(state.tree.value, kind, on))) return;
  const made = state.parts.value.findLast((part) => part.kind === kind && part.on === on);
  if (made) state.selection.value = { kind: "part", id: made.id };
}

/** What acts on a named line, and buttons that add to it. */
export function LineConditions({ name }: { name: string }) {
  const acting = state.parts.value.filter(({ on }) => on === name);
  return (
    <>
      {acting.length > 0 && (
        <ul class="parts">
          {acting.map((part) => (
            <li key={part.id}>
              <button type="button" onClick={() => (state.selection.value = { kind: "part", id: part.id })}>
                {part.title}
              </button>
              <span class="muted"> {part.word.replaceAll("_", " ")}</span>
            </li>
          ))}
        </ul>
      )}
      <p class="tools">
        {(Object.keys(actions) as ConditionKind[]).map((kind) => (
          <button key={kind} type="button" onClick={() => add(kind, name)}>
            + {actions[kind]}
          </button>
        ))}
      </p>
    </>
  );
}

/** A condition on a side of the box or on a line. */
export function AddCondition() {
  const kind = useSignal<ConditionKind>("boundary");
  const on = useSignal("");
  const lines = state.chains.value.filter((chain) => chain.kind === "line").map(({ name }) => name);
  const places = [...sideNames, ...lines];
  const place = places.includes(on.value) ? on.value : "bottom";
  return (
    <form
      class="one-line"
      onSubmit={(e) => {
        e.preventDefault();
        add(kind.value, place);
      }}
    >
      <label>
        New condition
        <select value={kind.value} onChange={(e) => (kind.value = e.currentTarget.value as ConditionKind)}>
          {(Object.keys(actions) as ConditionKind[]).map((key) => (
            <option key={key} value={key}>
              {actions[key]}
            </option>
          ))}
        </select>
      </label>
      <label>
        on
        <select value={place} onChange={(e) => (on.value = e.currentTarget.value)}>
          {places.map((name) => (
            <option key={name}>{name}</option>
          ))}
        </select>
      </label>
      <button type="submit">Add</button>
    </form>
  );
}
