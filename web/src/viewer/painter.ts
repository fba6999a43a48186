// SPDX-License-Identifier: MIT
/** The two ways of drawing the body: their interface, and the plain canvas, which draws squares where the browser offers no WebGL. */
import type { Camera, Vec } from "./camera";
import { findColour, writeColour } from "./colours";
import type { Scale } from "./scale";

/** The body as it is drawn now: one frame of one sequence. */
export interface Body {
  dimension: 2 | 3;
  count: number;
  /** Corner of the model near which a graphics processor counts [m]: its 32 bits would not hold places of a map. */
  origin: Vec;
  /** [point][dimension] [m] */
  positions: Float64Array;
  /** [point], NaN for no value. */
  values: Float32Array;
  /** [point] radius [m] that a point is drawn with; 0 for a point that is not shown, below 0 where it has no value. */
  radii: Float32Array;
  /** Cover that cuts the cells of a section where the soil ends; null in space, where points are shaded spheres. */
  cover: Cover | null;
  scale: Scale;
  /** 256 colours as red, green, blue, 255. */
  colours: Uint8Array;
  /** Places along z [m] at which a section is repeated to be seen as a slab; [0] otherwise. */
  slices: number[];
  /** Diagonal of the box around all that is shown [m]. */
  extent: number;
  /** Left, lower and right ends [m], beyond which a section seen from the front is not drawn. */
  walls: [number, number, number];
  showPoints: boolean;
  /** Pairs of points [m], x y z each, or null. */
  edges: Float64Array | null;
  edgeColour: string;
}

interface Cover {
  /** [point] as in Cells. */
  reach: Float32Array;
  /** Corners of triangles, x y each [m]. */
  triangles: Float64Array;
  /** Closed lines around the same area [m]. */
  outlines: [number, number][][];
}

/** Places [m], `width` components each, counted from the origin. */
export function toLocal(places: ArrayLike<number>, width: number, origin: Vec): Float32Array {
  return Float32Array.from({ length: places.length }, (_, i) => places[i]! - origin[i % width]!);
}

export interface Painter {
  readonly canvas: HTMLCanvasElement;
  /** Sizes in CSS pixels; `density`: device pixels per CSS pixel. */
  resize(width: number, height: number, density: number): void;
  draw(body: Body, camera: Camera): void;
  dispose(): void;
}

type Project = (x: number, y: number, z: number) => number[];

function drawPoints(context: CanvasRenderingContext2D, body: Body, project: Project, scale: number): void {
  const { dimension, count, positions, values, radii } = body;
  // Squares of a section may overlap, the clipping cuts them at the surface; in space they represent spheres.
  const width = body.cover ? 2 : 1.7;
  const found: { x: number; y: number; depth: number; colour: number; side: number }[] = [];
  for (const slice of body.slices) {
    for (let i = 0; i < count; ++i) {
      if (!radii[i]) continue;
      const at = [0, 1, 2].map((k) => (k < dimension ? positions[dimension * i + k]! : 0));
      const [x, y, depth] = project(at[0]!, at[1]!, at[2]! + slice);
      const side = Math.max(1.5, width * Math.abs(radii[i]!) * scale);
      found.push({ x: x!, y: y!, depth: depth!, colour: findColour(values[i]!, body.scale), side });
    }
  }
  // From the back to the front in space; by colour in a section, for changing the colour is what costs.
  found.sort(body.cover ? (a, b) => a.colour - b.colour : (a, b) => a.depth - b.depth);
  let last = NaN;
  for (const { x, y, colour, side } of found) {
    if (colour !== last) context.fillStyle = writeColour(body.colours, (last = colour));
    context.fillRect(x - side / 2, y - side / 2, side, side);
  }
}

/** Clips the drawing to the body of a section, and to isolated points. */
function clipToBody(context: CanvasRenderingContext2D, body: Body, project: Project, scale: number): void {
  const { cover, positions, radii } = body;
  if (!cover) return;
  context.beginPath();
  for (const line of cover.outlines) {
    line.forEach(([x, y], i) => {
      const [px, py] = project(x, y, 0);
      if (i) context.lineTo(px!, py!);
      else context.moveTo(px!, py!);
    });
    context.closePath();
  }
  for (let i = 0; i < body.count; ++i) {
    if (!radii[i] || Math.abs(Math.abs(radii[i]!) / cover.reach[i]! - 1) > 0.01) continue;
    const [x, y] = project(positions[2 * i]!, positions[2 * i + 1]!, 0);
    const side = cover.reach[i]! * scale;
    context.rect(x! - side, y! - side, 2 * side, 2 * side);
  }
  context.clip("evenodd");
}

function drawEdges(context: CanvasRenderingContext2D, edges: ArrayLike<number>, colour: string, project: Project): void {
  context.strokeStyle = colour;
  context.globalAlpha = 0.3;
  context.lineWidth = 1;
  context.beginPath();
  for (let i = 0; i < edges.length; i += 6) {
    const [x0, y0] = project(edges[i]!, edges[i + 1]!, edges[i + 2]!);
    const [x1, y1] = project(edges[i + 3]!, edges[i + 4]!, edges[i + 5]!);
    context.moveTo(x0!, y0!);
    context.lineTo(x1!, y1!);
  }
  context.stroke();
  context.globalAlpha = 1;
}

export function makePlainPainter(): Painter {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d")!;
  let density = 1;
  return {
    canvas,
    resize(width, height, pixels) {
      density = pixels;
      canvas.width = Math.round(width * density);
      canvas.height = Math.round(height * density);
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
    },
    draw(body, camera) {
      context.setTransform(density, 0, 0, density, 0, 0);
      context.clearRect(0, 0, camera.width, camera.height);
      const project = camera.makeProjection();
      context.save();
      clipToBody(context, body, project, camera.scale);
      if (body.showPoints) drawPoints(context, body, project, camera.scale);
      context.restore();
      if (body.edges) drawEdges(context, body.edges, body.edgeColour, project);
    },
    dispose() {},
  };
}
