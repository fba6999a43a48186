// SPDX-License-Identifier: MIT
/** Columns of histories as the program describes them (src/output/files/history_columns.cpp). */
import type { HistoryQuantity, TableColumn } from "../../src/contract";

const known: Partial<Record<string, HistoryQuantity>> = {
  time: "time",
  step: "count",
  centre: "position",
  inflow: "water_flow",
  outflow: "water_flow",
  runoff: "water_flow",
};

const energies: Partial<Record<string, TableColumn["part"]>> = {
  kinetic_energy: "kinetic",
  elastic_energy: "elastic",
  plastic_work: "plastic",
  damping_work: "damping",
  wall_work: "walls",
  mapping_loss: "mapping",
  drag_work: "drag",
  pore_water_work: "pore_water",
  external_work: "external",
};

export function makeColumn(name: string, unit: string, values: number[]): TableColumn {
  const [, of = "", largest, base = "", component] = /^(?:(.*)\.)?(largest_)?(.*?)(?:_([xyz]))?$/.exec(name)!;
  const part = energies[base];
  const quantity = part ? "energy" : (known[base] ?? (base as HistoryQuantity));
  const extensive = /^(J|kg|kg m\/s|m3\/s)$/.test(unit);
  const column = { name, title: name, unit, values, quantity, part, of, largest: largest !== undefined, extensive };
  return component ? { ...column, component: component as "x" | "y" | "z" } : column;
}
