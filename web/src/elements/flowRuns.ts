// SPDX-License-Identifier: MIT
/** The strength reductions of the finite elements, with what their figures and tables add to the results; their mesh and fields, decoded. */
import { computed } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";

import { load, loadIntegers, loadPlaces, report } from "../state";
import type { QuadraticMesh } from "./fieldPainter";

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

interface ElementFields {
  mesh: QuadraticMesh;
  run: FlowRun;
  displacement: Float32Array;
  strain: Float32Array;
  yields: Float32Array;
}

/** null until they are there, and where there are none. */
export function useFields(run: FlowRun | undefined): ElementFields | null {
  const [fields, setFields] = useState<ElementFields | null>(null);
  useEffect(() => {
    const mesh = report.value.finite_elements?.mesh;
    if (!mesh || !run?.fields) return setFields(null);
    const { displacement, shear_strain, yields } = run.fields;
    let wanted = true;
    Promise.all([
      loadPlaces(mesh.nodes),
      loadIntegers(mesh.elements),
      load(displacement),
      load(shear_strain),
      load(yields),
    ]).then(
      ([nodes, numbers, moves, strain, plastic]) =>
        wanted &&
        setFields({
          mesh: { nodes, elements: Uint32Array.from(numbers) },
          run,
          displacement: moves,
          strain,
          yields: plastic,
        }),
      () => wanted && setFields(null),
    );
    return () => void (wanted = false);
  }, [run]);
  return fields?.run === run ? fields : null;
}
