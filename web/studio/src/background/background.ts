// SPDX-License-Identifier: MIT
/** A picture or scan behind the section: where it lies, and how two known points place it. It belongs to the page, not to the case. */
import { effect, signal } from "@preact/signals";

import { findExtent, type Point } from "../geometry/plane";
import { file, setting } from "../session";
import * as state from "../state";

/**
 * A similarity of the plane in complex numbers: the pixel (px, py), with y downwards, lies at turn · (px − i py) + shift [m].
 */
export interface Placement {
  turn: Point;
  shift: Point;
}

export interface Background extends Placement {
  name: string;
  /** data: address of the picture. */
  data: string;
  width: number;
  height: number;
  opacity: number;
  shown: boolean;
}

export const background = signal<Background | null>(null);
/** Two points of the picture [m] at its present place, whose coordinates are to be typed. */
export const marks = signal<readonly [Point, Point] | null>(null);

const times = ([a, b]: Point, [c, d]: Point): Point => [a * c - b * d, a * d + b * c];
const over = (p: Point, [c, d]: Point): Point => {
  const [re, im] = times(p, [c, -d]);
  const square = c * c + d * d;
  return [re / square, im / square];
};
const minus = ([a, b]: Point, [c, d]: Point): Point => [a - c, b - d];
const plus = ([a, b]: Point, [c, d]: Point): Point => [a + c, b + d];

/** Where a pixel of the picture lies [m]. */
export const place = ({ turn, shift }: Placement, [px, py]: Point): Point => plus(times(turn, [px, -py]), shift);

/** The placement after which two points of the section lie at others: scaled, turned and shifted, without distortion. */
export function placeByPoints({ turn, shift }: Placement, from: readonly [Point, Point], to: readonly [Point, Point]): Placement | null {
  const span = minus(from[1], from[0]);
  if (Math.hypot(...span) === 0 || Math.hypot(...minus(to[1], to[0])) === 0) return null;
  const factor = over(minus(to[1], to[0]), span);
  return { turn: times(factor, turn), shift: plus(times(factor, minus(shift, from[0])), to[0]) };
}

/** matrix(…) of SVG from pixels of the picture to metres, whose y points up. */
export const writeMatrix = ({ turn: [a, b], shift: [x, y] }: Placement): string => `matrix(${a} ${b} ${b} ${-a} ${x} ${y})`;

const types = new Set(["image/png", "image/jpeg", "image/webp", "image/gif", "image/bmp"]);
export const isPicture = ({ type }: File): boolean => types.has(type);
/** [bytes] */
const largest = 20e6;

function readAddress(found: File): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(new Error(`“${found.name}” cannot be read.`));
    reader.readAsDataURL(found);
  });
}

async function measure(address: string): Promise<{ width: number; height: number }> {
  const image = new Image();
  image.src = address;
  await image.decode();
  return { width: image.naturalWidth, height: image.naturalHeight };
}

/** Takes a picture; it lies over the section, or over 40 m where there is none, until two points place it. */
export async function takePicture(found: File): Promise<void> {
  try {
    if (found.size > largest) throw new Error(`“${found.name}” has more than ${largest / 1e6} MB: save it smaller.`);
    const data = await readAddress(found);
    const { width, height } = await measure(data);
    const { low, high } = findExtent(state.regions.value.flatMap(({ points }) => points)) ?? { low: [0, 0], high: [40, 20] };
    const scale = (high[0] - low[0]) / width;
    background.value = { name: found.name, data, width, height, turn: [scale, 0], shift: [low[0], low[1] + scale * height], opacity: 0.5, shown: true };
    ++state.opened.value;
    state.notice.value = { text: `“${found.name}” lies behind the section. Place it by two points (K).`, bad: false };
  } catch (error) {
    state.notice.value = { text: error instanceof DOMException ? `“${found.name}” is no picture that the browser reads.` : String((error as Error).message), bad: true };
  }
}

const isBackground = (note: unknown): note is Background =>
  typeof note === "object" && note !== null && typeof (note as Background).data === "string" && /^data:image\/(png|jpeg|webp|gif|bmp);/.test((note as Background).data);

/** The picture of a case is a note of its own beside the journal of the program; without a program it lasts as long as the page. */
export function keepBackground(): void {
  const name = (path: string) => `background ${path}`;
  let kept = "";
  let timer: ReturnType<typeof setTimeout> | null = null;
  effect(() => {
    const path = file.value?.path ?? "";
    const workspace = setting.value?.workspace;
    if (path === kept) return;
    const isSaved = kept === "" && background.peek() !== null && path !== "";
    kept = path;
    if (isSaved || !workspace) return;
    background.value = null;
    if (path === "") return;
    workspace
      .readNote<unknown>(name(path))
      .then((note) => {
        if (isBackground(note) && file.peek()?.path === path && !background.peek()) background.value = note;
      })
      .catch(() => undefined);
  });
  let stored: Background | null = null;
  effect(() => {
    const now = background.value;
    const path = file.value?.path ?? "";
    const workspace = setting.value?.workspace;
    if (!workspace || path === "" || now === stored) return;
    if (timer) clearTimeout(timer);
    timer = setTimeout(() => {
      stored = background.peek();
      workspace.writeNote(name(path), stored).catch((error: Error) => (state.notice.value = { text: `The picture is not stored: ${error.message}`, bad: true }));
    }, 800);
  });
}
