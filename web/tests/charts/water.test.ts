// SPDX-License-Identifier: MIT
/** Charts of soil water, and the water in the histories. */
import { describe, expect, it } from "vitest";

import { makeColumn } from "./columns";
import { makePanels } from "../../src/charts/history/histories";
import { chooseTimeUnit, findChanging, makeCurves } from "../../src/charts/water/SoilWaterSection";
import type { HydraulicCondition, SoilWater, Table } from "../../src/contract";

const column = makeColumn;

describe("histories of water", () => {
  const table: Table = {
    id: "history",
    title: "History",
    kind: "history",
    sequence: "stages",
    x: column("time", "s", [0, 1, 2]),
    columns: [
      column("largest_displacement", "mm", [0, 1, 2]),
      column("largest_pore_pressure", "kPa", [95, 96, 95]),
      column("largest_suction", "kPa", [58, 58, 58]),
      column("water_mass", "kg", [10, 11, 12]),
      column("left.inflow", "m3/s", [0, 1e-3, 1e-3]),
      column("crest.runoff", "m3/s", [0, 2e-5, 0]),
      column("toe.inflow", "m3/s", [0, 1e-19, 3e-20]),
      column("face.outflow", "m3/s", [0, 0, 0]),
      column("foot.pore_pressure", "kPa", [2, 3, 4]),
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
