// SPDX-License-Identifier: MIT
/** Edits of case texts: values change where they stand, comments and order survive, shared vertices move together. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test } from "vitest";

import { listChains, listLoads } from "../src/document/chains";
import { appendEntry, applyEdits, EditFault, findDifference, removeAt, setValue } from "../src/document/edits";
import {
  addMaterial,
  addNail,
  addRegion,
  addSurcharge,
  deleteRegion,
  emptyCase,
  renameRegion,
  setSoil,
  setWaterTable,
  splitRegions,
} from "../src/document/operations";
import { type CaseTree, findNode, readTree, toPlain } from "../src/document/tree";
import { deleteVertex, insertVertex, listVertices, moveVertices, pointsOf } from "../src/document/vertices";
import type { Point } from "../src/geometry/plane";

const examples = join(import.meta.dirname, "../../../examples");
const dry = readFileSync(join(examples, "dry_slope/case.toml"), "utf8");
const embankment = readFileSync(join(examples, "layered_embankment/case.toml"), "utf8");

function read(text: string): CaseTree {
  const { tree, fault } = readTree(text);
  if (!tree) throw new Error(fault.text);
  return tree;
}

const valueAt = (text: string, ...path: (string | number)[]) => toPlain(findNode(read(text), path));
const comments = (text: string) => [...text.matchAll(/#.*$/gm)].map(([comment]) => comment);

function move(text: string, from: Point, to: Point): string {
  const tree = read(text);
  const chains = listChains(tree);
  const vertex = listVertices(chains).find(({ at }) => at[0] === from[0] && at[1] === from[1])!;
  return moveVertices(tree, chains, [{ vertex, to }]);
}

function polygon(text: string, name: string): Point[] {
  return pointsOf(listChains(read(text)).find((chain) => chain.kind === "region" && chain.name === name)!);
}

describe("The tree of a text", () => {
  test("every example is read, and every value stands where its range says", () => {
    const files = readdirSync(examples, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith("case.toml"));
    expect(files.length).toBeGreaterThan(15);
    for (const name of files) {
      const text = readFileSync(join(examples, name), "utf8");
      const tree = read(text);
      const title = findNode(tree, ["title"]);
      if (title?.kind === "value") expect(text.slice(...title.range)).toBe(JSON.stringify(title.value));
    }
  });
  test("a text that is no TOML gives its first fault", () => {
    const { tree, fault } = readTree('title = "a"\n[geometry\nbox = 1');
    expect(tree).toBeNull();
    expect(fault!.at).toBeGreaterThan(11);
  });
});

describe("Values", () => {
  test("a value is replaced and nothing else changes", () => {
    const edited = applyEdits(dry, setValue(read(dry), ["materials", "sand", "cohesion"], '"3 kPa"'));
    expect(edited).toBe(dry.replace('"2 kPa"', '"3 kPa"'));
  });
  test("a new key is appended to its table", () => {
    const edited = applyEdits(dry, setValue(read(dry), ["materials", "sand", "unit_weight"], "18"));
    expect(valueAt(edited, "materials", "sand", "unit_weight")).toBe(18);
    expect(edited).toContain("as in the independent run\nunit_weight = 18\n\n[regions]");
    expect(comments(edited)).toEqual(comments(dry));
  });
  test("a new block stands after the blocks that precede it", () => {
    const edited = applyEdits(dry, setValue(read(dry), ["initial", "pore_pressure"], '"zero"'));
    expect(valueAt(edited, "initial", "pore_pressure")).toBe("zero");
    expect(edited.indexOf("[initial]")).toBeGreaterThan(edited.indexOf("[[boundary]]"));
    expect(edited.indexOf("[initial]")).toBeLessThan(edited.indexOf("[[stage]]"));
  });
  test("keys of a table on one line are added and removed inside its braces", () => {
    const text = "a = { x = 1 }\nb = 2\n";
    const added = applyEdits(text, setValue(read(text), ["a", "y"], "3"));
    expect(added).toBe("a = { x = 1, y = 3 }\nb = 2\n");
    expect(applyEdits(added, removeAt(read(added), ["a", "x"]))).toBe("a = { y = 3 }\nb = 2\n");
  });
  test("keys of the root come before the first block", () => {
    const text = "# a case\n[lem]\nslices = 30\n";
    const edited = applyEdits(text, setValue(read(text), ["title"], '"A"'));
    expect(valueAt(edited, "title")).toBe("A");
    expect(valueAt(edited, "lem", "slices")).toBe(30);
  });
  test("a removed block takes its keys with it and leaves the others", () => {
    const edited = applyEdits(embankment, removeAt(read(embankment), ["surcharge", 0]));
    expect(valueAt(edited, "surcharge")).toBeUndefined();
    expect(valueAt(edited, "analysis", "methods")).toEqual(["lem", "fem"]);
  });
  test("no block is appended after a table on one line", () => {
    const tree = read("geometry = { box = [[0, 0], [1, 1]] }\n");
    expect(() => appendEntry(tree, ["geometry", "polygon"], { name: '"a"' })).toThrow(EditFault);
  });
  test("the difference of two texts is the smallest single edit", () => {
    expect(findDifference("abcd", "abXcd")).toEqual({ from: 2, to: 2, insert: "X" });
    expect(findDifference("aaa", "aa")).toEqual({ from: 2, to: 3, insert: "" });
  });
});

describe("Shared vertices", () => {
  test("a vertex moves in every region, line and monitor that has it", () => {
    const edited = move(dry, [12, 15], [14, 15.5]);
    expect(polygon(edited, "soil")[4]).toEqual([14, 15.5]);
    expect(valueAt(edited, "output", "monitor", 0, "at")).toEqual([14, 15.5]);
    expect(comments(edited)).toEqual(comments(dry));
    expect(edited.split("\n").length).toBe(dry.split("\n").length);
  });
  test("a common side stays common", () => {
    const edited = move(embankment, [60, 3], [60, 4]);
    expect(polygon(edited, "gravel")).toContainEqual([60, 4]);
    expect(polygon(edited, "clay")).toContainEqual([60, 4]);
  });
  test("a vertex on the side of another region becomes a vertex of it", () => {
    // The toe of the fill lies on the top of the clay.
    const edited = move(embankment, [38, 8], [38, 7]);
    expect(polygon(edited, "fill")).toContainEqual([38, 7]);
    expect(polygon(edited, "clay")).toEqual([[0, 3], [60, 3], [60, 8], [38, 7], [0, 8]]);
  });
  test("a vertex that slides along the side adds nothing to it", () => {
    const edited = move(embankment, [38, 8], [40, 8]);
    expect(polygon(edited, "clay")).toHaveLength(4);
  });
  test("a side that moves away keeps the vertices on it", () => {
    const edited = move(embankment, [60, 8], [60, 9]);
    expect(polygon(edited, "clay")).toEqual([[0, 3], [60, 3], [60, 9], [38, 8], [0, 8]]);
  });
  test("a length with a unit keeps its unit", () => {
    const text = '[[geometry.polygon]]\nname = "a"\npoints = [[0, 0], ["10 ft", 0], [0, 5]]\n';
    const vertex = listVertices(listChains(read(text)))[1]!;
    const edited = moveVertices(read(text), listChains(read(text)), [{ vertex, to: [6.096, 1] }]);
    expect(edited).toContain('["20 ft", 1]');
  });
  test("a vertex is inserted in both regions of a side, and deleted from both", () => {
    const tree = read(embankment);
    const chains = listChains(tree);
    const edited = insertVertex(tree, chains, [20, 3], chains.findIndex(({ name }) => name === "clay"));
    expect(polygon(edited, "clay")).toContainEqual([20, 3]);
    expect(polygon(edited, "gravel")).toContainEqual([20, 3]);
    const after = listChains(read(edited));
    const vertex = listVertices(after).find(({ at }) => at[0] === 20)!;
    expect(vertex.corners).toHaveLength(2);
    expect(deleteVertex(read(edited), after, vertex)).toBe(embankment);
  });
  test("a triangle keeps its three vertices", () => {
    const text = '[[geometry.polygon]]\nname = "a"\npoints = [[0, 0], [1, 0], [0, 1]]\n';
    const chains = listChains(read(text));
    expect(() => deleteVertex(read(text), chains, listVertices(chains)[0]!)).toThrow("fewer than 3");
  });
});

describe("Drawing", () => {
  const square: Point[] = [[0, 0], [10, 0], [10, 10], [0, 10]];

  test("a slope from nothing is a case", () => {
    const made = addRegion(read(emptyCase), [[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]], "ground", "sand");
    const edited = addMaterial(read(made.text), "sand").text;
    expect(polygon(edited, "ground")).toHaveLength(6);
    expect(valueAt(edited, "regions")).toEqual({ ground: "sand" });
    expect(valueAt(edited, "materials", "sand", "model")).toBe("mohr_coulomb");
    expect(valueAt(edited, "analysis", "methods")).toEqual(["lem"]);
  });
  test("a new region cuts those that it overlaps partly", () => {
    const first = addRegion(read(emptyCase), square, "a", "clay").text;
    const { text } = addRegion(read(first), [[5, 5], [15, 5], [15, 15], [5, 15]], "b", "sand");
    expect(polygon(text, "a")).toHaveLength(6);
    expect(polygon(text, "a")).toContainEqual([5, 5]);
    expect(polygon(text, "b")).toHaveLength(4);
  });
  test("a new region inside another leaves it as it is, and one around another replaces it", () => {
    const first = addRegion(read(emptyCase), square, "a", "clay").text;
    const inside = addRegion(read(first), [[2, 2], [4, 2], [4, 4]], "b", "sand").text;
    expect(polygon(inside, "a")).toEqual(square);
    const around = addRegion(read(first), [[-1, -1], [11, -1], [11, 11], [-1, 11]], "c", "sand").text;
    expect(valueAt(around, "regions")).toEqual({ c: "sand" });
  });
  test("a line splits a region into two with the same soil", () => {
    const first = addRegion(read(emptyCase), square, "a", "clay").text;
    const { text, names } = splitRegions(read(first), [[-1, 4], [5, 6], [11, 4]], null);
    expect(names).toEqual(["a 2"]);
    expect(valueAt(text, "regions")).toEqual({ a: "clay", "a 2": "clay" });
    expect(polygon(text, "a")).toContainEqual([5, 6]);
    expect(polygon(text, "a 2")).toContainEqual([5, 6]);
    expect(polygon(text, "a 2")).toContainEqual([10, 0]);
    expect(() => splitRegions(read(first), [[1, 1], [2, 2]], null)).toThrow("side to side");
  });
  test("names, soils and deletion keep [regions] in step", () => {
    const renamed = renameRegion(read(embankment), "clay", "soft clay");
    expect(valueAt(renamed, "regions")).toEqual({ gravel: "gravel", "soft clay": "clay", fill: "fill" });
    expect(valueAt(setSoil(read(renamed), "soft clay", "fill"), "regions", "soft clay")).toBe("fill");
    expect(valueAt(deleteRegion(read(renamed), "soft clay"), "regions")).toEqual({ gravel: "gravel", fill: "fill" });
    expect(() => renameRegion(read(embankment), "clay", "fill")).toThrow("already");
  });
  test("water, a surcharge and a nail", () => {
    const water = setWaterTable(read(dry), [[44, 5], [0, 10]]);
    expect(valueAt(water, "initial")).toEqual({ pore_pressure: "water_table", water_table: [[0, 10], [44, 5]] });
    const loaded = addSurcharge(read(dry), 8, 2, 15);
    expect(listLoads(read(loaded))[0]!.x.map(({ value }) => value)).toEqual([2, 8]);
    const nailed = addNail(read(dry), [22, 10], [16, 9]).text;
    expect(valueAt(nailed, "support", "nails", "first")).toEqual([22, 10]);
    expect(valueAt(nailed, "support", "nails", "lengths")).toEqual([6.083]);
    expect(comments(nailed)).toEqual(comments(dry));
  });
});
