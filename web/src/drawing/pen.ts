// SPDX-License-Identifier: MIT
/** Tools for drawing a section: canvas, view, colours; fields that are linear on triangles. */
import { report } from "../state";
import type { Camera } from "../viewer/camera";
import { findColour } from "../viewer/colours";
import type { Pixel } from "../viewer/lines";
import type { Scale } from "../viewer/scale";
import type { Theme } from "../viewer/theme";

export interface Pen {
  context: CanvasRenderingContext2D;
  camera: Camera;
  theme: Theme;
  /** Device pixels per pixel. */
  density: number;
  dark: boolean;
  /** [m] → [px]. */
  place: (at: readonly number[]) => Pixel;
}

/** Corners [m]. */
export type Box = [number[], number[]];

/** The box around lists of points; null around none. */
export function findBox(lists: readonly (readonly (readonly number[])[])[]): Box | null {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (const list of lists)
    for (const point of list)
      for (const k of [0, 1]) {
        low[k] = Math.min(low[k]!, point[k]!);
        high[k] = Math.max(high[k]!, point[k]!);
      }
  return low[0]! <= high[0]! ? [low, high] : null;
}

/** Around the soil, or else around the model. */
export function findSoilBox(): Box {
  const { polygons, bounds } = report.value.model;
  return findBox(polygons.map((p) => p.points)) ?? [bounds[0].slice(0, 2), bounds[1].slice(0, 2)];
}

/** The smallest box around both. */
export function joinBoxes(a: Box, b: Box | null): Box {
  return b ? findBox([a, b])! : a;
}

export interface Triangles {
  /** [node][2] [m], [triangle][3]. */
  nodes: Float64Array;
  triangles: Uint32Array;
}

/** `values`: one for each node. */
export function paintTriangles(
  pen: Pen,
  { nodes, triangles }: Triangles,
  values: ArrayLike<number>,
  colours: Uint8Array,
  scale: Scale,
  opacity: number,
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
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!];
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
  context.globalAlpha = opacity;
  context.drawImage(picture, 0, 0, camera.width, camera.height);
  context.globalAlpha = 1;
}
