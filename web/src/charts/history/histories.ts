/** Which histories belong together: tables by run, columns by panel. */
import type { Column, Report, Sequence, Table } from "../../contract";
import { findEnergyBalance, takeChange } from "./energy";
import { findLargest, scaleUnit } from "../base/numbers";

/** What a panel shows; "other" for a quantity that stands alone. */
export type PanelKind =
  | "energy"
  | "force_ratio"
  | "nodal_speed"
  | "momentum"
  | "largest_pressure"
  | "water_flow"
  | "water_mass"
  | "pore_pressure"
  | "saturation"
  | "largest"
  | "displacement"
  | "stress"
  | "velocity"
  | "strain"
  | "other";

export interface Series {
  name: string;
  title: string;
  /** As drawn, in the panel's unit. */
  values: (number | null)[];
}

export interface Panel {
  id: string;
  kind: PanelKind;
  title: string;
  unit: string;
  log: boolean;
  /** Whether it is drawn before the user asks for it. */
  first: boolean;
  x: Column;
  series: Series[];
  note?: string;
}

/** Tables of one run: its history and its monitors; they share the time axis. */
export interface HistoryGroup {
  /** Id of the sequence that shows the same time: "stages", "runout_1.75". */
  sequence: string;
  title: string;
  tables: Table[];
}

function findSuffix(table: Table): string {
  return table.id.replace(/^(history|monitors)_?/, "");
}

export function groupHistories(report: Pick<Report, "tables" | "sequences">): HistoryGroup[] {
  const groups = new Map<string, HistoryGroup>();
  for (const table of report.tables) {
    if (table.kind === "ground" || table.x.values.length === 0) continue;
    const suffix = findSuffix(table);
    // Tables without a suffix run along the whole run, whose frames are the first sequence over time.
    const own = report.sequences.find((s) => s.id === suffix) ?? (suffix ? undefined : firstOverTime(report.sequences));
    const group = groups.get(suffix) ?? { sequence: own?.id ?? "", title: own?.title ?? table.title, tables: [] };
    group.tables.push(table);
    groups.set(suffix, group);
  }
  return [...groups.values()];
}

function firstOverTime(sequences: readonly Sequence[]): Sequence | undefined {
  return sequences.find((s) => s.axis === "time");
}

/** Of the whole body, not of a monitor. */
const isPressure = (name: string) => /^largest_(pore_pressure|suction)$/.test(name);
const isFlow = (name: string) => /\.(inflow|outflow|runoff)$/.test(name);
/** Flows below this share of the largest are round-off: nothing passes there. */
const leastFlow = 1e-9;

interface Kind {
  id: PanelKind;
  title: string;
  log: boolean;
  first: boolean;
  matches: (name: string) => boolean;
}

const kinds: Kind[] = [
  { id: "force_ratio", title: "Force ratio", log: true, first: true, matches: (n) => n === "force_ratio" },
  { id: "nodal_speed", title: "Nodal speed", log: true, first: true, matches: (n) => n === "nodal_speed" },
  { id: "momentum", title: "Momentum, magnitude", log: true, first: true, matches: (n) => n.startsWith("momentum") },
  // In front of what their names would match as well.
  { id: "largest_pressure", title: "Largest pore pressure and suction", log: false, first: false, matches: isPressure },
  { id: "water_flow", title: "Water through the border", log: false, first: true, matches: isFlow },
  { id: "water_mass", title: "Water in the model", log: false, first: false, matches: (n) => n === "water_mass" },
  { id: "pore_pressure", title: "Pore pressure", log: false, first: true, matches: (n) => n.endsWith(".pore_pressure") },
  { id: "saturation", title: "Degree of saturation", log: false, first: true, matches: (n) => n.endsWith(".saturation") },
  { id: "largest", title: "Largest displacement", log: false, first: false, matches: (n) => n.startsWith("largest_") },
  { id: "displacement", title: "Displacement", log: false, first: true, matches: (n) => /displacement/.test(n) },
  { id: "stress", title: "Stress", log: false, first: true, matches: (n) => /stress|pressure/.test(n) },
  { id: "velocity", title: "Velocity", log: false, first: false, matches: (n) => /velocity/.test(n) },
  { id: "strain", title: "Strain", log: false, first: false, matches: (n) => /strain/.test(n) },
];

