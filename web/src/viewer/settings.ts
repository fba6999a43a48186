// SPDX-License-Identifier: MIT
/** Settings of the viewer by the reader: colours, limits, layers, surfaces of other methods, arrows, the view in space, playing. */
import { signal } from "@preact/signals";

import { listSurfaces, type NamedSurface } from "../compared/methodTable";
import { fieldName, frameIndex, report, sequenceIndex } from "../state";
import type { ColourMapName } from "./colours";

/** null: viridis, or blue–white–red for a quantity that has both signs. */
export const colourMap = signal<ColourMapName | null>(null);

export type LimitMode = "all" | "frame" | "hand";
export const limitMode = signal<LimitMode>("all");
/** Limits set by hand [SI]. */
export const handLimits = signal<[number, number]>([0, 1]);

/** How many bands of one colour the scale has, about; 0 for colours that run. */
export const bands = signal(0);
/** True while strains, displacements and similar fields are coloured by their logarithm. */
export const logarithmic = signal(false);

/** Titles of the fields that arrows may show. */
export const arrowTitles = {
  none: "None",
  displacement: "Displacement",
  velocity: "Velocity",
  darcy_velocity: "Flow of the water",
} as const;
export type ArrowQuantity = keyof typeof arrowTitles;
/** Field of the arrows. */
export const arrowQuantity = signal<ArrowQuantity>("none");

export const layerTitles = {
  points: "Material points",
  slip: "Slip surface",
  ridge: "Axis of the largest strain",
  otherSurfaces: "Slip surfaces of the other methods",
  outline: "Original outline",
  soils: "Names of the soils",
  supports: "Supports",
  present: "Present outline",
  path: "Path of the picked point",
  boundaries: "Boundary conditions",
  hydraulics: "Hydraulic conditions",
  monitors: "Monitored points",
  water: "Water table",
  startWater: "Water table at the start",
  mesh: "Background mesh",
  rulers: "Rulers",
} as const;
export type LayerName = keyof typeof layerTitles;
const hiddenAtFirst: LayerName[] = ["ridge", "present", "startWater", "mesh"];
export const layers = signal(
  Object.fromEntries(
    Object.keys(layerTitles).map((name) => [name, !hiddenAtFirst.includes(name as LayerName)]),
  ) as Record<LayerName, boolean>,
);

/** Names of surfaces of other methods that are drawn or not, where the reader has chosen. */
export const chosenSurfaces = signal<{ [name: string]: boolean }>({});

/** True while the section is rotated in space; always for a model in three dimensions. */
export const inSpace = signal(false);
/** Shares of the box, 0 to 1, along x, y and z between which points are shown. */
export const cut = signal<[number, number][]>([[0, 1], [0, 1], [0, 1]]);

export const playing = signal(false);
/** Multiple of 12 frames per second. */
export const speed = signal(1);

let opened = false;

/**
 * Sets the sequence, frame and field where the failure is seen best: the end of the runout at the largest factor, else
 * of the stages. Does so once, and not when something else was chosen before.
 */
export function openAtFailure(): void {
  inSpace.value = report.value.model.dimension === 3;
  if (opened || sequenceIndex.value !== 0 || frameIndex.value !== 0) return;
  opened = true;
  const sequences = report.value.sequences;
  let best = Math.max(0, sequences.findIndex((s) => s.kind === "stages"));
  let largest = -Infinity;
  sequences.forEach((s, i) => {
    const factor = s.frames.at(-1)?.factor ?? 0;
    if (s.kind === "runout" && factor > largest) [best, largest] = [i, factor];
  });
  const telling = sequences[best];
  if (!telling) return;
  sequenceIndex.value = best;
  frameIndex.value = telling.frames.length - 1;
  const fields = telling.fields.map((f) => f.name);
  // Released soil is looked at for how far it went.
  if (report.value.timeline?.releases && fields.includes("displacement")) fieldName.value = "displacement";
  if (!fields.includes(fieldName.value)) fieldName.value = fields[0] ?? "";
}

export type OtherSurface = NamedSurface & { shown: boolean };

/** Slip surfaces of other methods; those of MPM are drawn by the viewer itself. */
export function listOtherSurfaces(): OtherSurface[] {
  return listSurfaces()
    .filter((surface) => surface.method !== "mpm")
    .map((surface) => ({ ...surface, shown: chosenSurfaces.value[surface.name] ?? surface.first }));
}
