// SPDX-License-Identifier: MIT
/** Histories: tables by run, columns by panel; the balance of energy as in "Budgets" of the theory. */
import type { Column, Report, Table, TableColumn } from "../../contract";
import { findLargest, scaleUnit } from "../base/numbers";

const stores = ["kinetic", "elastic", "plastic", "damping"] as const;
/** Absent from results of 0.2.0 and earlier; drag and pore water also without pore water, supports without them. */
const laterStores = ["walls", "mapping", "drag", "pore_water", "supports"] as const;

interface EnergyBalance {
  /** external work − (kinetic + elastic + plastic + damping + walls + mapping + drag + pore water +
   * supports), as changes since the first row [J]. */
  residual: (number | null)[];
  /** Largest change of the external work [J]. */
  work: number;
}

/** The values as changes since the first row that has one. */
function takeChange(values: readonly (number | null)[]): (number | null)[] {
  const first = values.find((v) => v !== null) ?? 0;
  return values.map((v) => (v === null ? null : v - first));
}

/** Returns whether a column is external work; the others are the energies into which it is converted. */
const isWork = ({ part }: Pick<TableColumn, "part">) => part === "external";

/** null when the table lacks one of the columns. */
export function findEnergyBalance(table: { columns: Pick<TableColumn, "part" | "values">[] }): EnergyBalance | null {
  const work = table.columns.find(isWork);
  const parts = stores.map((part) => table.columns.find((c) => c.part === part));
  if (!work || parts.some((p) => !p)) return null;
  parts.push(...laterStores.map((part) => table.columns.find((c) => c.part === part)));
  const changes = parts.flatMap((p) => (p ? [takeChange(p.values)] : []));
  const done = takeChange(work.values);
  const residual = done.map((w, i) => {
    if (w === null) return null;
    let sum = w;
    for (const change of changes) {
      const part = change[i];
      if (part === null || part === undefined) return null;
      sum -= part;
    }
    return sum;
  });
  return { residual, work: Math.max(0, ...done.map((w) => Math.abs(w ?? 0))) };
}

const kinds = [
  { id: "force_ratio", title: "Force ratio", log: true, first: true },
  { id: "nodal_speed", title: "Nodal speed", log: true, first: true },
  { id: "momentum", title: "Momentum, magnitude", log: true, first: true },
  { id: "largest_pressure", title: "Largest pore pressure and suction", log: false, first: false },
  { id: "water_flow", title: "Water through the border", log: false, first: true },
  { id: "water_mass", title: "Water in the model", log: false, first: false },
  { id: "pore_pressure", title: "Pore pressure", log: false, first: true },
  { id: "saturation", title: "Degree of saturation", log: false, first: true },
  { id: "front", title: "Front", log: false, first: true },
  { id: "largest", title: "Largest displacement", log: false, first: false },
  { id: "displacement", title: "Displacement", log: false, first: true },
  { id: "stress", title: "Stress", log: false, first: true },
  { id: "velocity", title: "Velocity", log: false, first: false },
  { id: "strain", title: "Strain", log: false, first: false },
] as const;

/** Quantity of a panel; "other" for one without a group. */
type PanelKind = "energy" | "other" | (typeof kinds)[number]["id"];

interface Series {
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
  /** True for quantities per metre of thickness in plane strain. */
  extensive: boolean;
  log: boolean;
  /** True for panels that are shown at first. */
  first: boolean;
  x: Column;
  series: Series[];
  note?: string;
}

/** Tables of one run: its history and its monitors, on one time axis. */
export interface HistoryGroup {
  /** Id of the sequence that shows the same time: "stages", "runout_1.75". */
  sequence: string;
  title: string;
  tables: Table[];
}

export function groupHistories(report: Pick<Report, "tables" | "sequences">): HistoryGroup[] {
  const groups = new Map<string, HistoryGroup>();
  for (const table of report.tables) {
    if (table.kind === "ground" || table.x.values.length === 0) continue;
    const own = report.sequences.find((s) => s.id === table.sequence);
    const fresh = { sequence: own?.id ?? "", title: own?.title ?? table.title, tables: [] };
    const group = groups.get(table.sequence) ?? fresh;
    group.tables.push(table);
    groups.set(table.sequence, group);
  }
  return [...groups.values()];
}

/** Flows below this fraction of the largest are round-off. */
const leastFlow = 1e-9;


function findKind({ quantity, largest }: TableColumn) {
  const whole = quantity === "displacement" ? "largest" : "largest_pressure";
  return kinds.find((k) => k.id === (largest ? whole : quantity));
}

function makeEnergyPanel(table: Table): Panel | null {
  const parts = table.columns.filter((c) => c.quantity === "energy");
  if (parts.length === 0) return null;
  // External work comes first.
  const columns = [...parts.filter(isWork), ...parts.filter((c) => !isWork(c))];
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
  return { ...head, unit, extensive: true, x: table.x, series, note };
}

/** The panels of a table; columns of one panel have one unit. */
export function makePanels(table: Table): Panel[] {
  const energy = makeEnergyPanel(table);
  const panels: Panel[] = energy ? [energy] : [];
  const flows = table.columns.filter((c) => c.quantity === "water_flow");
  const least = leastFlow * findLargest(flows.flatMap((c) => c.values));
  const isIdle = (column: TableColumn) => flows.includes(column) && !(findLargest(column.values) > least);
  const rest = new Map<string, Panel>();
  for (const column of table.columns) {
    if (column.quantity === "energy" || isIdle(column)) continue;
    const kind = findKind(column);
    // Components of one vector are adjacent: "centre_x" and "centre_y".
    const whole = (text: string) => (column.component ? text.slice(0, -2) : text);
    const key = kind ? `${kind.id} ${column.unit}` : `other ${whole(column.name)}`;
    let panel = rest.get(key);
    if (!panel) {
      const { unit, extensive } = column;
      const title = kind?.title ?? whole(column.title);
      const shown = kind ?? { id: "other" as const, log: false, first: false };
      const head = { ...shown, id: `${table.id}.${key}`, kind: shown.id };
      panel = { ...head, title, unit, extensive, x: table.x, series: [] } satisfies Panel;
      rest.set(key, panel);
    }
    panel.series.push({ name: column.name, title: column.title, values: column.values });
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
