// SPDX-License-Identifier: MIT
/** Edges of meshes counted by hand, and the length of the arrow of the key. */
import { expect, it } from "vitest";

import { roundDown } from "./arrows";
import { findEdges } from "./meshEdges";

it("draws every side of triangles once", () => {
  // Two triangles with a common side.
  expect(findEdges([0, 1, 2, 2, 1, 3], 3, 4).length).toBe(5);
});

it("draws only the surface of tetrahedra", () => {
  // Four tetrahedra around node 4 within a larger one: the lines to the node in the middle are inside.
  const cells = [4, 1, 2, 3, 0, 4, 2, 3, 0, 1, 4, 3, 0, 1, 2, 4];
  const edges = findEdges(cells, 4, 5);
  expect(edges.length).toBe(6);
  expect(edges.some(([a, b]) => a === 4 || b === 4)).toBe(false);
});

it("rounds the length of the key down to 1, 2 or 5", () => {
  expect([9.3, 5, 4.99, 0.31, 0.0012].map(roundDown)).toEqual([5, 5, 2, 0.2, 0.001]);
});
