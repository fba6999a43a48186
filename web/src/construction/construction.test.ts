// SPDX-License-Identifier: MIT
import { expect, test } from "vitest";

import type { ShownResult } from "../contract";
import type { Construction } from "../contract/results";
import { chooseTimeUnit, keepFurthestOfStages, listAlongSupports, listFactors, listSteps } from "./construction";

const step = (time: number, settlement: number) => ({
  time,
  length: 1,
  error: 0,
  residual: 0,
  iterations: 2,
  settlement,
  heave: 0,
  lateral: 0,
  excess: 0,
});

const stage = (name: string, from: number, to: number, factor: number | null) => ({
  name,
  from,
  to,
  added: [],
  removed: [],
  converged: true,
  reached: 1,
  start_imbalance: 0,
  rejected: 0,
  steps: [step(to, to / 10)],
  factors: [{ method: "lem", title: "LEM", factor }],
  least: factor,
  folder: "",
  error: null,
});

const construction = {
  stages: [stage("lift", 0, 10, 1.2), stage("pause", 10, 30, null)],
  monitors: [],
  least: 1.2,
  least_stage: "lift",
  elements: 1,
  unknowns: 1,
  seconds: 0,
} as unknown as Construction;

test("steps begin at the start without movement", () => {
  expect(listSteps(construction).map(({ time, settlement }) => [time, settlement])).toEqual([
    [0, 0],
    [10, 1],
    [30, 3],
  ]);
});

test("stages without a factor have no point", () => {
  expect(listFactors(construction)).toEqual([{ time: 10, stage: "lift", method: "lem", title: "LEM", factor: 1.2 }]);
});

test("the axis has hours, days or years", () => {
  expect(chooseTimeUnit(3600).name).toBe("h");
  expect(chooseTimeUnit(20 * 86400).name).toBe("day");
  expect(chooseTimeUnit(5 * 365.25 * 86400).name).toBe("year");
});

test("results at the ends of stages are those furthest from zero", () => {
  const make = (name: string, quantity: string, value: number): ShownResult => ({
    name, title: name, value, unit: { name: "m", si: 1 }, kind: "motion", quantity, by: "",
  });
  const results = [
    make("other", "settlement", 9),
    make("construction[cut].settlement", "settlement", 1),
    make("construction[cut].least_excess", "least_excess", -5),
    make("construction[fill].settlement", "settlement", 2),
    make("construction[fill].least_excess", "least_excess", -1),
  ];
  expect(keepFurthestOfStages(results).map(({ name }) => name)).toEqual([
    "other", "construction[cut].least_excess", "construction[fill].settlement",
  ]);
});

test("a wall has a curve for each stage, at the places of the last one", () => {
  const wall = (place: number[], moment: number[]) => ({ support: "sheet", row: 1, place, moment });
  const supports = [[wall([0, 2], [0, 4])], [], [wall([0, 1, 2], [0, 5, 6])]];
  const stages = construction.stages.concat(construction.stages[0]!).map((s, i) => ({ ...s, name: `stage ${i}`, supports: supports[i]! }));
  const curves = listAlongSupports({ ...construction, stages } as unknown as Construction, (s) => ({ place: s.place, value: s.moment }));
  expect(curves).toEqual([
    {
      name: "sheet",
      at: [0, 1, 2],
      curves: [
        { title: "stage 0", values: [0, 2, 4] },
        { title: "stage 2", values: [0, 5, 6] },
      ],
    },
  ]);
});
