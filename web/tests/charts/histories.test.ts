// SPDX-License-Identifier: MIT
/** Histories and soil water: groups, panels, energy balance, curves. */
import { describe, expect, it, test } from "vitest";

import { findEnergyBalance, findStageSpans, groupHistories, makePanels } from "../../src/charts/history/histories";
import { chooseTimeUnit, findChanging, makeCurves } from "../../src/charts/water/SoilWaterSection";
import type { HistoryQuantity, HydraulicCondition, Report, SoilWater, Table, TableColumn } from "../../src/contract";

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
  support_work: "supports",
  external_work: "external",
};

function makeColumn(name: string, unit: string, values: number[]): TableColumn {
  const [, of = "", largest, base = "", component] = /^(?:(.*)\.)?(largest_)?(.*?)(?:_([xyz]))?$/.exec(name)!;
  const part = energies[base];
  const quantity = part ? "energy" : (known[base] ?? (base as HistoryQuantity));
  const extensive = /^(J|kg|kg m\/s|m3\/s)$/.test(unit);
  const column = { name, title: name, unit, values, quantity, part, of, largest: largest !== undefined, extensive };
  return component ? { ...column, component: component as "x" | "y" | "z" } : column;
}

const column = (part: TableColumn["part"], values: (number | null)[]) => ({ part, values });
const clock = Array.from({ length: 50 }, (_, i) => i * 0.02);

/** A weight m on a spring k, released from rest: x = (mg/k)(1 - cos ωt), whose energies are known in closed form. */
function makeOscillator(lost: number) {
  const [m, k, g] = [2, 300, 9.81];
  const omega = Math.sqrt(k / m);
  const x = clock.map((t) => ((m * g) / k) * (1 - Math.cos(omega * t)));
  const v = clock.map((t) => ((m * g) / k) * omega * Math.sin(omega * t));
  return {
    columns: [
      column("external", x.map((s) => 1000 + m * g * s)),
      column("kinetic", v.map((s) => 0.5 * m * s * s)),
      column("elastic", x.map((s) => 400 + 0.5 * k * s * s)),
      column("plastic", clock.map(() => 70)),
      column("damping", clock.map((t) => 30 - lost * t)),
    ],
  };
}

test("a weight on a spring keeps its energy, whatever the budgets were before", () => {
  const { residual, work } = findEnergyBalance(makeOscillator(0))!;
  for (const r of residual) expect(Math.abs(r!)).toBeLessThan(1e-12 * 1000);
  // The weight sinks by 2mg/k at most.
  expect(work).toBeCloseTo((2 * (2 * 9.81) ** 2) / 300, 1);
});

test("damping that is missing from its column appears as residual, with its sign", () => {
  const { residual } = findEnergyBalance(makeOscillator(5))!;
  residual.forEach((r, i) => expect(r).toBeCloseTo(5 * clock[i]!, 9));
});

test("what walls take and what is lost between points and nodes belong to the balance", () => {
  const table = makeOscillator(5);
  table.columns.push(column("walls", clock.map((t) => 3 * t)), column("mapping", clock.map((t) => 7 + 2 * t)));
  findEnergyBalance(table)!.residual.forEach((r) => expect(Math.abs(r!)).toBeLessThan(1e-9));
});

test("no balance without all columns, none in a row with a gap", () => {
  const table = makeOscillator(0);
  expect(findEnergyBalance({ columns: table.columns.slice(0, 4) })).toBeNull();
  table.columns[2]!.values[7] = null;
  const { residual } = findEnergyBalance(table)!;
  expect(residual[7]).toBeNull();
  expect(residual[8]).not.toBeNull();
});

const names: [string, string][] = [
  ["step", "-"], ["kinetic_energy", "J"], ["potential_energy", "J"], ["elastic_energy", "J"], ["plastic_work", "J"],
  ["damping_work", "J"], ["external_work", "J"], ["force_ratio", "-"], ["nodal_speed", "m/s"], ["mass", "kg"],
  ["momentum_x", "kg m/s"], ["momentum_y", "kg m/s"], ["centre_x", "m"], ["largest_displacement", "mm"],
];
const makeTable = (id: string, columns: [string, string][], kind: Table["kind"] = "history"): Table => ({
  id,
  title: id,
  kind,
  sequence: id.includes("runout_1.75") ? "runout_1.75" : "stages",
  x: makeColumn("time", "s", [0, 1]),
  columns: columns.map(([name, unit], i) => makeColumn(name, unit, [10 * i, 1000 + 10 * i])),
});
const sequence = (id: string, axis: "time" | "factor") => ({ id, title: id, axis }) as Report["sequences"][number];

