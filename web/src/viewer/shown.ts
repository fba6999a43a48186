/** What is shown now: the decoded arrays of the sequence and field, and the numbers drawn from them. */
import { computed, effect, signal } from "@preact/signals";

import type { Sequence, SequenceField } from "../contract";
import { readIntegers, readValues } from "../data";
import { fieldName, frameIndex, load, report, sequence } from "../state";
import type { Vec } from "./camera";
import { handLimits, inSpace, layers, limitMode } from "./settings";
import { findMovedLimit } from "./moved";
import { findStrainRidge } from "./ridge";

export interface Shown {
  sequence: Sequence;
  field: SequenceField;
  /** [frame][point][dimension] [m] */
  positions: Float32Array;
  /** [frame][point] */
  values: Float32Array;
  /** Number of each point, as in the results. */
  ids: Float32Array;
  /** Mean distance of the points [m]. */
  spacing: number;
  /** Corners of the box around the model and around the first and last frames [m]. */
  box: [Vec, Vec];
}

/** Stays on the last arrays while the next ones are decoded. */
export const shown = signal<Shown | null>(null);
export const failure = signal("");

export const field = computed<SequenceField | null>(() => {
  const fields = sequence.value?.fields ?? [];
  return fields.find((f) => f.name === fieldName.value) ?? fields[0] ?? null;
});

/** Edges of the background mesh, pairs of points x y z [m]; decoded when the layer is switched on. */
export const meshEdges = signal<Float32Array | null>(null);

/** One frame of an array with `size` numbers per point; a view, not a copy. */
export function takeFrame(array: Float32Array, frame: number, count: number, size = 1): Float32Array {
  return array.subarray(frame * count * size, (frame + 1) * count * size);
}

/** Mean distance of points, from the cells of a grid that hold one: (volume / points)^(1 / dimension). */
export function measureSpacing(positions: Float32Array, dimension: number, cell: number): number {
  const cells = new Set<string>();
  const count = positions.length / dimension;
  for (let i = 0; i < count; ++i) {
    let key = "";
    for (let k = 0; k < dimension; ++k) key += Math.floor(positions[dimension * i + k]! / cell) + ",";
    cells.add(key);
  }
  return cell * Math.pow(cells.size / Math.max(1, count), 1 / dimension);
}

function measureArea(corners: number[][]): number {
  let twice = 0;
  corners.forEach(([x, y], i) => {
    const [nextX, nextY] = corners[(i + 1) % corners.length]!;
    twice += x! * nextY! - nextX! * y!;
  });
  return Math.abs(twice) / 2;
}

function findBox(positions: Float32Array, current: Sequence): [Vec, Vec] {
  const { model } = report.value;
  const low: Vec = [Infinity, Infinity, 0];
  const high: Vec = [-Infinity, -Infinity, 0];
  const include = (at: ArrayLike<number>) => {
    for (let k = 0; k < Math.min(3, at.length); ++k) {
      if (at[k]! < low[k]!) low[k] = at[k]!;
      if (at[k]! > high[k]!) high[k] = at[k]!;
    }
  };
  for (const polygon of model.polygons) polygon.points.forEach(include);
  for (const line of model.boundaries.flatMap((b) => b.lines)) line.forEach(include);
  for (const frame of [0, current.frames.length - 1]) {
    const at = takeFrame(positions, frame, current.point_count, model.dimension);
    for (let i = 0; i < at.length; i += model.dimension) include(at.subarray(i, i + model.dimension));
  }
  if (model.dimension === 3) [low[2], high[2]] = [model.bounds[0][2] ?? 0, model.bounds[1][2] ?? 0];
  return [low, high];
}

let boxOf: { id: string; box: [Vec, Vec]; spacing: number } | null = null;

async function loadShown(current: Sequence, wanted: SequenceField): Promise<void> {
  const [positions, values, ids] = await Promise.all([load(current.positions), load(wanted.values), load(current.ids)]);
  if (sequence.peek() !== current || field.peek() !== wanted) return;
  if (boxOf?.id !== current.id) {
    const { dimension, mesh } = report.value.model;
    const first = takeFrame(positions, 0, current.point_count, dimension);
    const { polygons, bounds } = report.value.model;
    const depth = dimension === 3 ? bounds[1][2]! - bounds[0][2]! : 1;
    const soil = depth * polygons.reduce((sum, polygon) => sum + measureArea(polygon.points), 0);
    const spacing =
      soil > 0
        ? Math.pow(soil / current.point_count, 1 / dimension)
        : measureSpacing(first, dimension, mesh.mean_size || 1);
    boxOf = { id: current.id, box: findBox(positions, current), spacing };
  }
  shown.value = { sequence: current, field: wanted, positions, values, ids, spacing: boxOf.spacing, box: boxOf.box };
}

