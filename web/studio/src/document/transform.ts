// SPDX-License-Identifier: MIT
/** Copies, mirrored, turned, scaled and parallel shapes, and lines that are split in two. */
import { distance, intersectSegments, isWithinSegment, listSegments, type Point } from "../geometry/plane";
import { offsetLine, offsetRing } from "../geometry/offset";
import { type Chain, listChains } from "./chains";
import { appendEntry, applyEdits, EditFault, setValue, writePoint, writePoints, writeText } from "./edits";
import { addChain, addRegion, listRegionNames, makeName } from "./operations";
import { type CaseTree, findNode, type Path, readTree, toPlain } from "./tree";
import { applyInTurn, boundaries, findTolerance, listVertices, moveVertices, pointsOf, replacePoints, segmentsOf, type Vertex } from "./vertices";

export type PlaneMap = (p: Point) => Point;

const round = (value: number) => Number(value.toFixed(9)) + 0;
const tidy = (map: PlaneMap): PlaneMap => (p) => {
  const [x, y] = map(p);
  return [round(x), round(y)];
};

export const shiftBy = (dx: number, dy: number): PlaneMap => tidy(([x, y]) => [x + dx, y + dy]);

/** Reflection in the line through two points. */
export function mirrorAt(a: Point, b: Point): PlaneMap {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dy * dy;
  if (square === 0) throw new EditFault("A mirror needs two different points.");
  return tidy(([x, y]) => {
    const t = ((x - a[0]) * dx + (y - a[1]) * dy) / square;
    return [2 * (a[0] + t * dx) - x, 2 * (a[1] + t * dy) - y];
  });
}

/** Rotation about a centre by degrees, counter-clockwise. */
export function turnAbout(centre: Point, degrees: number): PlaneMap {
  const [cos, sin] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return tidy(([x, y]) => [
    centre[0] + cos * (x - centre[0]) - sin * (y - centre[1]),
    centre[1] + sin * (x - centre[0]) + cos * (y - centre[1]),
  ]);
}

export function scaleAbout(centre: Point, factor: number): PlaneMap {
  if (!(factor > 0)) throw new EditFault("A scale must be positive.");
  return tidy(([x, y]) => [centre[0] + factor * (x - centre[0]), centre[1] + factor * (y - centre[1])]);
}

/** Kinds that keep their entry: a copy is another entry of the same list. Others are copied as a named line. */
const listed: ReadonlySet<Chain["kind"]> = new Set(["line", "surface", "exclude", "through", "window", "monitor", "piezometric", "section"]);
/** Kinds whose points must run from left to right. */
const sorted: ReadonlySet<Chain["kind"]> = new Set(["surface", "piezometric", "ground", "layer", "water", "drawdown"]);

const order = (chain: Chain, points: Point[]) => (sorted.has(chain.kind) ? points.toSorted((a, b) => a[0] - b[0]) : points);

function namesOf(tree: CaseTree, list: Path): string[] {
  const entries = toPlain(findNode(tree, list)) as { name?: string }[] | undefined;
  return (entries ?? []).map(({ name }) => name ?? "");
}

/** Keys of an entry as they are written, without some. */
function copyValues(tree: CaseTree, path: Path, without: readonly string[]): Record<string, string> {
  const entry = findNode(tree, path);
  const values: Record<string, string> = {};
  if (entry?.kind !== "table") return values;
  for (const [key, { node, line }] of entry.entries) {
    if (without.includes(key)) continue;
    if (!line || (node.kind === "table" && !node.inline)) throw new EditFault(`'${key}' has a block of its own. Copy the entry in the text.`);
    values[key] = tree.text.slice(...node.range);
  }
  return values;
}

/** A copy of a shape under a map. */
export const copyChain = (tree: CaseTree, chain: Chain, map: PlaneMap): string => addCopy(tree, chain, order(chain, pointsOf(chain).map(map)));

/** An entry like that of a shape with other points. */
function addCopy(tree: CaseTree, chain: Chain, points: readonly Point[]): string {
  if (chain.kind === "region") return addRegion(tree, points, makeName(chain.name, listRegionNames(tree)), chain.soil).text;
  if (chain.kind === "support") return copySupport(tree, chain, points);
  if (!listed.has(chain.kind)) {
    if (chain.single || chain.corners) throw new EditFault("This is not copied. Draw another one.");
    return addChain(tree, "line", points);
  }
  const list = chain.owner.slice(0, -1);
  const key = String(chain.path.at(-1));
  const values = copyValues(tree, chain.owner, ["name", key]);
  const named: Record<string, string> = chain.kind === "piezometric" ? {} : { name: writeText(makeName(chain.name, namesOf(tree, list))) };
  return applyEdits(tree.text, appendEntry(tree, list, { ...named, [key]: chain.single ? writePoint(points[0]!) : writePoints(points), ...values }));
}

function copySupport(tree: CaseTree, chain: Chain, points: readonly Point[]): string {
  const key = String(chain.path.at(-1));
  const table = toPlain(findNode(tree, ["support"])) as Record<string, unknown>;
  const name = makeName(chain.name, Object.keys(table));
  const values = { ...copyValues(tree, chain.owner, [key]), [key]: chain.single ? writePoint(points[0]!) : writePoints(points) };
  return applyInTurn(tree.text, Object.entries(values).map(([one, value]) => (now: CaseTree) => setValue(now, ["support", name, one], value)));
}

