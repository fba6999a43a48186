// SPDX-License-Identifier: MIT
/** Decodes mesh and fields of FEM. */
import { useEffect, useState } from "preact/hooks";

import { load, loadIntegers, loadPlaces, report } from "../state";
import type { QuadraticMesh } from "./fieldPainter";
import type { FlowRun } from "./flowRuns";

export interface ElementFields {
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
