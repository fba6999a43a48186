// SPDX-License-Identifier: MIT
/** What the canvas does to a case: regions drawn, split, deleted, renamed; soils, water, loads and supports added. */
import { computeArea, type Point } from "../geometry/plane";
import { cutRing, isCovered, splitRing } from "../geometry/regions";
import { type Chain, type ChainKind, listChains, listSoils } from "./chains";
import {
  appendEntry,
  applyEdits,
  EditFault,
  removeAt,
  setValue,
  writeNumber,
  writePoints,
  writeText,
} from "./edits";
import { type CaseTree, findNode, type Path, readTree, toPlain } from "./tree";
import { applyInTurn, pointsOf, replacePoints } from "./vertices";

/** A name that none of the others has: "fill", "fill 2", "fill 3". */
export function makeName(wanted: string, taken: readonly string[]): string {
  if (!taken.includes(wanted)) return wanted;
  for (let i = 2; ; ++i) if (!taken.includes(`${wanted} ${i}`)) return `${wanted} ${i}`;
}

const regionsOf = (tree: CaseTree) => listChains(tree).filter((chain) => chain.kind === "region");

export function listRegionNames(tree: CaseTree): string[] {
  const layers = toPlain(findNode(tree, ["geometry", "layer"])) as { name?: string }[] | undefined;
  return [...regionsOf(tree).map(({ name }) => name), ...(layers ?? []).map(({ name }) => name ?? "")];
}

function addPolygon(text: string, name: string, ring: readonly Point[], soil: string | null): string {
  return applyInTurn(text, [
    (tree) => appendEntry(tree, ["geometry", "polygon"], { name: writeText(name), points: writePoints(ring) }),
    (tree) => (soil === null ? [] : setValue(tree, ["regions", name], writeText(soil))),
  ]);
}

/** A new region; regions that it partly covers are cut, those that it covers wholly are deleted, one around it is replaced inside. */
export function addRegion(tree: CaseTree, ring: readonly Point[], wanted: string, soil: string | null): { text: string; name: string } {
  if (ring.length < 3 || Math.abs(computeArea(ring)) < 1e-9) throw new EditFault("A region needs three points at least that are not on one line.");
  let text = tree.text;
  for (const region of regionsOf(tree)) {
    const points = pointsOf(region);
    if (isCovered(points, ring)) {
      text = deleteRegion(parse(text), region.name);
      continue;
    }
    const rest = cutRing(points, ring);
    if (rest) text = replaceRegion(text, region, rest);
  }
  const name = makeName(wanted, listRegionNames(parse(text)));
  return { text: addPolygon(text, name, ring, soil), name };
}

/** The first ring keeps the name, further ones are new regions with the same soil. */
function replaceRegion(text: string, region: Chain, rings: readonly Point[][]): string {
  const [first, ...others] = rings.toSorted((a, b) => Math.abs(computeArea(b)) - Math.abs(computeArea(a)));
  let result = applyInTurn(text, [
    (tree) => {
      const now = regionsOf(tree).find(({ name }) => name === region.name)!;
      return replacePoints(tree, now, first!);
    },
  ]);
  for (const ring of others)
    result = addPolygon(result, makeName(region.name, listRegionNames(parse(result))), ring, region.soil);
  return result;
}

/** Splits every region that a line crosses, or only the one with a name. Names are those of the new regions. */
export function splitRegions(tree: CaseTree, line: readonly Point[], only: string | null): { text: string; names: string[] } {
  let text = tree.text;
  const names: string[] = [];
  for (const region of regionsOf(tree)) {
    if (only !== null && region.name !== only) continue;
    const rings = splitRing(pointsOf(region), line);
    if (!rings) continue;
    // The upper part keeps the name.
    const middle = (ring: readonly Point[]) => ring.reduce((sum, [, y]) => sum + y, 0) / ring.length;
    const [upper, lower] = middle(rings[0]) >= middle(rings[1]) ? rings : rings.toReversed();
    text = applyInTurn(text, [
      (now) => replacePoints(now, regionsOf(now).find(({ name }) => name === region.name)!, upper!),
    ]);
    const name = makeName(region.name, listRegionNames(parse(text)));
    text = addPolygon(text, name, lower!, region.soil);
    names.push(name);
  }
  if (!names.length) throw new EditFault("The line does not cross a region from side to side.");
  return { text, names };
}

export function deleteRegion(tree: CaseTree, name: string): string {
  const region = regionsOf(tree).find((chain) => chain.name === name);
  if (!region) return tree.text;
  return applyInTurn(tree.text, [(now) => removeAt(now, region.owner), (now) => removeAt(now, ["regions", name])]);
}