/** Moves shapes by a map where they are; everything that shares their vertices, or has one on their sides, follows. */
export function mapChains(tree: CaseTree, chains: readonly Chain[], moved: readonly Chain[], map: PlaneMap): string {
  const indices = new Set(moved.map((chain) => chains.indexOf(chain)));
  const listedVertices = listVertices(chains);
  const tolerance = findTolerance(chains);
  const sides = moved.filter(({ kind }) => boundaries.has(kind)).flatMap(segmentsOf);
  const isOnSide = ({ at, corners }: Vertex) =>
    corners.some(({ chain }) => boundaries.has(chains[chain]!.kind)) && sides.some((side) => isWithinSegment(at, side, tolerance));
  const moves = listedVertices
    .filter((vertex) => vertex.corners.some(({ chain }) => indices.has(chain)) || isOnSide(vertex))
    .map((vertex) => ({ vertex, to: map(vertex.at) }));
  const text = moveVertices(tree, chains, moves, listedVertices);
  // Lines from left to right are turned round where a mirror has reversed them.
  let result = text;
  for (const { id, kind } of moved) {
    if (!sorted.has(kind)) continue;
    const now = readTree(result).tree;
    const chain = now && listChains(now).find((other) => other.id === id);
    if (!now || !chain) continue;
    const points = pointsOf(chain);
    const after = points.toSorted((a, b) => a[0] - b[0]);
    if (after.some((p, i) => p !== points[i])) result = applyEdits(result, replacePoints(now, chain, after));
  }
  return result;
}

/** A parallel shape at a distance [m]: of a line to its left (upwards from left to right), of a region outwards. */
export function offsetChain(tree: CaseTree, chain: Chain, shift: number): string {
  const points = pointsOf(chain);
  if (chain.single || chain.corners || chain.kind === "support") throw new EditFault("Only lines and regions have parallels.");
  const found = chain.closed ? offsetRing(points, shift) : offsetLine(points, shift);
  if (!found) throw new EditFault("Nothing is left at this distance, or the parallel would cross itself. Take a smaller one.");
  const made = found.map(([x, y]): Point => [round(x), round(y)]);
  if (chain.kind !== "region") return addCopy(tree, chain, made);
  if (shift < 0) return addRegion(tree, made, makeName(chain.name, listRegionNames(tree)), chain.soil).text;
  return addChain(tree, "line", [...made, made[0]!]);
}

/** Blocks whose entries act on a named line, and the key that names it. */
const acting: readonly [Path, string][] = [
  [["boundary"], "on"],
  [["traction"], "on"],
  [["hydraulic"], "on"],
  [["roots"], "ground"],
];

/** Splits a line at one of its inner points. Whatever acts on it by its name acts on both parts. */
export function splitLine(tree: CaseTree, chain: Chain, index: number): string {
  if (!["line", "section", "through"].includes(chain.kind) || chain.single)
    throw new EditFault("Only named lines, lines of discharge and lines that surfaces cross are split.");
  const points = pointsOf(chain);
  if (!(index > 0 && index < points.length - 1)) throw new EditFault("A line is split at a point between its ends.");
  const list = chain.owner.slice(0, -1);
  const name = makeName(chain.name, namesOf(tree, list));
  const values = copyValues(tree, chain.owner, ["name", "points"]);
  const steps = [
    (now: CaseTree) => replacePoints(now, chain, points.slice(0, index + 1)),
    (now: CaseTree) => appendEntry(now, list, { name: writeText(name), points: writePoints(points.slice(index)), ...values }),
  ];
  if (chain.kind === "line")
    for (const [block, key] of acting)
      ((toPlain(findNode(tree, block)) ?? []) as Record<string, unknown>[]).forEach((entry, i) => {
        if (entry[key] !== chain.name) return;
        steps.push((now) => appendEntry(now, block, { [key]: writeText(name), ...copyValues(now, [...block, i], [key]) }));
      });
  return applyInTurn(tree.text, steps);
}

/** Splits a line where another crosses it first; a vertex is made there. */
export function splitLineBy(tree: CaseTree, chain: Chain, cut: readonly Point[]): string {
  const points = pointsOf(chain);
  for (const [i, side] of listSegments(points, false).entries())
    for (const piece of listSegments(cut, false)) {
      const at = intersectSegments(side, piece)?.at;
      if (!at) continue;
      const known = points.findIndex((p) => distance(p, at) < 1e-6);
      if (known >= 0) return splitLine(tree, chain, known);
      const after = points.toSpliced(i + 1, 0, [round(at[0]), round(at[1])]);
      const text = applyEdits(tree.text, replacePoints(tree, chain, after));
      const now = readTree(text).tree!;
      return splitLine(now, listChains(now).find(({ id }) => id === chain.id)!, i + 1);
    }
  throw new EditFault(`The line does not cross “${chain.name}”.`);
}
