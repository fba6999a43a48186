// SPDX-License-Identifier: MIT
/** Decodes the fields of both bounds. */
import { useEffect, useState } from "preact/hooks";

import type { BoundsDrawn } from "../contract";
import type { Triangles } from "../drawing/trianglePainter";
import { load, loadIntegers, loadPlaces } from "../state";

export interface BoundsFields {
  holds: { mesh: Triangles; middles: number[][]; stress: Float32Array; utilisation: Float32Array } | null;
  moves: { mesh: Triangles; nodes: Float64Array; velocity: Float32Array; shear_rate: Float32Array } | null;
}

/** Every triangle on nodes of its own, so that it has one colour; `stride`: nodes of a triangle, corners first. */
export function separate(nodes: ArrayLike<number>, triangles: ArrayLike<number>, stride: number): Triangles {
  const count = triangles.length / stride;
  const own = new Float64Array(6 * count);
  for (let t = 0; t < count; ++t)
    for (const corner of [0, 1, 2])
      for (const d of [0, 1]) own[6 * t + 2 * corner + d] = nodes[2 * triangles[stride * t + corner]! + d]!;
  return { nodes: own, triangles: Uint32Array.from({ length: 3 * count }, (_, i) => i) };
}

/** The value of each triangle at its three nodes. */
export function repeat(values: Float32Array): Float32Array {
  return Float32Array.from({ length: 3 * values.length }, (_, i) => values[Math.floor(i / 3)]!);
}

function findMiddles({ nodes }: Triangles): number[][] {
  return Array.from({ length: nodes.length / 6 }, (_, t) =>
    [0, 1].map((d) => (nodes[6 * t + d]! + nodes[6 * t + 2 + d]! + nodes[6 * t + 4 + d]!) / 3),
  );
}

async function loadHolds(field: BoundsDrawn["holds"]): Promise<BoundsFields["holds"]> {
  if (!field) return null;
  const [nodes, triangles, stress, utilisation] = await Promise.all([
    loadPlaces(field.nodes),
    loadIntegers(field.triangles),
    load(field.stress),
    load(field.utilisation),
  ]);
  const mesh = separate(nodes, triangles, 3);
  return { mesh, middles: findMiddles(mesh), stress, utilisation: repeat(utilisation) };
}

async function loadMoves(field: BoundsDrawn["moves"]): Promise<BoundsFields["moves"]> {
  if (!field) return null;
  const [nodes, triangles, velocity, shear_rate] = await Promise.all([
    loadPlaces(field.nodes),
    loadIntegers(field.triangles),
    load(field.velocity),
    load(field.shear_rate),
  ]);
  return { mesh: separate(nodes, triangles, 6), nodes, velocity, shear_rate: repeat(shear_rate) };
}

/** null until they are there. */
export function useBounds(bounds: BoundsDrawn | undefined): BoundsFields | null {
  const [fields, setFields] = useState<BoundsFields | null>(null);
  useEffect(() => {
    if (!bounds) return;
    let wanted = true;
    Promise.all([loadHolds(bounds.holds), loadMoves(bounds.moves)]).then(
      ([holds, moves]) => wanted && setFields({ holds, moves }),
      () => wanted && setFields({ holds: null, moves: null }),
    );
    return () => void (wanted = false);
  }, [bounds]);
  return fields;
}
