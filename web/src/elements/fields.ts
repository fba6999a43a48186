// SPDX-License-Identifier: MIT
/** The strength reductions by FEM with their mesh and fields, decoded, and how a field on quadratic triangles is painted. */
import { computed } from "@preact/signals";

import type { ElementsDrawn, PackedElementFields } from "../contract";
import { paintTriangles, type Pen } from "../drawing/pen";
import { load, loadIntegers, loadPlaces, report, useLoaded } from "../state";
import type { Scale } from "../viewer/scale";

export const flowRuns = computed(() => {
  const { result, finite_elements: drawn } = report.value;
  return (result.fem?.runs ?? []).map((run, i) => ({
    ...run,
    title:
      run.davis ? `Davis ${run.davis.toUpperCase()}` : run.flow === "associated" ? "associated flow, ψ = φ" : "ψ as given",
    trials: [...run.trials].sort((a, b) => a.factor - b.factor),
    /** One, or one of each side where the soil moves to both [m]. */
    slip_lines: run.sides?.map((side) => side.points) ?? (run.slip_line.length > 0 ? [run.slip_line] : []),
    mesh: drawn?.mesh,
    fields: drawn?.fields[i] ?? undefined,
  }));
});

/** The strength reduction in progress, if its mesh can be drawn. */
export const drawnReduction = computed(() => {
  const { reduction } = report.value;
  return reduction?.mesh && reduction.fields ? reduction : null;
});

/** A finished strength reduction, or that in progress. */
export interface Drawn {
  mesh?: ElementsDrawn["mesh"];
  fields?: PackedElementFields;
}

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
export const useFields = (run: Drawn | undefined) =>
  useLoaded(() => run?.mesh && run.fields && loadFields(run.mesh, run.fields), run);

interface QuadraticMesh {
  /** [node][2], [element][6]: corners, then the middles of the sides 0–1, 1–2, 2–0. */
  nodes: Float64Array;
  elements: Uint32Array;
}

/** Corners and middles make four triangles with straight sides. */
const parts = [
  [0, 3, 5],
  [3, 1, 4],
  [5, 4, 2],
  [3, 4, 5],
] as const;

/** Places of the nodes moved by `scale` times their displacement. */
export function moveNodes(mesh: QuadraticMesh, displacement: Float32Array, scale: number): Float64Array {
  return scale === 0 ? mesh.nodes : mesh.nodes.map((x, i) => x + scale * displacement[i]!);
}

/** `nodes` are those of the mesh or moved ones, `values` one for each. */
export function paintField(
  pen: Pen,
  mesh: QuadraticMesh,
  nodes: Float64Array,
  values: Float32Array,
  colours: Uint8Array,
  scale: Scale,
  opacity = 1,
): void {
  const triangles = new Uint32Array(2 * mesh.elements.length);
  for (let e = 0; e < mesh.elements.length; e += 6)
    parts.forEach((part, k) => part.forEach((c, i) => (triangles[2 * e + 3 * k + i] = mesh.elements[e + c]!)));
  paintTriangles(pen, { nodes, triangles }, values, colours, scale, opacity);
}

/** Sides of the elements; curved ones through their middles. */
export function drawMesh({ context, place, theme }: Pen, mesh: QuadraticMesh, nodes: Float64Array): void {
  const at = (n: number) => place([nodes[2 * n]!, nodes[2 * n + 1]!]);
  context.beginPath();
  for (let e = 0; e < mesh.elements.length; e += 6) {
    const element = mesh.elements.subarray(e, e + 6);
    context.moveTo(...at(element[0]!));
    for (const k of [3, 1, 4, 2, 5, 0]) context.lineTo(...at(element[k]!));
  }
  context.globalAlpha = 0.35;
  context.strokeStyle = theme.ink;
  context.lineWidth = 0.6;
  context.stroke();
  context.globalAlpha = 1;
}

/** A cross in every element that yields. */
export function drawYielding(
  { context, place, camera }: Pen,
  mesh: QuadraticMesh,
  nodes: Float64Array,
  yields: Float32Array,
): void {
  context.beginPath();
  for (let e = 0; e < yields.length; ++e) {
    if (!yields[e]) continue;
    const corners = [0, 1, 2].map((k) => mesh.elements[6 * e + k]!);
    const mean = [0, 1].map((d) => corners.reduce((sum, n) => sum + nodes[2 * n + d]!, 0) / 3);
    const [x, y] = place(mean);
    const size = Math.min(3.5, Math.max(1.2, 0.14 * camera.scale));
    context.moveTo(x - size, y - size);
    context.lineTo(x + size, y + size);
    context.moveTo(x - size, y + size);
    context.lineTo(x + size, y - size);
  }
  context.strokeStyle = "#ffffff";
  context.lineWidth = 2.6;
  context.stroke();
  context.strokeStyle = "#111111";
  context.lineWidth = 1;
  context.stroke();
}