const budgets = ["external_work", "kinetic_energy", "elastic_energy", "plastic_work", "damping_work"];

function makeEnergyPanel(table: Table): Panel | null {
  const columns = budgets.map((name) => table.columns.find((c) => c.name === name)).filter((c) => c !== undefined);
  if (columns.length === 0) return null;
  const changes = columns.map((c) => takeChange(c.values));
  const balance = findEnergyBalance(table);
  const { unit, factor } = scaleUnit(columns[0]!.unit, findLargest(changes.flat()));
  const shown = (values: (number | null)[]) => values.map((v) => (v === null ? null : v * factor));
  const series = columns.map((c, i) => ({ name: c.name, title: c.title, values: shown(changes[i]!) }));
  if (balance) series.push({ name: "residual", title: "Residual of the balance", values: shown(balance.residual) });
  const last = balance?.residual.filter((r) => r !== null).pop();
  const note =
    balance && last !== undefined && balance.work > 0 ?
      `Residual at the end: ${((100 * Math.abs(last)) / balance.work).toPrecision(2)} % of the largest external work.`
    : undefined;
  const head = { id: `${table.id}.energy`, kind: "energy" as const, title: "Energies and work", log: false, first: true };
  return { ...head, unit, x: table.x, series, note };
}

/** The panels of a table; columns of one panel have one unit. */
export function makePanels(table: Table): Panel[] {
  const energy = makeEnergyPanel(table);
  const panels: Panel[] = energy ? [energy] : [];
  const flows = table.columns.filter((c) => isFlow(c.name));
  const least = leastFlow * findLargest(flows.flatMap((c) => c.values));
  const isIdle = (column: Column) => flows.includes(column) && !(findLargest(column.values) > least);
  const rest = new Map<string, Panel>();
  for (const column of table.columns) {
    if ((energy && budgets.includes(column.name)) || isIdle(column)) continue;
    const kind = kinds.find((k) => k.matches(column.name));
    const key = kind ? `${kind.id} ${column.unit}` : `other ${column.name.replace(/_[xyz]$/, "")}`;
    let panel = rest.get(key);
    if (!panel) {
      const title = kind?.title ?? column.title.replace(/ [xyz]$/, "");
      const head = { id: `${table.id}.${key}`, kind: kind?.id ?? "other", title, unit: column.unit, x: table.x };
      rest.set(key, (panel = { ...head, log: kind?.log ?? false, first: kind?.first ?? false, series: [] }));
    }
    // "crest.displacement_x" is read as "crest, displacement x".
    const title = column.title.replace(/^([^.]+)\.(?=\D)/, "$1, ").replaceAll("_", " ");
    panel.series.push({ name: column.name, title, values: column.values });
  }
  const order = (p: Panel) => kinds.findIndex((k) => k.id === p.kind) + (p.first ? 0 : 100);
  const known = [...rest.values()].filter((p) => p.kind !== "other");
  const other = [...rest.values()].filter((p) => p.kind === "other");
  return [...panels, ...known.sort((a, b) => order(a) - order(b)), ...other];
}

/** When stages start and end [s] in the history of a whole run; `stages[].time` is the simulated time at their end. */
export function findStageSpans(stages: Report["model"]["stages"]): { name: string; start: number; end: number }[] {
  // A stage that was not reached has no time yet.
  const reached = stages.filter((s, i) => s.time > (stages[i - 1]?.time ?? 0));
  return reached.map((s, i) => ({ name: s.name, start: reached[i - 1]?.time ?? 0, end: s.time }));
}
