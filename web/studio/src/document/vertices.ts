// SPDX-License-Identifier: MIT
/** Shared vertices: coinciding corners of regions, lines and layers are one vertex and move together. */
import { distance, isWithinSegment, listSegments, type Point, type Segment } from "../geometry/plane";
import type { Chain, ChainKind, ChainPoint, LengthAt } from "./chains";
import { applyEdits, type Edit, EditFault, insertItem, removeAt, setValue, writeNumber, writePoint, writePoints } from "./edits";
import { type CaseTree, readTree } from "./tree";

export interface Corner {
  chain: number;
  index: number;
}

export interface Vertex {
  at: Point;
  corners: Corner[];
}

/** Chains whose corners are boundaries of the section; others move alone. */
const sharing: ReadonlySet<ChainKind> = new Set(["region", "line", "ground", "layer", "monitor"]);
/** Chains along which boundaries run. */
export const boundaries: ReadonlySet<ChainKind> = new Set(["region", "line", "ground", "layer"]);

export const pointsOf = (chain: Chain): Point[] => chain.points.map(({ x, y }) => [x.value, y.value]);

export const segmentsOf = (chain: Chain): Segment[] =>
  chain.corners || chain.single || chain.kind === "monitor" || chain.kind === "support" ? [] : listSegments(pointsOf(chain), chain.closed);

/** Corners that are nearer count as one [m]: a millionth of the section, as the reader of case files has it. */
export function findTolerance(chains: readonly Chain[]): number {
  let [low, high] = [Infinity, -Infinity];
  for (const chain of chains)
    for (const { x } of chain.points) {
      low = Math.min(low, x.value);
      high = Math.max(high, x.value);
    }
  return 1e-6 * (high > low ? high - low : 1);
}

export function listVertices(chains: readonly Chain[]): Vertex[] {
  const tolerance = findTolerance(chains);
  const cells = new Map<string, Vertex[]>();
  const vertices: Vertex[] = [];
  const cell = (value: number) => Math.floor(value / (4 * tolerance));
  const findShared = (at: Point): Vertex | undefined => {
    for (let i = -1; i <= 1; ++i)
      for (let j = -1; j <= 1; ++j) {
        const found = cells.get(`${cell(at[0]) + i},${cell(at[1]) + j}`)?.find((v) => distance(v.at, at) <= tolerance);
        if (found) return found;
      }
    return undefined;
  };
  chains.forEach((chain, c) => {
    const shares = sharing.has(chain.kind);
    pointsOf(chain).forEach((at, index) => {
      const known = shares ? findShared(at) : undefined;
      if (known) return void known.corners.push({ chain: c, index });
      const vertex: Vertex = { at, corners: [{ chain: c, index }] };
      vertices.push(vertex);
      if (!shares) return;
      const key = `${cell(at[0])},${cell(at[1])}`;
      cells.set(key, [...(cells.get(key) ?? []), vertex]);
    });
  });
  return vertices;
}

export function writeLength({ range, unit, value: old }: LengthAt, value: number): Edit[] {
  if (Math.abs(old - value) < 1e-12) return [];
  const text = unit ? `"${writeNumber(value / unit.si)} ${unit.name}"` : writeNumber(value);
  return [{ from: range[0], to: range[1], insert: text }];
}

export interface Move {
  vertex: Vertex;
  to: Point;
}

/**
 * Places where boundaries that meet in a T would come apart: a corner on the side of another region, when either moves. The corner
 * becomes a vertex of that side first.
 */
function listJoints(chains: readonly Chain[], vertices: readonly Vertex[], moved: readonly Vertex[]): { chain: number; index: number; at: Point }[] {
  const tolerance = findTolerance(chains);
  const joints: { chain: number; index: number; at: Point }[] = [];
  const fixed = vertices.filter((v) => v.corners.some((corner) => boundaries.has(chains[corner.chain]!.kind)));
  chains.forEach((chain, c) => {
    if (!boundaries.has(chain.kind)) return;
    const points = pointsOf(chain);
    listSegments(points, chain.closed).forEach((side, index) => {
      const ends = [index, (index + 1) % points.length];
      const sideMoves = moved.some((vertex) => vertex.corners.some((k) => k.chain === c && ends.includes(k.index)));
      for (const vertex of sideMoves ? fixed : moved) {
        if (!isWithinSegment(vertex.at, side, tolerance)) continue;
        if (!vertex.corners.some((corner) => boundaries.has(chains[corner.chain]!.kind))) continue;
        joints.push({ chain: c, index: index + 1, at: vertex.at });
      }
    });
  });
  return joints;
}

function isAlongSide(to: Point, chains: readonly Chain[], joints: readonly { chain: number; index: number }[]): boolean {
  const tolerance = findTolerance(chains);
  return joints.every(({ chain, index }) => {
    const points = pointsOf(chains[chain]!);
    return isWithinSegment(to, [points[index - 1]!, points[index % points.length]!], tolerance);
  });
}

export interface Moved {
  text: string;
  /** As they are in the text, but with the places of their numbers before the move. */
  chains: Chain[];
  vertices: Vertex[];
}

