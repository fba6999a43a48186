/** What the two ways of drawing the body, WebGL and the plain canvas, have in common. */
import type { Camera } from "./camera";

/** The body as it is drawn now: one frame of one sequence. */
export interface Body {
  dimension: 2 | 3;
  count: number;
  /** [point][dimension] [m] */
  positions: Float32Array;
  /** [point], NaN for no value. */
  values: Float32Array;
  limits: [number, number];
  /** 256 colours as red, green, blue, 255. */
  colours: Uint8Array;
  /** Diameter of a point [m]. */
  size: number;
  /** Places along z [m] at which a section is repeated to be seen as a slab; [0] otherwise. */
  slices: number[];
  /** Whether points are shaded as spheres. */
  shaded: boolean;
  /** Corners of the box [m] within which points are shown. */
  cut: [number[], number[]];
  /** Diagonal of the box around all that is shown [m]. */
  extent: number;
  /** x and y of the left, lower, right and upper ends [m], beyond which a section seen from the front is not drawn. */
  walls: [number, number, number, number];
  showPoints: boolean;
  /** Pairs of points [m], x y z each, or null. */
  edges: Float32Array | null;
  edgeColour: string;
}

export interface Painter {
  readonly canvas: HTMLCanvasElement;
  /** Sizes in CSS pixels; `density`: device pixels per CSS pixel. */
  resize(width: number, height: number, density: number): void;
  draw(body: Body, camera: Camera): void;
  dispose(): void;
}
