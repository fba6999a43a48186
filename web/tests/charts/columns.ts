/** Columns of histories as the program describes them (src/output/files/history_columns.cpp). */
import type { HistoryQuantity, TableColumn } from "../../src/contract";

const known: Partial<Record<string, HistoryQuantity>> = {
  time: "time",
  step: "count",
  kinetic_energy: "energy",
  elastic_energy: "energy",
  plastic_work: "energy",
  damping_work: "energy",
  external_work: "energy",
  centre: "position",
  inflow: "water_flow",
  outflow: "water_flow",
  runoff: "water_flow",
};

export function makeColumn(name: string, unit: string, values: number[]): TableColumn {
  const [, of = "", largest, base = "", component] = /^(?:(.*)\.)?(largest_)?(.*?)(?:_([xyz]))?$/.exec(name)!;
  const quantity = known[base] ?? (base as HistoryQuantity);
  const described = { quantity, of, largest: largest !== undefined, extensive: /^(J|kg|kg m\/s|m3\/s)$/.test(unit) };
  const column = { name, title: name, unit, values, ...described };
  return component ? { ...column, component: component as "x" | "y" | "z" } : column;
}
