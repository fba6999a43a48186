// SPDX-License-Identifier: MIT
// The methods section: every paragraph can be drawn, numbered and copied.
import katex from "katex";
import { describe, expect, it } from "vitest";

import schema from "../../../contract/report.schema.json";
import type { InputTable, MethodParagraph, Report } from "../../contract";
import { writeMethods } from "./paragraphs";
import { writePlainFormula, writePlainMethods, writeTexMethods } from "./plainText";
import { quoteEach } from "./settings";

const allMethods = (schema.definitions.MethodParagraph as { enum: MethodParagraph[] }).enum;

const given = (value: unknown) => ({ value, given: true });
const input: InputTable = {
  analysis: { kind: given("strength_reduction") },
  stage: [
    { name: given("gravity"), damping: given(0.75), courant: given(0.9) },
    { name: given("slide"), damping: given(0.05), courant: given(0.9) },
  ],
  strength_reduction: { curve: { damping: given(0.05), smoothing: given("none") }, frozen: { enabled: given(false) } },
};

const make = (methods: MethodParagraph[], dimension: 2 | 3 = 2) =>
  writeMethods({ methods, result: { input }, model: { dimension } } as unknown as Report);

describe("writeMethods", () => {
  it("describes the extrapolation of the frozen factor and its interval", () => {
    const write = (frozen: InputTable, dimension = 2) => {
      const used = { ...input, strength_reduction: { frozen } };
      const report = { methods: ["frozen_factor"], result: { input: used }, model: { dimension } } as unknown as Report;
      const { paragraphs, cited } = writeMethods(report);
      return writePlainMethods(paragraphs, cited);
    };
    const two = write({ meshes: given(2), mesh_scatter: given(true) });
    // As unit.FrozenInterval has it.
    expect(two).toContain("F = (16 F_h/2 + 2 F_h − 5 F_2h) / 13");
    expect(two).toContain("of two meshers");
    expect(two).toContain("finer at corners of the ground");
    const others: InputTable[] = [{ meshes: given(2), mesh_scatter: given(false) }, { meshes: given(3) }];
    for (const other of others) {
      expect(write(other)).toContain("F = (16 F_h/2 + 2 F_h − 5 F_2h) / 13");
      expect(write(other)).toContain("takes from the finest and 1 %");
    }
    expect(write({ meshes: given(1) })).toContain("not extrapolated; on eight slopes");
    expect(write({ meshes: given(1) }, 3)).toContain("tetrahedra was 7 %");
    expect(two).toContain("largest of the distance of the two finest");
    expect(write({ meshes: given(2) }, 3)).toContain("largest of one and a half times the distance of the two finest");
    expect(write({ meshes: given(2), corner_refinement: given(1) })).not.toContain("corners");
  });

  it("names only what was used", () => {
    expect(make(["runout", "mohr_coulomb"]).paragraphs.map((paragraph) => paragraph.method)).toEqual([
      "mohr_coulomb",
      "runout",
    ]);
  });

  it("numbers equations and references in the order in which they come", () => {
    const { paragraphs, cited } = make(allMethods);
    const blocks = paragraphs.flatMap((paragraph) => paragraph.blocks);
    const numbers = blocks.flatMap((block) => ("number" in block ? [block.number] : []));
    expect(numbers).toEqual(numbers.map((_, i) => i + 1));
    const cites = blocks
      .flatMap((block) => ("pieces" in block ? block.pieces : []))
      .filter((piece) => piece.kind === "cite")
      .flatMap((piece) => piece.text.split(", ").map(Number));
    expect([...new Set(cites)]).toEqual(cited.map((_, i) => i + 1));
  });

  it.each([2, 3] as const)("is written in TeX that can be drawn, in %iD", (dimension) => {
    for (const method of allMethods) {
      for (const block of make([method], dimension).paragraphs[0]!.blocks) {
        const formulas =
          "pieces" in block
            ? block.pieces.filter((piece) => piece.kind === "math").map((piece) => piece.text)
            : [block.tex];
        for (const tex of formulas)
          expect(() => katex.renderToString(tex, { output: "mathml", strict: "error" })).not.toThrow();
      }
    }
  });

  it("gives the formula of volumetric averaging once, whichever smoothing was used", () => {
    const count = (methods: MethodParagraph[]) => writePlainMethods(make(methods).paragraphs, []).split("Δε̄_vol,i =").length - 1;
    expect(count(["strain_smoothing"])).toBe(1);
    expect(count(["stable_smoothing"])).toBe(1);
    expect(count(["strain_smoothing", "stable_smoothing"])).toBe(1);
  });
});