test("tables of a run stand together, with the frames of their time", () => {
  const tables = [
    makeTable("history", names),
    makeTable("monitors", [["crest.displacement_x", "mm"]], "monitors"),
    makeTable("history_runout_1.75", names),
    makeTable("profile_runout_1.75", names, "ground"),
  ];
  const sequences = [sequence("curve", "factor"), sequence("stages", "time"), sequence("runout_1.75", "time")];
  const groups = groupHistories({ tables, sequences });
  expect(groups.map((g) => [g.sequence, ...g.tables.map((t) => t.id)])).toEqual([
    ["stages", "history", "monitors"],
    ["runout_1.75", "history_runout_1.75"],
  ]);
  // Without frames of its time a history moves no viewer.
  expect(groupHistories({ tables: [tables[2]!], sequences: [sequences[1]!] })[0]!.sequence).toBe("");
});

test("every column is in one panel, and a panel has one unit", () => {
  const table = makeTable("history", names);
  const panels = makePanels(table);
  const drawn = panels.flatMap((p) => p.series.map((s) => s.name)).filter((n) => n !== "residual");
  expect(drawn.sort()).toEqual(names.map(([n]) => n).sort());
  for (const panel of panels.slice(1))
    for (const s of panel.series) expect(names.find(([n]) => n === s.name)![1]).toBe(panel.unit);
});

test("energies are changes since the first row, in a unit for people, beside their residual", () => {
  const energy = makePanels(makeTable("history", names))[0]!;
  expect(energy.unit).toBe("kJ");
  for (const s of energy.series.filter((x) => x.name !== "residual")) expect(s.values).toEqual([0, 1]);
  // 1 kJ goes in and four kJ come out: three too many.
  expect(energy.series.find((s) => s.name === "residual")!.values[1]).toBeCloseTo(-3, 12);
  expect(energy.note).toContain("%");
});

test("stages follow each other, and one that was not reached has no place", () => {
  const stage = { text: "", end: "rest", steps: 1, wall: 1 };
  const times = [2, 20, 0];
  const spans = findStageSpans(["a", "b", "c"].map((name, i) => ({ ...stage, name, time: times[i]! })));
  expect(spans).toEqual([{ name: "a", start: 0, end: 2 }, { name: "b", start: 2, end: 20 }]);
});

describe("histories of water", () => {
  const table: Table = {
    id: "history",
    title: "History",
    kind: "history",
    sequence: "stages",
    x: makeColumn("time", "s", [0, 1, 2]),
    columns: [
      makeColumn("largest_displacement", "mm", [0, 1, 2]),
      makeColumn("largest_pore_pressure", "kPa", [95, 96, 95]),
      makeColumn("largest_suction", "kPa", [58, 58, 58]),
      makeColumn("water_mass", "kg", [10, 11, 12]),
      makeColumn("left.inflow", "m3/s", [0, 1e-3, 1e-3]),
      makeColumn("crest.runoff", "m3/s", [0, 2e-5, 0]),
      makeColumn("toe.inflow", "m3/s", [0, 1e-19, 3e-20]),
      makeColumn("face.outflow", "m3/s", [0, 0, 0]),
      makeColumn("foot.pore_pressure", "kPa", [2, 3, 4]),
    ],
  };
  const panels = makePanels(table);
  const find = (title: string) => panels.find((p) => p.title === title)?.series.map((s) => s.name);

  it("do not put suction under displacements, nor monitors under the whole body", () => {
    expect(find("Largest displacement")).toEqual(["largest_displacement"]);
    expect(find("Largest pore pressure and suction")).toEqual(["largest_pore_pressure", "largest_suction"]);
    expect(find("Pore pressure")).toEqual(["foot.pore_pressure"]);
    expect(find("Stress")).toBeUndefined();
  });

  it("draw the flows together, without those that are round-off", () => {
    expect(find("Water through the border")).toEqual(["left.inflow", "crest.runoff"]);
  });
});

describe("curves of soil water", () => {
  const make = (conductivity: number[]): SoilWater => ({
    retention: "van Genuchten",
    conductivity: "Mualem",
    chi: "χ = S",
    parameters: [],
    curves: { suction: [1e2, 1e3, 1e4], saturation: [1, 0.8, 0.4], conductivity, largest_suction: null },
  });

  it("have an axis of whole powers of ten that does not follow k into nothing", () => {
    const [s, k] = makeCurves(make([1e-4, 3e-7, 1e-30]), { name: "m/s", si: 1 });
    expect(s!.domain).toEqual([0, 1]);
    expect(k!.domain[0]).toBeGreaterThanOrEqual(1e-14);
    expect(k!.domain[1]).toBe(1e-3);
    expect(Number.isInteger(Math.round(Math.log10(k!.domain[0]) * 1e9) / 1e9)).toBe(true);
  });

  it("leave out a conductivity that is not known", () => {
    expect(makeCurves(make([]), { name: "m/s", si: 1 })).toHaveLength(1);
  });
});

it("draws only what changes with time, in a unit that suits the span", () => {
  const condition = (values: number[]) => ({ series: { values } }) as unknown as HydraulicCondition;
  expect(findChanging([condition([5]), condition([3, 3]), condition([0, 20, 0])])).toHaveLength(1);
  expect([2, 1000, 5 * 3600, 9 * 86400].map((span) => chooseTimeUnit(span).name)).toEqual(["s", "min", "h", "d"]);
});
