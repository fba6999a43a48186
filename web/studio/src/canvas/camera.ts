// SPDX-License-Identifier: MIT
/** The view of the canvas: metres to pixels and back, zoom about a point, fit. */
import { computed, signal } from "@preact/signals";

import { findExtent, type Point } from "../geometry/plane";

export interface View {
  /** The point of the section [m] in the middle of the canvas. */
  centre: Point;
  /** Pixels per metre. */
  scale: number;
}

export const size = signal<{ width: number; height: number }>({ width: 800, height: 500 });
export const view = signal<View>({ centre: [20, 8], scale: 18 });

/** Pixels kept free at the left and the bottom for the rulers. */
export const ruler = { left: 44, bottom: 24 };

export const toScreen = ([x, y]: Point, { centre, scale }: View = view.value): Point => [
  size.value.width / 2 + (x - centre[0]) * scale,
  size.value.height / 2 - (y - centre[1]) * scale,
];

export const toWorld = ([px, py]: Point, { centre, scale }: View = view.value): Point => [
  centre[0] + (px - size.value.width / 2) / scale,
  centre[1] - (py - size.value.height / 2) / scale,
];

/** The transform of a group whose coordinates are metres. */
export const transform = computed(() => {
  const { scale } = view.value;
  const [x, y] = toScreen([0, 0]);
  return `matrix(${scale} 0 0 ${-scale} ${x} ${y})`;
});

const clamp = (scale: number) => Math.min(2e4, Math.max(1e-3, scale));

/** Zooms so that the point under a pixel stays there. */
export function zoomAt(pixel: Point, factor: number): void {
  const scale = clamp(view.value.scale * factor);
  const [x, y] = toWorld(pixel);
  const { width, height } = size.value;
  view.value = { scale, centre: [x - (pixel[0] - width / 2) / scale, y + (pixel[1] - height / 2) / scale] };
}

export function zoomBy(factor: number): void {
  zoomAt([size.value.width / 2, size.value.height / 2], factor);
}

/** Moves the section by pixels. */
export function panBy(dx: number, dy: number): void {
  const { centre, scale } = view.value;
  view.value = { scale, centre: [centre[0] - dx / scale, centre[1] + dy / scale] };
}

/** Shows all points, or the usual size of a slope where there are none. */
export function fit(points: Iterable<Point>): void {
  const { low, high } = findExtent(points) ?? { low: [0, 0], high: [44, 17] };
  const { width, height } = size.value;
  const margin = Math.min(48, width / 12);
  const room = [width - ruler.left - 2 * margin, height - ruler.bottom - 2 * margin] as const;
  const span = [Math.max(high[0] - low[0], 1e-3), Math.max(high[1] - low[1], 1e-3)] as const;
  const scale = clamp(Math.min(Math.max(room[0], 40) / span[0], Math.max(room[1], 40) / span[1]));
  view.value = {
    scale,
    centre: [(low[0] + high[0]) / 2 - ruler.left / 2 / scale, (low[1] + high[1]) / 2 - ruler.bottom / 2 / scale],
  };
}

/** 1, 2 or 5 times a power of ten [m], such that lines of a grid are some `pixels` apart. */
export function findGridStep(scale: number, pixels = 22): number {
  const rough = pixels / scale;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= rough * 0.999)!;
}
