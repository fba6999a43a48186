// SPDX-License-Identifier: MIT
/** The strength reductions of the finite elements, with what their figures and tables add to the results; their mesh and fields, decoded. */
import { computed } from "@preact/signals";

import type { ElementsDrawn, PackedElementFields } from "../contract";
import { load, loadIntegers, loadPlaces, report, useLoaded } from "../state";

export const flowRuns = computed(() => {
  const { result, finite_elements: drawn } = report.value;
  return (result.fem?.runs ?? []).map((run, i) => ({
    ...run,
    title: run.flow === "associated" ? "associated flow, ψ = φ" : "ψ as given",
    trials: [...run.trials].sort((a, b) => a.factor - b.factor),
    /** One, or one of each side where the soil moves to both [m]. */
    slip_lines: run.sides?.map((side) => side.points) ?? (run.slip_line.length > 0 ? [run.slip_line] : []),
    fields: drawn?.fields[i] ?? undefined,
  }));
});

/** One strength reduction: with the flow rule as given, or associated. */
export type FlowRun = (typeof flowRuns.value)[number];

async function loadFields(mesh: ElementsDrawn["mesh"], { displacement, shear_strain, yields }: PackedElementFields) {
  const [nodes, elements] = await Promise.all([loadPlaces(mesh.nodes), loadIntegers(mesh.elements)]);
  const [moves, strain, plastic] = await Promise.all([displacement, shear_strain, yields].map(load));
  return {
    mesh: { nodes, elements: Uint32Array.from(elements) },
    displacement: moves!,
    strain: strain!,
    yields: plastic!,
  };
}

/** Mesh and fields of the finite elements, decoded. */
export const useFields = (run: FlowRun | undefined) =>
  useLoaded(() => {
    const mesh = report.value.finite_elements?.mesh;
    return mesh && run?.fields && loadFields(mesh, run.fields);
  }, run);