export function renameRegion(tree: CaseTree, from: string, to: string): string {
  if (to === from || !to.trim()) return tree.text;
  if (listRegionNames(tree).includes(to)) throw new EditFault(`There is a region “${to}” already.`);
  const region = regionsOf(tree).find((chain) => chain.name === from);
  if (!region) return tree.text;
  const soil = region.soil;
  const steps = [(now: CaseTree) => setValue(now, [...region.owner, "name"], writeText(to))];
  if (soil !== null) {
    steps.push((now) => setValue(now, ["regions", to], writeText(soil)));
    steps.push((now) => removeAt(now, ["regions", from]));
  }
  return applyInTurn(tree.text, steps);
}

export const setSoil = (tree: CaseTree, region: string, soil: string): string =>
  applyEdits(tree.text, setValue(tree, ["regions", region], writeText(soil)));

/** A material with its law alone: strength and weight have no default. */
export function addMaterial(tree: CaseTree, wanted: string): { text: string; name: string } {
  const name = makeName(wanted, listSoils(tree));
  return { text: applyEdits(tree.text, setValue(tree, ["materials", name, "model"], writeText("mohr_coulomb"))), name };
}

/** A water table replaces the one before; pore pressures are then hydrostatic below it. */
export function setWaterTable(tree: CaseTree, line: readonly Point[]): string {
  const sorted = line.toSorted((a, b) => a[0] - b[0]);
  return applyInTurn(tree.text, [
    (now) => setValue(now, ["initial", "pore_pressure"], writeText("water_table")),
    (now) => setValue(now, ["initial", "water_table"], writePoints(sorted)),
  ]);
}

const pathsOfLines: Partial<Record<ChainKind, { path: Path; title: string }>> = {
  line: { path: ["geometry", "line"], title: "line" },
  surface: { path: ["lem", "surface"], title: "surface" },
  exclude: { path: ["lem", "exclude"], title: "area" },
  through: { path: ["lem", "through"], title: "passage" },
  section: { path: ["seepage", "section"], title: "discharge" },
};

/** A named line, a slip surface or an excluded area. */
export function addChain(tree: CaseTree, kind: ChainKind, line: readonly Point[]): string {
  const found = pathsOfLines[kind];
  if (!found) throw new EditFault("Nothing of this kind can be drawn.");
  const entries = toPlain(findNode(tree, found.path)) as { name?: string }[] | undefined;
  const name = makeName(found.title, (entries ?? []).map((entry) => entry.name ?? ""));
  const points = kind === "surface" ? line.toSorted((a, b) => a[0] - b[0]) : line;
  return applyEdits(tree.text, appendEntry(tree, found.path, { name: writeText(name), points: writePoints(points) }));
}

const nameIn = (tree: CaseTree, path: Path, title: string): string =>
  makeName(title, ((toPlain(findNode(tree, path)) ?? []) as { name?: string }[]).map((entry) => entry.name ?? ""));

/** [lem] search, where another one is given or needed. */
const setSearch = (search: "entry_exit" | "grid" | "block") => (tree: CaseTree) =>
  findNode(tree, ["lem", "search"]) || search !== "entry_exit" ? setValue(tree, ["lem", "search"], writeText(search)) : [];

const writeRange = (a: number, b: number) => `[${writeNumber(Math.min(a, b))}, ${writeNumber(Math.max(a, b))}]`;
const writeCorners = (a: Point, b: Point) =>
  writePoints([[Math.min(a[0], b[0]), Math.min(a[1], b[1])], [Math.max(a[0], b[0]), Math.max(a[1], b[1])]]);

/** Where slip surfaces begin or end on the ground [m]. */
export function setGroundRange(tree: CaseTree, which: "entry" | "exit", from: number, to: number): string {
  if (from === to) throw new EditFault("A range needs two places with different x.");
  return applyInTurn(tree.text, [(now) => setValue(now, ["lem", "entry_exit", which], writeRange(from, to)), setSearch("entry_exit")]);
}

/** A window of the block search: every surface has a vertex in it. */
export function addWindow(tree: CaseTree, a: Point, b: Point): string {
  const path = ["lem", "block", "window"];
  const name = writeText(nameIn(tree, path, "window"));
  return applyInTurn(tree.text, [(now) => appendEntry(now, path, { name, box: writeCorners(a, b) }), setSearch("block")]);
}

export function setCentres(tree: CaseTree, a: Point, b: Point): string {
  return applyInTurn(tree.text, [(now) => setValue(now, ["lem", "grid", "corners"], writeCorners(a, b)), setSearch("grid")]);
}

