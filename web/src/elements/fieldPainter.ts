// SPDX-License-Identifier: MIT
/** Paints a field on a mesh of quadratic triangles pixel by pixel: colours run as the shape functions do. */
import type { Pen } from "../drawing/pen";
import { findColour } from "../viewer/colours";
import type { Scale } from "../viewer/scale";

export interface QuadraticMesh {
  /** [node][2], [element][6]: corners, then the middles of the sides 0–1, 1–2, 2–0. */
  nodes: Float32Array;
  elements: Uint32Array;
}

/** Corners and middles make four triangles with straight sides. */
const parts = [
  [0, 3, 5],
  [3, 1, 4],
  [5, 4, 2],
  [3, 4, 5],
] as const;

export function countElements(mesh: QuadraticMesh): number {
  return mesh.elements.length / 6;
}

/** Places of the nodes moved by `scale` times their displacement. */
export function moveNodes(mesh: QuadraticMesh, displacement: Float32Array, scale: number): Float32Array {
  return scale === 0 ? mesh.nodes : mesh.nodes.map((x, i) => x + scale * displacement[i]!);
}

/** `nodes` are those of the mesh or moved ones, `values` one for each. */
export function paintField(
  pen: Pen,
  mesh: QuadraticMesh,
  nodes: Float32Array,
  values: Float32Array,
  colours: Uint8Array,
  scale: Scale,
): void {
  const { camera, density, context } = pen;
  const [width, height] = [Math.round(camera.width * density), Math.round(camera.height * density)];
  const image = new ImageData(width, height);
  const pixels = new Uint32Array(image.data.buffer);
  const table = new Uint32Array(colours.buffer, colours.byteOffset, 256);
  const [cx, cy] = camera.centre;
  const s = camera.scale * density;
  const px = (n: number) => cx * density + (nodes[2 * n]! - camera.target[0]) * s;
  const py = (n: number) => cy * density - (nodes[2 * n + 1]! - camera.target[1]) * s;
  for (let e = 0; e < mesh.elements.length; e += 6)
    for (const [i, j, k] of parts) {
      const [a, b, c] = [mesh.elements[e + i]!, mesh.elements[e + j]!, mesh.elements[e + k]!];
      const [ax, ay, bx, by, dx, dy] = [px(a), py(a), px(b), py(b), px(c), py(c)];
      const area = (bx - ax) * (dy - ay) - (dx - ax) * (by - ay);
      if (!area) continue;
      const [va, vb, vc] = [values[a]!, values[b]!, values[c]!];
      const top = Math.max(0, Math.floor(Math.min(ay, by, dy)));
      const bottom = Math.min(height - 1, Math.ceil(Math.max(ay, by, dy)));
      const left = Math.max(0, Math.floor(Math.min(ax, bx, dx)));
      const right = Math.min(width - 1, Math.ceil(Math.max(ax, bx, dx)));
      for (let y = top; y <= bottom; ++y)
        for (let x = left; x <= right; ++x) {
          const [qx, qy] = [x + 0.5, y + 0.5];
          const wb = ((qx - ax) * (dy - ay) - (dx - ax) * (qy - ay)) / area;
          const wc = ((bx - ax) * (qy - ay) - (qx - ax) * (by - ay)) / area;
          // A little over the sides, so that no seams stay between triangles.
          if (wb < -1e-3 || wc < -1e-3 || wb + wc > 1.001) continue;
          const colour = findColour(va + wb * (vb - va) + wc * (vc - va), scale);
          if (colour >= 0) pixels[y * width + x] = table[colour]!;
        }
    }
  const picture = document.createElement("canvas");
  Object.assign(picture, { width, height });
  picture.getContext("2d")!.putImageData(image, 0, 0);
  context.drawImage(picture, 0, 0, camera.width, camera.height);
}

/** Sides of the elements; curved ones through their middles. */
export function drawMesh({ context, place, theme }: Pen, mesh: QuadraticMesh, nodes: Float32Array): void {
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
  nodes: Float32Array,
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