const movePoint = ({ x, y }: ChainPoint, [to_x, to_y]: Point): ChainPoint => ({ x: { ...x, value: to_x }, y: { ...y, value: to_y } });

/**
 * Prepares moves of vertices: what is costly is done once, so that a drag calls the result for every place of the mouse. Sides of
 * other regions on which the vertices lie follow.
 */
export function prepareMove(tree: CaseTree, chains: readonly Chain[], moved: readonly Vertex[], listed: readonly Vertex[] = listVertices(chains)) {
  const joints = listJoints(chains, listed, moved).toSorted((a, b) => {
    const start = pointsOf(chains[a.chain]!)[a.index - 1]!;
    return a.chain - b.chain || a.index - b.index || distance(start, a.at) - distance(start, b.at);
  });
  return (targets: readonly Point[]): Moved => {
    const places = new Map(moved.map((vertex, i) => [vertex, targets[i]!]));
    const slides = moved.length === 1 && isAlongSide(targets[0]!, chains, joints);
    const inserted = slides ? [] : joints;
    const placeOf = (at: Point) => targets[moved.findIndex((vertex) => vertex.at === at)] ?? at;
    const edits: Edit[] = [];
    const after = chains.slice();
    for (const [vertex, to] of places)
      for (const { chain, index } of vertex.corners) {
        const point = chains[chain]!.points[index]!;
        edits.push(...writeLength(point.x, to[0]), ...writeLength(point.y, to[1]));
        if (after[chain] === chains[chain]) after[chain] = { ...chains[chain]!, points: chains[chain]!.points.slice() };
        after[chain]!.points[index] = movePoint(point, to);
      }
    // From the last to the first, so that the indices of the others hold.
    for (const { chain, index, at } of inserted.toReversed()) {
      if (after[chain] === chains[chain]) after[chain] = { ...chains[chain]!, points: chains[chain]!.points.slice() };
      after[chain]!.points.splice(index, 0, movePoint(chains[chain]!.points[index - 1]!, placeOf(at)));
    }
    edits.push(...inserted.flatMap(({ chain, index, at }) => insertItem(tree, chains[chain]!.path, index, writePoint(placeOf(at)))));
    const vertices = inserted.length
      ? listVertices(after)
      : listed.map((vertex) => (places.has(vertex) ? { ...vertex, at: places.get(vertex)! } : vertex));
    return { text: applyEdits(tree.text, edits), chains: after, vertices };
  };
}

/** The text after vertices have moved. */
export function moveVertices(tree: CaseTree, chains: readonly Chain[], moves: readonly Move[], listed: readonly Vertex[] = listVertices(chains)): string {
  return prepareMove(tree, chains, moves.map(({ vertex }) => vertex), listed)(moves.map(({ to }) => to)).text;
}

/** A vertex in every boundary that passes through a place, or only in `chain` where that is no boundary. */
export function insertVertex(tree: CaseTree, chains: readonly Chain[], at: Point, only: number): string {
  const tolerance = Math.max(findTolerance(chains), 1e-9);
  const shared = boundaries.has(chains[only]!.kind);
  const edits: Edit[] = [];
  chains.forEach((chain, c) => {
    if (shared ? !boundaries.has(chain.kind) : c !== only) return;
    if (chain.single || chain.corners) return;
    listSegments(pointsOf(chain), chain.closed).forEach((side, index) => {
      if (isWithinSegment(at, side, tolerance)) edits.push(...insertItem(tree, chain.path, index + 1, writePoint(at)));
    });
  });
  return applyEdits(tree.text, edits);
}

const fewest = (chain: Chain) => (chain.closed ? 3 : chain.kind === "water" || chain.kind === "drawdown" ? 1 : 2);

/** Deletes a vertex from everything that shares it. */
export function deleteVertex(tree: CaseTree, chains: readonly Chain[], vertex: Vertex): string {
  const edits: Edit[] = [];
  for (const { chain: c, index } of vertex.corners) {
    const chain = chains[c]!;
    if (chain.kind === "monitor") continue;
    if (chain.single || chain.corners || chain.points.length <= fewest(chain))
      throw new EditFault(`“${chain.name}” would have fewer than ${fewest(chain)} points. Delete it as a whole instead.`);
    edits.push(...removeAt(tree, [...chain.path, index]));
  }
  return applyEdits(tree.text, edits);
}

/** Replaces all points of a chain. */
export function replacePoints(tree: CaseTree, chain: Chain, points: readonly Point[]): Edit[] {
  const first = chain.points[0]?.x.unit;
  if (first) throw new EditFault(`“${chain.name}” is written with units. Edit its points one by one, or in the text.`);
  return setValue(tree, chain.path, writePoints(points));
}

/** A text with further edits that need the tree after the ones before. */
export function applyInTurn(text: string, steps: readonly ((tree: CaseTree) => Edit[])[]): string {
  let result = text;
  for (const step of steps) {
    const { tree, fault } = readTree(result);
    if (!tree) throw new EditFault(`The text is not TOML: ${fault.text}`);
    result = applyEdits(result, step(tree));
  }
  return result;
}