describe("methods of wet ground", () => {
  const wet: InputTable = {
    ...input,
    stage: [
      { name: given("gravity"), water: given("held"), drag: given("implicit") },
      { name: given("rain"), water: given("flows"), drag: given("explicit"), water_damping: given(0.1) },
    ],
    materials: {
      silt: { water: { retention: given("van_genuchten"), relative_conductivity: given("mualem") } },
      rock: { model: given("linear_elastic") },
    },
    hydraulic: [{ condition: given("rain") }, { condition: given("total_head") }, { condition: given("rain") }],
  };
  const write = (methods: MethodParagraph[]) => {
    const report = { methods, result: { input: wet }, model: { dimension: 2 } } as unknown as Report;
    const { paragraphs, cited } = writeMethods(report);
    return writePlainMethods(paragraphs, cited);
  };

  it("name the laws that the soils have, and no other", () => {
    const text = write(["soil_water"]);
    expect(text).toContain("p_ref");
    expect(text).toContain("Mualem, Y. (1976)");
    for (const other of ["Gardner", "Hillel", "Khalili", "straight line"]) expect(text).not.toContain(other);
  });

  it("state where pressures are constant, where drag is explicit, and each condition once", () => {
    expect(write(["held_pressures"])).toContain("held in stage “gravity”:");
    expect(write(["two_phase"])).toContain("(explicit drag) in stage “rain”");
    expect(write(["hydraulic_conditions"]).split("counted as runoff")).toHaveLength(2);
    expect(write(["hydraulic_conditions"])).not.toContain("is prescribed");
  });

  it("do not call two phases one", () => {
    expect(write(["material_point_method"])).toContain("The soil is a single phase");
    expect(write(["material_point_method", "two_phase"])).not.toContain("single phase");
    expect(write(["material_point_method", "seeping"])).toContain("which have one velocity");
    expect(write(["seeping"])).toContain("conjugate gradients");
    expect(write(["hydraulic_conditions", "seeping"])).not.toContain("impulse");
    expect(write(["time_step"])).not.toContain("frictionless");
    expect(write(["time_step", "two_phase"])).toContain("frictionless");
  });
});

describe("copies", () => {
  it("leave no TeX in the plain text", () => {
    const { paragraphs, cited } = make(allMethods);
    expect(writePlainMethods(paragraphs, cited)).not.toMatch(/[\\${}]|\[@/);
  });

  it("balance the braces and dollars of the TeX", () => {
    const { paragraphs, cited } = make(allMethods);
    const text = writeTexMethods(paragraphs, cited);
    expect(text.split("{").length).toBe(text.split("}").length);
    expect(text.split("$").length % 2).toBe(1);
    expect(text).not.toMatch(/[^\\]%/);
  });

  it("write short formulas in plain characters", () => {
    expect(writePlainFormula("\\sigma_1\\ge\\sigma_2")).toBe("σ_1 ≥ σ_2");
    expect(writePlainFormula("c/\\tan\\,\\varphi")).toBe("c/tan φ");
    expect(writePlainFormula("10^{-3}")).toBe("10⁻³");
  });
});

it("quotes settings by value, and trials only where they are enabled", () => {
  expect(quoteEach(input, "damping")).toBe(
    "0.75 in stage “gravity” and 0.05 in stage “slide” and the trials of the curve",
  );
  expect(quoteEach(input, "courant")).toBe("0.9 throughout");
  expect(quoteEach(input, "mass_scaling")).toBe("");
});

describe("methods of rooted ground", () => {
  const write = (methods: MethodParagraph[], roots: InputTable[]) => {
    const rooted = { methods, result: { input: { ...input, roots } }, model: { dimension: 2 } } as unknown as Report;
    const { paragraphs, cited } = writeMethods(rooted);
    return writePlainMethods(paragraphs, cited);
  };

  it("describe the computation of the cohesion of roots, and cite no source where it is given", () => {
    const bundle = write(["root_cohesion"], [{ bundle: { model: given("fibre_bundle") } }]);
    expect(bundle).toContain("Pollen, N., Simon, A. (2005)");
    expect(bundle).not.toContain("Waldron");
    const plain = write(["root_cohesion"], [{ cohesion: given(5) }]);
    expect(plain).toContain("Its value is given.");
    for (const other of ["Pollen", "Waldron", "fibre"]) expect(plain).not.toContain(other);
  });

  it("cite the rooted model beside the clay model", () => {
    const text = write(["modified_cam_clay", "rooted_cam_clay"], []);
    for (const name of ["Tamagnini, R. (2004)", "Świtała, B. M."]) expect(text).toContain(name);
    expect(write(["modified_cam_clay"], [])).not.toContain("Świtała");
  });
});
