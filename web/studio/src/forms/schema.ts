// SPDX-License-Identifier: MIT
/** Reads `talus schema` for forms: kind, unit, usual range, default, meaning of a key, and which keys belong to the present values. */
import type { Path } from "../document/tree";
import type { JsonSchema } from "../engine/engine";

export type FieldKind = "choice" | "flag" | "number" | "quantity" | "whole" | "text" | "list" | "table";

export interface Field {
  key: string;
  kind: FieldKind;
  schema: JsonSchema;
  /** Of plain numbers; empty for none. */
  unit: string;
  /** "10 to 28 kN/m3"; empty where none is documented. */
  usual: string;
  meaning: string;
  /** Meaning of each choice. */
  choices: { value: string; meaning: string }[];
  default: string;
  required: boolean;
}

/** Whether a value satisfies the parts of JSON Schema in which `talus schema` writes its conditions. */
export function satisfies(value: unknown, schema: JsonSchema): boolean {
  if (schema.const !== undefined && value !== schema.const) return false;
  if (schema.anyOf && !schema.anyOf.some((part) => satisfies(value, part))) return false;
  const entries = typeof value === "object" && value !== null && !Array.isArray(value) ? (value as Record<string, unknown>) : {};
  if (schema.required?.some((key) => entries[key] === undefined)) return false;
  return Object.entries(schema.properties ?? {}).every(([key, part]) => entries[key] === undefined || satisfies(entries[key], part));
}

/** Keys that a table needs with its present values. */
export function listRequired(schema: JsonSchema, value: unknown): Set<string> {
  const required = new Set(schema.required ?? []);
  for (const part of schema.allOf ?? [])
    if (part.if && part.then && satisfies(value, part.if)) part.then.required?.forEach((key) => required.add(key));
  return required;
}

/** `Only where model = "a" or "b"`: whether it holds; true for other conditions. */
export function isRelevant(description: string, values: Record<string, unknown>): boolean {
  const found = /Only where (\w+) = (".+?"(?: or ".+?")*)/.exec(description);
  if (!found) return true;
  const allowed = [...found[2]!.matchAll(/"(.+?)"/g)].map((match) => match[1]);
  return allowed.includes(String(values[found[1]!] ?? ""));
}

function findKind(schema: JsonSchema): FieldKind {
  if (schema.enum) return "choice";
  if (schema.type === "boolean") return "flag";
  if (schema.type === "integer") return "whole";
  if (schema.type === "number") return "number";
  if (schema.type === "string") return "text";
  if (schema.type === "array") return "list";
  if (schema.type === "object" || schema.properties) return "table";
  if (schema.anyOf?.some((part) => part.type === "number")) return "quantity";
  return "list";
}

const take = (text: string, pattern: RegExp) => pattern.exec(text)?.[1] ?? "";

/** Splits a description: sentence by sentence, "word: meaning." belongs to the choices. */
function splitMeaning(schema: JsonSchema): { meaning: string; choices: Field["choices"] } {
  let meaning = (schema.description ?? "")
    .replace(/ ?Unit of plain numbers: .+?\.(?= |$)/, "")
    .replace(/ ?Usually .+?\.(?= |$)/, "")
    .replace(/ ?Only where .+?\.(?= |$)/, "");
  const names = (schema.enum ?? []).map(String);
  const places = names
    .map((name) => ({ name, at: new RegExp(`(?:^|\\. )${name}: `).exec(meaning) }))
    .filter(({ at }) => at)
    .map(({ name, at }) => ({ name, from: at!.index, start: at!.index + at![0].length }))
    .sort((a, b) => a.from - b.from);
  const described = new Map(places.map(({ name, start }, i) => [name, meaning.slice(start, places[i + 1]?.from).replace(/\.$/, "")]));
  if (places[0]) meaning = meaning.slice(0, places[0].from).replace(/([^.])$/, "$1.");
  return { meaning: meaning.trim(), choices: names.map((value) => ({ value, meaning: described.get(value) ?? "" })) };
}

const writeDefault = (value: unknown) =>
  value === undefined || value === "" || (Array.isArray(value) && value.length === 0) ? "" : Array.isArray(value) ? value.join(", ") : String(value);

/** The fields of a table that belong to its present values; required ones first, then in the order of the schema. */
export function listFields(schema: JsonSchema, values: Record<string, unknown>): Field[] {
  const required = listRequired(schema, values);
  const fields = Object.entries(schema.properties ?? {})
    .filter(([key, part]) => values[key] !== undefined || isRelevant(part.description ?? "", values))
    .map(([key, part]): Field => {
      const text = part.description ?? "";
      return {
        key,
        kind: findKind(part),
        schema: part,
        unit: take(text, /Unit of plain numbers: (.+?)\.(?= |$)/),
        usual: take(text, /Usually (.+?)\.(?= |$)/),
        default: writeDefault(part.default),
        required: required.has(key),
        ...splitMeaning(part),
      };
    });
  return fields.toSorted((a, b) => Number(b.required) - Number(a.required));
}

/** Why a typed value does not fit; empty where it does. Texts with units are left to the checker. */
export function checkTyped(field: Field, typed: string): string {
  if (typed === "" || !["number", "quantity", "whole"].includes(field.kind)) return "";
  const number = Number(typed.replace("−", "-"));
  if (Number.isNaN(number)) {
    if (field.kind === "quantity" && /^[+-]?[\d.]+(?:[eE][+-]?\d+)?\s*[^\s\d,]/.test(typed)) return "";
    return /^\d+,\d+$/.test(typed) ? "Write a decimal point, not a comma." : `“${typed}” is not a number${field.kind === "quantity" ? " or a number with a unit" : ""}.`;
  }
  if (field.kind === "whole" && !Number.isInteger(number)) return "A whole number is needed.";
  const limits = field.schema.anyOf?.find((part) => part.type === "number") ?? field.schema;
  if (limits.minimum !== undefined && number < limits.minimum) return `At least ${limits.minimum}.`;
  if (limits.exclusiveMinimum !== undefined && number <= limits.exclusiveMinimum) return `More than ${limits.exclusiveMinimum}.`;
  if (limits.maximum !== undefined && number > limits.maximum) return `At most ${limits.maximum}.`;
  if (limits.exclusiveMaximum !== undefined && number >= limits.exclusiveMaximum) return `Less than ${limits.exclusiveMaximum}.`;
  return "";
}

/** A typed value as TOML: numbers plain, everything else as text. */
export function writeTyped(field: Field, typed: string): string {
  const clean = typed.trim().replace("−", "-");
  if (field.kind === "flag") return clean;
  if (field.kind === "list" || field.kind === "table") return clean;
  const number = ["number", "quantity", "whole"].includes(field.kind) && clean !== "" && !Number.isNaN(Number(clean));
  return number ? clean.replace(/^\+/, "").replace(/^(-?)\./, "$10.").replace(/\.$/, "") : JSON.stringify(clean);
}

/** The schema of a table at a path: names of materials and supports, and places in lists, are skipped. */
export function findSchema(root: JsonSchema | null, path: Path): JsonSchema | null {
  let at = root;
  for (const step of path) {
    if (!at) return null;
    if (typeof step === "number") at = at.items ?? null;
    else at = at.properties?.[step] ?? (typeof at.additionalProperties === "object" ? at.additionalProperties : null);
  }
  return at;
}
