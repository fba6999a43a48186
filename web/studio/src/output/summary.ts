// SPDX-License-Identifier: MIT
/** What a document of the case contains: the case, factors of safety with their intervals or reasons, soils, water, loads, supports, warnings. */
import type { Report } from "../../../src/contract";
import { formatFactor, formatInterval } from "../../../src/page/format";
import { version } from "../../../package.json";
import { findNode, toPlain } from "../document/tree";
import { showUnit, titleOf } from "../forms/FieldRow";
import { type Field, findSchema, listFields } from "../forms/schema";
import type { JsonSchema } from "../engine/engine";
import { file, isChanged, schema, setting } from "../session";
import * as state from "../state";
import { findShown, showQuantity } from "../units";

export interface Table {
  head: string[];
  rows: string[][];
}

export interface Summary {
  title: string;
  facts: [name: string, value: string][];
  /** Empty without a factor; `note` gives the reason then. */
  factors: Table;
  note: string;
  soils: { name: string; table: Table }[];
  lists: { title: string; lines: string[] }[];
  warnings: string[];
  /** In the place of warnings where there are none. */
  noWarnings: string;
}

/** Values of a table of the case with their units, those of tables in it behind them. */
export function listValues(table: JsonSchema, values: Record<string, unknown>, before = ""): string[][] {
  const write = ({ key, kind, schema: own, unit }: Field): string[][] => {
    const value = values[key];
    const name = before + titleOf(key);
    if (value === undefined) return [];
    if (kind === "table" && typeof value === "object" && value !== null) return listValues(own, value as Record<string, unknown>, `${name}: `);
    if (typeof value !== "string" && typeof value !== "number" && typeof value !== "boolean") return [[name, JSON.stringify(value), showUnit(unit)]];
    const { text, converted } = showQuantity(value, unit);
    if (converted) return [[name, text, showUnit(findShown(unit)?.name ?? unit)]];
    if (typeof value === "number") return [[name, text, showUnit(unit)]];
    // "45 MPa" of the case file.
    const [number, given] = unit ? [text.replace(/\s.*$/, ""), text.replace(/^\S+\s*/, "")] : [text, ""];
    return [[name, number, showUnit(given)]];
  };
  return listFields(table, values).flatMap(write);
}

function listSoils(): Summary["soils"] {
  return state.soils.value.map((name) => {
    const values = toPlain(findNode(state.tree.value, ["materials", name]));
    const table = findSchema(schema.value, ["materials", name]);
    const rows = table && typeof values === "object" && values !== null ? listValues(table, values as Record<string, unknown>) : [];
    const used = state.regions.value.filter(({ soil }) => soil === name).map((region) => region.name);
    const others = used.filter((region) => region !== name);
    return { name: others.length ? `${name} (${others.join(", ")})` : name, table: { head: ["Property", "Value", "Unit"], rows } };
  });
}

function listParts(): Summary["lists"] {
  const found = state.section.value;
  const write = ([x, y]: readonly [number, number]) => `(${x}, ${y})`;
  const unique = (lines: string[]) => [...new Set(lines)];
  return [
    {
      title: "Water",
      lines: unique([
        ...(found?.water_tables ?? []).map(({ name, points }) => `${titleOf(name || "water table")} through ${points.map(write).join(", ")} m`),
        ...(found?.water_sides ?? []).map(({ text }) => text),
      ]),
    },
    { title: "Loads", lines: unique((found?.loads ?? []).map(({ text }) => text)) },
    { title: "Supports", lines: unique((found?.supports ?? []).map(({ name }) => name)) },
    { title: "Notes", lines: found?.notes ?? [] },
  ].filter(({ lines }) => lines.length > 0);
}

/** The newest finished run of the text as it is; null where there is none. */
async function findRun(): Promise<{ id: string; report: Report } | null> {
  const workspace = setting.value?.workspace;
  if (!workspace || !file.value || isChanged()) return null;
  const { path, revision } = file.value;
  const runs = await workspace.listRuns();
  const run = runs.find((r) => r.state === "done" && !r.is_study && r.path === path && r.revision === revision);
  if (!run) return null;
  const { data } = await workspace.readReport(run.id, "");
  const { report, results } = data as { report: Report; results: Report };
  return { id: run.id, report: { ...report, ...results } };
}

/** Factors of a run by method. */
export function listRunFactors({ answer, method_titles: titles }: Pick<Report, "answer" | "method_titles">): Table {
  const rows = answer.factors.map(({ method, title, value, lower, upper, note }) => [
    titles[method],
    title,
    formatFactor(value, lower === null && upper === null ? "none" : "–"),
    lower === null && upper === null ? "" : formatInterval({ lower, upper }),
    value === null ? note : "",
  ]);
  return { head: ["Method", "Criterion", "Factor", "Interval", "Note"], rows };
}

/** The quick search of the section as it is shown. */
function summariseSearch(): Pick<Summary, "factors" | "note" | "warnings"> & { source: string } {
  const found = state.isSolving.value ? null : state.solved.value;
  const head = ["Method", "Criterion", "Factor"];
  const rows = found?.factor ? [[found.title ?? found.method, "critical circle of the quick search", formatFactor(found.factor)]] : [];
  return {
    source: found ? `quick search of ${found.searched} circles` : "quick search",
    factors: { head, rows },
    note: rows.length ? "" : state.solveFault.value || "The quick search found no slip surface with a factor of safety.",
    warnings: state.messages.value.filter(({ severity }) => severity !== "note").map(({ text }) => text),
  };
}

export async function summarise(): Promise<Summary> {
  const run = await findRun();
  const quick = summariseSearch();
  const source = run ? `run ${run.id}` : quick.source;
  return {
    title: state.title.value || "Untitled case",
    facts: [
      ["Case file", file.value?.path ?? "not saved"],
      ["Program", `Talus ${run?.report.result.provenance.version ?? version}`],
      ["Date", new Date().toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" })],
      ["Results", source],
    ],
    factors: run ? listRunFactors(run.report) : quick.factors,
    note: run ? (run.report.answer.sentences[0] ?? "") : quick.note,
    soils: listSoils(),
    lists: listParts(),
    warnings: run ? run.report.warnings : quick.warnings,
    noWarnings: run
      ? "The run has no warnings."
      : "The quick search has no warnings. It does not compare methods, nor does limit analysis judge its factor: a run does both.",
  };
}
