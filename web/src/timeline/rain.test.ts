// SPDX-License-Identifier: MIT
import { expect, test } from "vitest";

import type { HydraulicCondition } from "../contract";
import { listRain } from "./rain";

const rain = (time: number[], values: number[]): HydraulicCondition => ({
  on: "ground",
  condition: "rain",
  title: "rain",
  text: "",
  series: { title: "rate", unit: { name: "mm/h", si: 1 / 3.6e6 }, time, values },
  lines: [],
});

test("a constant rain lasts as long as the timeline", () => {
  expect(listRain([rain([0], [5])], 100)).toEqual([{ from: 0, to: 100, rate: 5 }]);
});

test("steps are bars, and nothing is drawn before, after, or of evaporation", () => {
  expect(listRain([rain([-10, 0, 0, 20, 20, 60, 60], [9, 9, 2, 2, 0, 0, -1])], 50)).toEqual([
    { from: 0, to: 20, rate: 2 },
  ]);
});

test("the strongest rain is shown, and slopes have their mean", () => {
  expect(listRain([rain([0], [1]), rain([0, 10], [0, 4])], 10)).toEqual([{ from: 0, to: 10, rate: 2 }]);
  expect(listRain([], 10)).toEqual([]);
});
