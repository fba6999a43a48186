// SPDX-License-Identifier: MIT
import { expect, test } from "vitest";

import type { HydraulicCondition, Timeline } from "../contract";
import { findMoment, listLevels, listRain } from "./chosen";

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

const pool = (time: number[], values: number[]): HydraulicCondition => ({
  ...rain(time, values),
  on: "pool",
  condition: "total_head",
  series: { title: "level", unit: { name: "m", si: 1 }, time, values },
});

test("levels that change are lines from 0 to the end, with their jumps", () => {
  expect(listLevels([pool([0, 0, 86400], [9, 2, 1])], 172800)).toEqual([
    { on: "pool", unit: "m", points: [[0, 9], [0, 9], [0, 2], [86400, 1], [172800, 1]] },
  ]);
  expect(listLevels([pool([-100, 100], [4, 8])], 50)[0]!.points).toEqual([[0, 6], [50, 7]]);
  expect(listLevels([pool([0], [3])], 50)).toEqual([]);
});

test("the slider of the timeline takes the nearest time", () => {
  const timeline = { factors: [0, 10, 60, 86400].map((time) => ({ time })) } as Timeline;
  expect([0, 30, 40, 50_000].map((time) => findMoment(timeline, time))).toEqual([0, 1, 2, 3]);
});
