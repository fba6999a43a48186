// SPDX-License-Identifier: MIT
/** The water in the section: the line of zero pressure, values of conditions at a time, the area below a level. */
import { describe, expect, it } from "vitest";

import type { HydraulicCondition } from "../contract";
import { chooseColourMap, tabulateColours } from "./colours";
import { clipBelow, evaluateSeries } from "./symbols";
import { findWaterTable } from "./tracedLines";

const spacing = 0.5;

/** Points of a box of 20 m by 10 m, each moved a little, with the pressure under a water table [Pa]. */
function makeBox(table: (x: number) => number, block = 0) {
  const at: number[] = [];
  let seed = 1;
  const draw = () => ((seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5) * 0.4 * spacing;
  for (let x = spacing / 2; x < 20; x += spacing)
    for (let y = spacing / 2; y < 10; y += spacing) at.push(x + draw(), y + draw());
  const positions = Float32Array.from(at);
  // As in full elements, points of one block have the pressure of its centre.
  const middle = (v: number) => (block ? (Math.floor(v / block) + 0.5) * block : v);
  const pressure = Float32Array.from({ length: at.length / 2 }, (_, i) => {
    const [x, y] = [middle(at[2 * i]!), middle(at[2 * i + 1]!)];
    return 9810 * (table(x) - y);
  });
  return { positions, pressure };
}

describe("water table", () => {
  const table = (x: number) => 7 - 0.15 * x;

  it("is the line of zero pressure, through the whole section", () => {
    const { positions, pressure } = makeBox(table);
    const lines = findWaterTable(positions, pressure, () => true, spacing);
    expect(lines).toHaveLength(1);
    const xs = lines[0]!.map((p) => p[0]);
    expect(Math.max(...xs) - Math.min(...xs)).toBeGreaterThan(19);
    for (const [x, y] of lines[0]!) expect(Math.abs(y - table(x))).toBeLessThan(0.15 * spacing);
  });

  it("stays within a point's distance where points have the pressure of their element", () => {
    const { positions, pressure } = makeBox(table, 1);
    const lines = findWaterTable(positions, pressure, () => true, spacing);
    expect(lines).toHaveLength(1);
    for (const [x, y] of lines[0]!) expect(Math.abs(y - table(x))).toBeLessThan(1.2 * spacing);
  });

  it("does not enter dry soil, nor soil that is not there", () => {
    const { positions, pressure } = makeBox(table);
    const lines = findWaterTable(positions, pressure, (i) => positions[2 * i]! < 10, spacing);
    expect(Math.max(...lines.flat().map((p) => p[0]))).toBeLessThan(10.5);
    const gone = pressure.map((p, i) => (positions[2 * i]! < 10 ? p : Number.NaN));
    const rest = findWaterTable(positions, gone, () => true, spacing);
    expect(Math.max(...rest.flat().map((p) => p[0]))).toBeLessThan(10.5);
  });

  it("is a closed line around perched water, and none without any pressure", () => {
    const { positions, pressure } = makeBox(() => 5);
    const perched = pressure.map((_, i) => 5000 * (3 - Math.hypot(positions[2 * i]! - 10, positions[2 * i + 1]! - 5)));
    const [ring, ...others] = findWaterTable(positions, perched, () => true, spacing);
    expect(others).toEqual([]);
    for (const [x, y] of ring!) expect(Math.abs(Math.hypot(x - 10, y - 5) - 3)).toBeLessThan(0.3 * spacing);
    expect(Math.hypot(ring![0]![0] - ring!.at(-1)![0], ring![0]![1] - ring!.at(-1)![1])).toBeLessThan(2 * spacing);
    expect(findWaterTable(positions, pressure.map(() => 1e-9), () => true, spacing)).toEqual([]);
    expect(findWaterTable(positions, pressure.map(() => -4e4), () => true, spacing)).toEqual([]);
  });
});

describe("hydraulic conditions", () => {
  const make = (time: number[], values: number[]): HydraulicCondition => ({
    on: "crest",
    condition: "rain",
    title: "rain",
    text: "",
    series: { title: "rain", unit: { name: "mm/h", si: 1e-3 / 3600 }, time, values },
    lines: [],
  });

  it("have the value of the time: straight between rows, constant beyond, the second of a jump", () => {
    const steps = make([0, 1, 1, 2, 2], [20, 20, 800, 800, 0]);
    expect([-1, 0.5, 0.999, 1, 1.5, 2, 9].map((t) => evaluateSeries(steps, t))).toEqual([20, 20, 20, 800, 800, 0, 0]);
    expect(evaluateSeries(make([0, 4], [2, 10]), 1)).toBe(4);
    expect(evaluateSeries(make([0], [7]), 100)).toBe(7);
    expect(evaluateSeries({ ...make([], []), series: undefined }, 0)).toBeNaN();
  });

  it("wet what lies under the level, cut where it comes out", () => {
    expect(clipBelow([[0, 0], [0, 17]], 10)).toEqual([[[0, 0], [0, 10]]]);
    expect(clipBelow([[0, 17], [0, 0]], 10)).toEqual([[[0, 10], [0, 0]]]);
    expect(clipBelow([[0, 5], [10, 15], [20, 5]], 10)).toEqual([[[0, 5], [5, 10]], [[15, 10], [20, 5]]]);
    expect(clipBelow([[0, 12], [10, 15]], 10)).toEqual([]);
    expect(clipBelow([[0, 5], [10, 5]], 10)).toEqual([[[0, 5], [10, 5]]]);
  });
});

it("colours water under pressure blue, and soil stress as before", () => {
  const map = chooseColourMap({ name: "pore_pressure", diverging: true });
  const table = tabulateColours(map);
  const [red, , blue] = [table[4 * 255]!, 0, table[4 * 255 + 2]!];
  expect(blue).toBeGreaterThan(red + 50);
  expect(table[0]!).toBeGreaterThan(table[2]! + 50);
  expect(chooseColourMap({ name: "mean_stress", diverging: true })).toBe("blueRed");
  expect(chooseColourMap({ name: "saturation", diverging: false })).toBe("viridis");
});
