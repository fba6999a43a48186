// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";

import { writeCsv, writePoints } from "../src/output/csv";
import { addMotion, addValue, emptyRun, findSurface, listCurves, listFindings } from "../src/runs/liveRun";
import { groupPoints } from "../src/runs/RunLayer";

describe("the values of a run", () => {
  const trials = [
    { method: "fem", series: "ψ as given", lower: 1, factor: 1, holds: true, displacement: 0.01 },
    { method: "fem", series: "ψ as given", lower: 1, upper: 2, factor: 2, holds: false, displacement: 0.8 },
    { method: "fem", series: "ψ as given", lower: 1.5, upper: 2, factor: 1.5, holds: true, displacement: 0.1 },
  ];
  it("give the bracket of a strength reduction, and its curve in the order of the factors", () => {
    const run = trials.reduce(addValue, emptyRun);
    expect(listFindings(run.values)).toEqual([{ name: "FEM, ψ as given", text: "1.500 to 2.000" }]);
    const [curve] = listCurves(run);
    expect(curve!.line).toEqual([[1, 0.01], [1.5, 0.1], [2, 0.8]]);
    expect(curve!.marks.map(({ holds }) => holds)).toEqual([true, false, true]);
  });
  it("give the result once it is known, with its surface", () => {
    const surface: [number, number][] = [[0, 0], [10, 5]];
    const run = [...trials, { method: "fem", series: "ψ as given", factor: 1.62, surface }].reduce(addValue, emptyRun);
    expect(listFindings(run.values)[0]!.text).toBe("1.620");
    expect(findSurface(run.values)!.surface).toBe(surface);
  });
  it("draw limit analysis as a band that narrows", () => {
    const run = [[1, 2], [1.2, 1.5]].reduce((r, [lower, upper]) => addValue(r, { method: "bounds", lower, upper }), emptyRun);
    expect(listCurves(run)[0]!.band).toEqual({ lower: [[1, 1], [2, 1.2]], upper: [[1, 2], [2, 1.5]] });
  });
  it("draw a timeline in the order of time [h], with the last factor of each time", () => {
    const run = [[7200, 1.2], [0, 1.5], [7200, 1.1]].reduce((r, [time, factor]) => addValue(r, { method: "timeline", time, factor }), emptyRun);
    expect(listCurves(run)[0]!.line).toEqual([[0, 1.5], [2, 1.1]]);
  });
  it("draw motion over time, which begins anew with every stage and after a step back", () => {
    let run = addMotion(addMotion(emptyRun, "gravity", 1, 0.1), "gravity", 2, 0.2);
    run = addMotion(run, "gravity", 1.5, 0.12);
    expect(run.motion.points).toEqual([[1, 0.1], [1.5, 0.12]]);
    expect(addMotion(run, "release", 0.1, 0).motion.points).toEqual([[0.1, 0]]);
    for (let i = 0; i < 5000; ++i) run = addMotion(run, "long", i, i);
    expect(run.motion.points.length).toBeLessThanOrEqual(601);
    expect(run.motion.points.at(-1)).toEqual([4999, 4999]);
  });
  it("group material points by their displacement", () => {
    const groups = groupPoints({ time: 0, stage: "", count: 3, x: [0, 1, 2], y: [0, 0, 1], displacement: [0, 0.1, 6] });
    expect(groups).toEqual([{ level: 0, path: "M0 0h0M1 0h0" }, { level: 5, path: "M2 1h0" }]);
  });
});

describe("comma-separated values", () => {
  it("quote what a spreadsheet would read otherwise", () => {
    const values = [{ name: "lem.factor", title: 'factor, "governing"', unit: "", value: 1.25 }, { name: "=1+1", title: "x", unit: "m", value: null }];
    expect(writeCsv({ values })).toBe('name,title,value,unit\r\nlem.factor,"factor, ""governing""",1.25,\r\n\'=1+1,x,,m\r\n');
  });
  it("list the points of lines", () => {
    expect(writePoints([{ kind: "water", name: "table", points: [[0, 1.5], [2, -1]] }])).toBe("kind,name,x,y\r\nwater,table,0,1.5\r\nwater,table,2,-1\r\n");
  });
});
