// SPDX-License-Identifier: MIT
/** The states of the water in time, and their fields: decoded, as quantities that are drawn. */
import { computed } from "@preact/signals";

import type { WaterMesh, WaterShown, WaterState } from "../contract";
import type { Triangles } from "../drawing/pen";
import { load, loadIntegers, loadPlaces, report, useLoaded } from "../state";

export type ShownWater = WaterState & WaterShown;

/** States of the water and the mesh of their fields. */
export interface WaterStates {
  states: ShownWater[];
  water_mesh?: WaterMesh;
}

/** The last state is that which the methods began with; none in dry ground. */
export const startWater = computed<WaterStates>(() => {
  const { result, model } = report.value;
  const states = (result.water_states ?? []).map((state, i) => ({ ...state, ...model.water[i]! }));
  return { states, water_mesh: model.water_mesh };
});

export type WaterQuantity = "pressure" | "head" | "saturation";

export interface WaterArrays {
  state: ShownWater;
  mesh: Triangles;
  /** [node] [Pa], [m]. */
  pressure: Float32Array;
  head: Float64Array;
  /** [triangle]; [triangle][2] [m/s]. */
  saturation: Float32Array | null;
  velocity: Float32Array | null;
}

async function loadState(state: ShownWater, told: WaterMesh | undefined): Promise<WaterArrays | null> {
  const { fields } = state;
  if (!told || !fields) return null;
  const [nodes, numbers, pressure] = await Promise.all([
    loadPlaces(told.nodes),
    loadIntegers(told.elements),
    load(fields.pressure),
  ]);
  return {
    state,
    mesh: { nodes, triangles: Uint32Array.from(numbers) },
    pressure,
    head: Float64Array.from(pressure, (p, i) => nodes[2 * i + 1]! + p / told.unit_weight),
    saturation: fields.saturation ? await load(fields.saturation) : null,
    velocity: fields.velocity ? await load(fields.velocity) : null,
  };
}

/** null until they are there, and where there are none. */
export const useWaterArrays = (state: ShownWater | undefined, mesh: WaterMesh | undefined): WaterArrays | null =>
  useLoaded(() => state && loadState(state, mesh), state);

/** The mesh and a value for each of its nodes; of a quantity by triangle each triangle has nodes of its own. */
export function takeQuantity(
  arrays: WaterArrays,
  quantity: WaterQuantity,
): { mesh: Triangles; values: ArrayLike<number> } | null {
  if (quantity !== "saturation") return { mesh: arrays.mesh, values: arrays[quantity] };
  const { saturation, mesh } = arrays;
  if (!saturation) return null;
  const nodes = new Float64Array(2 * mesh.triangles.length);
  mesh.triangles.forEach((n, i) => nodes.set(mesh.nodes.subarray(2 * n, 2 * n + 2), 2 * i));
  return {
    mesh: { nodes, triangles: Uint32Array.from(mesh.triangles.keys()) },
    values: Float32Array.from(mesh.triangles.keys(), (i) => saturation[Math.floor(i / 3)]!),
  };
}

/** Least and greatest value at the nodes of triangles. */
export function findLimits({ mesh, values }: { mesh: Triangles; values: ArrayLike<number> }): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const n of mesh.triangles) {
    low = Math.min(low, values[n]!);
    high = Math.max(high, values[n]!);
  }
  return low <= high ? [low, high] : [0, 1];
}

type Segment = [[number, number], [number, number]];

/** The pieces of the line on which a field that is linear on triangles has a value [m]. */
export function traceLevel({ nodes, triangles }: Triangles, values: ArrayLike<number>, level: number): Segment[] {
  const pieces: Segment[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const ends: [number, number][] = [];
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [triangles[t + k]!, triangles[t + ((k + 1) % 3)]!];
      if (values[a]! >= level === values[b]! >= level) continue;
      const fraction = (level - values[a]!) / (values[b]! - values[a]!);
      const at = (d: number) => nodes[2 * a + d]! + fraction * (nodes[2 * b + d]! - nodes[2 * a + d]!);
      ends.push([at(0), at(1)]);
    }
    if (ends.length === 2) pieces.push(ends as Segment);
  }
  return pieces;
}