/** A slip circle about a centre through a point. */
export function addCircle(tree: CaseTree, centre: Point, through: Point): string {
  const radius = Math.hypot(through[0] - centre[0], through[1] - centre[1]);
  const point = `[${centre.map(writeNumber).join(", ")}]`;
  return applyEdits(tree.text, appendEntry(tree, ["lem", "surface"], { name: writeText(nameIn(tree, ["lem", "surface"], "circle")), centre: point, radius: writeNumber(Number(radius.toFixed(3))) }));
}

/** Levels of the deepest points of all circles; one level where both are equal. */
export function setTangent(tree: CaseTree, a: number, b: number): string {
  const levels = Math.abs(a - b) < 1e-9 ? writeNumber(a) : writeRange(a, b);
  return applyInTurn(tree.text, [(now) => removeAt(now, ["lem", "tangent", "layer"]), (now) => setValue(now, ["lem", "tangent", "levels"], levels)]);
}

/** A block whose safety against heave is computed, above the lower of two points. */
export function addHeave(tree: CaseTree, a: Point, b: Point): string {
  const path = ["seepage", "heave"];
  return applyEdits(tree.text, appendEntry(tree, path, { name: writeText(nameIn(tree, path, "heave")), x: writeRange(a[0], b[0]), level: writeNumber(Math.min(a[1], b[1])) }));
}

/** A liquid up to the higher of two points; its unit weight is left to the form. */
export function addSlurry(tree: CaseTree, a: Point, b: Point): string {
  return applyEdits(tree.text, appendEntry(tree, ["slurry"], { name: writeText(nameIn(tree, ["slurry"], "slurry")), x: writeRange(a[0], b[0]), level: writeNumber(Math.max(a[1], b[1])) }));
}

/** A condition on a side or line. What it does is in the form: only fixity has a first value. */
export function addCondition(tree: CaseTree, kind: "boundary" | "traction" | "hydraulic", on: string): string {
  const first: Record<typeof kind, Record<string, string>> = {
    boundary: { fix: writeText("full") },
    traction: { traction: "[0, -10]" },
    hydraulic: { condition: writeText("seepage_face") },
  };
  return applyEdits(tree.text, appendEntry(tree, [kind], { on: writeText(on), ...first[kind] }));
}

export function addMonitor(tree: CaseTree, at: Point): string {
  const entries = toPlain(findNode(tree, ["output", "monitor"])) as { name?: string }[] | undefined;
  const name = makeName("monitor", (entries ?? []).map((entry) => entry.name ?? ""));
  const point = `[${at.map(writeNumber).join(", ")}]`;
  return applyEdits(tree.text, appendEntry(tree, ["output", "monitor"], { name: writeText(name), at: point }));
}

/** A surcharge between two places along x with the same load [kPa] at both. */
export function addSurcharge(tree: CaseTree, from: number, to: number, load: number): string {
  if (from === to) throw new EditFault("A surcharge needs two places with different x.");
  const x = `[${[Math.min(from, to), Math.max(from, to)].map(writeNumber).join(", ")}]`;
  const entries = toPlain(findNode(tree, ["surcharge"])) as { name?: string }[] | undefined;
  const name = makeName("surcharge", (entries ?? []).map((entry) => entry.name ?? ""));
  const value = writeNumber(load);
  return applyEdits(tree.text, appendEntry(tree, ["surcharge"], { name: writeText(name), x, load: `[${value}, ${value}]` }));
}

/** A nail from its head on the ground into the soil: place, length and inclination are drawn, strengths are left to the form. */
export function addNail(tree: CaseTree, head: Point, tip: Point): { text: string; name: string } {
  const table = toPlain(findNode(tree, ["support"])) as Record<string, unknown> | undefined;
  const name = makeName("nails", Object.keys(table ?? {}));
  const length = Math.hypot(tip[0] - head[0], tip[1] - head[1]);
  if (length < 1e-6) throw new EditFault("A nail needs a head and a tip at different places.");
  const angle = (Math.atan2(head[1] - tip[1], Math.abs(tip[0] - head[0])) * 180) / Math.PI;
  const values: [string, string][] = [
    ["kind", writeText("nail")],
    ["first", `[${head.map(writeNumber).join(", ")}]`],
    ["inclination", writeNumber(Number(angle.toFixed(2)))],
    ["lengths", `[${writeNumber(Number(length.toFixed(3)))}]`],
  ];
  return {
    text: applyInTurn(tree.text, values.map(([key, value]) => (now: CaseTree) => setValue(now, ["support", name, key], value))),
    name,
  };
}

/** A case with nothing drawn. */
export const emptyCase = `title = "New slope"

[analysis]
methods = ["lem"]

[lem]
methods = ["bishop", "spencer"]
`;

function parse(text: string): CaseTree {
  const { tree, fault } = readTree(text);
  if (!tree) throw new EditFault(`The text is not TOML: ${fault.text}`);
  return tree;
}
