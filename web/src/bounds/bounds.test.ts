// SPDX-License-Identifier: MIT
// The marks and meshes of limit analysis.
import { describe, expect, it } from "vitest";

import { findPrincipal, repeat, separate, thinOut } from "./fields";

describe("findPrincipal", () => {
  it("finds size and direction of the larger compression", () => {
    const vertical = findPrincipal(-1, -3, 0);
    expect([vertical.most, vertical.least]).toEqual([-3, -1]);
    expect(Math.abs(Math.cos(vertical.angle))).toBeCloseTo(0);
    const horizontal = findPrincipal(-3, -1, 0);
    expect(Math.abs(Math.sin(horizontal.angle))).toBeCloseTo(0);
    // Pure shear: compression along the falling diagonal.
    const shear = findPrincipal(0, 0, 2);
    expect([shear.most, shear.least]).toEqual([-2, 2]);
    expect(Math.tan(shear.angle)).toBeCloseTo(-1);
  });
});

describe("thinOut", () => {
  it("keeps one place of each square", () => {
    expect(
      thinOut(
        [
          [1, 1],
          [2, 2],
          [11, 1],
          [1, 11],
        ],
        10,
      ),
    ).toEqual([0, 2, 3]);
  });
});

describe("separate", () => {
  it("gives each triangle its own corners and one value", () => {
    const nodes = Float32Array.from([0, 0, 1, 0, 0, 1, 1, 1]);
    const mesh = separate(nodes, [0, 1, 2, 1, 3, 2], 3);
    expect(Array.from(mesh.nodes)).toEqual([0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1]);
    expect(Array.from(mesh.triangles)).toEqual([0, 1, 2, 3, 4, 5]);
    expect(Array.from(repeat(Float32Array.from([5, 7])))).toEqual([5, 5, 5, 7, 7, 7]);
  });
});
