// SPDX-License-Identifier: MIT
/** The soils of the case with their forms, and the library of typical values. */
import { useSignal } from "@preact/signals";

import { findSoilColour } from "../canvas/layers";
import { applyEdits, removeAt } from "../document/edits";
import { addMaterial } from "../document/operations";
import { makeFieldId } from "../forms/FieldRow";
import { findSchema } from "../forms/schema";
import { TableForm } from "../forms/TableForm";
import { schema } from "../session";
import * as state from "../state";
import { LibraryPart } from "./LibraryPart";

const usual = ["model", "unit_weight", "saturated_unit_weight", "cohesion", "friction_angle", "undrained_strength"];

/** Keys that a form shows first: those that the model has. */
function listUsual(table: { properties?: Record<string, { description?: string }> }, model: string): string[] {
  return usual.filter((key) => {
    const text = table.properties?.[key]?.description ?? "";
    return !/Only where model/.test(text) || text.includes(`"${model}"`);
  });
}

function SoilPart({ name }: { name: string }) {
  const table = findSchema(schema.value, ["materials", name]);
  const materials = state.tree.value.root.entries.get("materials")?.node;
  const own = materials?.kind === "table" ? materials.entries.get(name)?.node : undefined;
  const model = own?.kind === "table" ? own.entries.get("model")?.node : undefined;
  const law = model?.kind === "value" ? String(model.value) : "";
  const used = state.regions.value.filter(({ soil }) => soil === name).map((region) => region.name);
  const faults = state.messages.value.filter(({ key, severity }) => key.startsWith(`materials.${name}`) && severity === "error").length;
  return (
    <details class="soil" open={state.soils.value.length < 3 || faults > 0}>
      <summary>
        <span class="swatch" style={{ background: findSoilColour(name) }} />
        <b>{name}</b>
        <span class="muted"> {used.length ? used.join(", ") : "not used"}</span>
        {faults > 0 && <span class="bad"> · {faults} {faults === 1 ? "error" : "errors"}</span>}
      </summary>
      {table && <TableForm path={["materials", name]} schema={table} always={listUsual(table, law)} />}
      <LibraryPart soil={name} />
      {used.length === 0 && (
        <p class="tools">
          <button type="button" onClick={() => void state.attempt(`Delete the soil ${name}`, () => applyEdits(state.tree.value.text, removeAt(state.tree.value, ["materials", name])))}>
            Delete {name}
          </button>
        </p>
      )}
    </details>
  );
}

export function SoilsPanel() {
  const wanted = useSignal("");
  const missing = [...new Set(state.regions.value.map(({ soil }) => soil))].filter((soil) => soil && !state.soils.value.includes(soil));
  const add = (name: string) => {
    if (!name.trim()) return;
    let made = "";
    const done = state.attempt(`Add the soil ${name.trim()}`, () => {
      const added = addMaterial(state.tree.value, name.trim());
      made = added.name;
      return added.text;
    });
    if (!done) return;
    wanted.value = "";
    setTimeout(() => document.getElementById(makeFieldId(["materials", made, "model"]))?.focus());
  };
  return (
    <>
      <h2>Soils</h2>
      {missing.map((name) => (
        <p key={name} class="question">
          “{name}” is used and not described.
          <button type="button" onClick={() => add(name)}>
            Describe {name}
          </button>
        </p>
      ))}
      {state.soils.value.map((name) => (
        <SoilPart key={name} name={name} />
      ))}
      <form
        class="one-line"
        onSubmit={(e) => {
          e.preventDefault();
          add(wanted.value);
        }}
      >
        <label>
          New soil
          <input value={wanted.value} onInput={(e) => (wanted.value = e.currentTarget.value)} placeholder="name" />
        </label>
        <button type="submit" disabled={!wanted.value.trim()}>
          Add
        </button>
      </form>
    </>
  );
}
