// SPDX-License-Identifier: MIT
/** The lines of the background mesh: all of them in a section, those on the surface of a mesh in space. */
import { effect, signal } from "@preact/signals";

import { readIntegers, readPlaces } from "../data";
import { report } from "../state";
import { layers } from "./settings";
import { fail } from "./shown";

/** Pairs of points x y z [m]; decoded when the layer is switched on. */
export const meshEdges = signal<Float64Array | null>(null);

/**
 * Pairs of nodes, each once. `cells` [element][nodes per element]: triangles give all their sides; of tetrahedra only
 * faces that belong to one element count.
 */
export function findEdges(cells: ArrayLike<number>, nodesPerCell: 3 | 4, nodes: number): [number, number][] {
  const faces = nodesPerCell === 3 ? splitCells(cells, 3) : findSurface(cells, nodes);
  const known = new Set<number>();
  for (const face of faces) {
    face.forEach((a, i) => {
      const b = face[(i + 1) % face.length]!;
      known.add(Math.min(a, b) * nodes + Math.max(a, b));
    });
  }
  return Array.from(known, (key) => [Math.floor(key / nodes), key % nodes]);
}

function splitCells(cells: ArrayLike<number>, size: number): number[][] {
  const take = (c: number) => Array.from({ length: size }, (_, i) => cells[c * size + i]!);
  return Array.from({ length: cells.length / size }, (_, c) => take(c));
}

/** Faces of tetrahedra that belong to one element only. */
function findSurface(cells: ArrayLike<number>, nodes: number): Iterable<number[]> {
  const single = new Map<string, number[]>();
  for (const cell of splitCells(cells, 4)) {
    for (let left = 0; left < 4; ++left) {
      const face = cell.filter((_, i) => i !== left).sort((a, b) => a - b);
      const key = `${face[0]! * nodes + face[1]!},${face[2]}`;
      if (!single.delete(key)) single.set(key, face);
    }
  }
  return single.values();
}

async function loadMeshEdges(): Promise<void> {
  const { mesh, dimension } = report.value.model;
  if (!mesh.positions || !mesh.cells) return;
  const [positions, cells] = await Promise.all([readPlaces(mesh.positions), readIntegers(mesh.cells)]);
  const pairs = findEdges(cells, dimension === 3 ? 4 : 3, positions.length / dimension);
  const edges = new Float64Array(pairs.length * 6);
  pairs.flat().forEach((node, at) => {
    for (let k = 0; k < dimension; ++k) edges[3 * at + k] = positions[node * dimension + k]!;
  });
  meshEdges.value = edges;
}

/** Decodes the mesh when its layer is switched on; returns what ends that. */
export function startMesh(): () => void {
  return effect(() => {
    if (layers.value.mesh && !meshEdges.peek()) loadMeshEdges().catch(fail);
  });
}
