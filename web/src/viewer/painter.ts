// SPDX-License-Identifier: MIT
/** Common interface of the two ways of drawing the body, WebGL and the plain canvas. */
import type { Camera, Vec } from "./camera";
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

export interface Cover {
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