async function loadMesh(): Promise<void> {
  const { mesh, dimension } = report.value.model;
  if (!mesh.positions || !mesh.cells) return;
  const [positions, cells] = await Promise.all([readValues(mesh.positions), readIntegers(mesh.cells)]);
  const [size, nodes] = [dimension + 1, positions.length / dimension];
  const known = new Set<number>();
  for (let c = 0; c < cells.length; c += size) {
    for (let i = 0; i < size; ++i) {
      for (let j = i + 1; j < size; ++j) {
        const [a, b] = [cells[c + i]!, cells[c + j]!];
        known.add(Math.min(a, b) * nodes + Math.max(a, b));
      }
    }
  }
  const edges = new Float32Array(known.size * 6);
  let at = 0;
  for (const key of known) {
    for (const node of [Math.floor(key / nodes), key % nodes]) {
      for (let k = 0; k < 3; ++k) edges[at++] = k < dimension ? positions[node * dimension + k]! : 0;
    }
  }
  meshEdges.value = edges;
}

export type Line = [number, number][];
/** Corners of the slip surface in the shown frame [m]; empty where there is none. */
export const slipSurface = signal<Line>([]);
/** Likewise the ridge of the deviatoric strain. */
export const strainRidge = signal<Line>([]);

/** Displacement above which soil counts as moved [m]: a hundredth of the slope's height, as for the moved volume. */
export const movedThreshold = computed(() => 0.01 * report.value.model.slope_height);

type Tracer = (positions: Float32Array, values: Float32Array, spacing: number) => Line;

/** Draws `line` from the field called `name`; only in a section. */
async function trace(now: Shown, index: number, line: { value: Line }, name: string, find: Tracer): Promise<void> {
  const found = now.sequence.fields.find((f) => f.name === name);
  const { dimension } = report.value.model;
  if (!found || dimension === 3) return void (line.value = []);
  const values = await load(found.values);
  if (shown.peek()?.sequence !== now.sequence || frame.peek() !== index) return;
  const count = now.sequence.point_count;
  const positions = takeFrame(now.positions, index, count, dimension);
  line.value = find(positions, takeFrame(values, index, count), now.spacing);
}

const findLimit: Tracer = (x, u, spacing) => findMovedLimit(x, u, spacing, movedThreshold.value);

/** Decodes whatever the page asks to see; returns what ends that. */
export function startLoading(): () => void {
  const fail = (error: unknown) => void (failure.value = error instanceof Error ? error.message : String(error));
  const ends = [
    effect(() => {
      if (sequence.value && field.value) loadShown(sequence.value, field.value).catch(fail);
    }),
    effect(() => {
      if (layers.value.mesh && !meshEdges.peek()) loadMesh().catch(fail);
    }),
    effect(() => {
      const now = shown.value;
      if (layers.value.slip && now) trace(now, frame.value, slipSurface, "displacement", findLimit).catch(fail);
    }),
    effect(() => {
      const now = shown.value;
      if (layers.value.ridge && now)
        trace(now, frame.value, strainRidge, "deviatoric_strain", findStrainRidge).catch(fail);
    }),
    effect(() => {
      if (report.value.model.dimension === 3) inSpace.value = true;
    }),
  ];
  return () => ends.forEach((end) => end());
}

/** Index of the frame, kept within the shown sequence while another one is decoded. */
export const frame = computed(() => Math.min(frameIndex.value, (shown.value?.sequence.frames.length ?? 1) - 1));

/** Whether colours run from the middle. */
export const diverging = computed(() => shown.value?.field.diverging ?? false);

/** Ends of the colour scale [SI]. */
export const limits = computed<[number, number]>(() => {
  const now = shown.value;
  if (!now) return [0, 1];
  if (limitMode.value === "hand") return handLimits.value;
  let [low, high] = now.field.scale;
  if (limitMode.value === "frame") {
    [low, high] = [Infinity, -Infinity];
    for (const value of takeFrame(now.values, frame.value, now.sequence.point_count)) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
    if (!(low <= high)) return [0, 1];
    if (now.field.diverging) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
  }
  return high > low ? [low, high] : [low, low + 1e-9];
});
