// SPDX-License-Identifier: MIT
/** The form of one table of the case: required and given keys first, the others folded. */
import { findNode, type Path, toPlain } from "../document/tree";
import type { JsonSchema } from "../engine/engine";
import * as state from "../state";
import { FieldRow } from "./FieldRow";
import { type Field, listFields } from "./schema";

interface Props {
  path: Path;
  schema: JsonSchema;
  /** Keys that are edited elsewhere. */
  without?: readonly string[];
  /** Keys that are shown though they are not given. */
  always?: readonly string[];
}

export function TableForm({ path, schema, without = [], always = [] }: Props) {
  const values = (toPlain(findNode(state.tree.value, path)) ?? {}) as Record<string, unknown>;
  const fields = listFields(schema, values).filter(({ key, kind }) => !without.includes(key) && kind !== "table");
  const isFirst = ({ key, required }: Field) => required || values[key] !== undefined || always.includes(key);
  const rank = ({ key }: Field) => (always.includes(key) ? always.indexOf(key) : always.length);
  const first = fields.filter(isFirst).toSorted((a, b) => rank(a) - rank(b));
  const others = fields.filter((field) => !isFirst(field));
  const row = (field: Field) => <FieldRow key={field.key} path={[...path, field.key]} field={field} />;
  return (
    <div class="table-form">
      {first.map(row)}
      {others.length > 0 && (
        <details>
          <summary>{first.length ? `${others.length} more keys` : `${others.length} keys, none given`}</summary>
          {others.map(row)}
        </details>
      )}
    </div>
  );
}
