// SPDX-License-Identifier: MIT
/** Draws over the body, in pixels: outlines, supports, water, arrows, slip surface, points of interest, rulers. */
import type { HydraulicCondition, Model } from "../contract";
import type { ArrowField } from "./arrows";
import type { Camera, Vec } from "./camera";
import { drawHydraulic, drawSupport } from "./symbols";
import { drawBentBars, drawCrack, drawSoilNames } from "../drawing/ground";
import { drawExitMarks, drawPonds, listExits, findUsedWater } from "../drawing/standingWater";
import { chooseLook, drawSurface } from "../drawing/surfaceLines";
import { drawArrows, drawMonitor, drawPath, drawPicked, drawWaterMark, strokeLine, type Pixel } from "./lines";
import { drawAxes, drawBox, drawRulers } from "./rulers";
import type { LayerName, OtherSurface } from "./settings";
import type { Theme } from "./theme";

export interface Overlay {
  model: Model;
  layers: Record<LayerName, boolean>;
  /** True while the view is rotated in space. */
  inSpace: boolean;
  /** Front and back of the body along z [m]; equal for a section seen from the front. */
  depth: [number, number];
  box: [Vec, Vec];
  /** One, or one of each side. */
  slips: [number, number][][];
  ridge: [number, number][];
  /** Slip surfaces of LEM and FEM. */
  otherSurfaces: OtherSurface[];
  /** Water tables of the shown frame; null where unknown, and the initial one is drawn. */
  waterTables: [number, number][][] | null;
  hydraulics: HydraulicCondition[];
  /** Time of the shown frame [s]. */
  time: number;
  /** Closed lines around the body as it is now. */
  present: [number, number][][];
  /** Present position of the point that was nearest to a place at first [m]. */
  follow: (at: readonly number[]) => Vec;
  /** Lines of the supports in the shown frame [m]. */
  bars: number[][][];
  arrows: ArrowField | null;
  monitors: { name: string; at: Vec }[];
  picked: Vec | null;
  /** Position of the picked point in each frame. */
  path: Vec[];
}

/** Ends of water tables on the ground, without those at an outer side of the model. */
export function findExits(tables: [number, number][][], [low, high]: [Vec, Vec]): [number, number][] {
  const near = 0.015 * (high[0] - low[0]);
  const isOpen = ([a, b]: [number, number][]) => Math.hypot(a![0] - b![0], a![1] - b![1]) > near;
  return tables
    .map((line): [number, number][] => [line[0]!, line.at(-1)!])
    .filter(isOpen)
    .flat()
    .filter(([x]) => x > low[0] + near && x < high[0] - near);
}

export function drawOverlay(context: CanvasRenderingContext2D, overlay: Overlay, camera: Camera, theme: Theme): void {
  const project = camera.makeProjection();
  const place = (at: readonly number[], z = at[2] ?? 0): Pixel => project(at[0]!, at[1]!, z).slice(0, 2) as Pixel;
  const { model, layers, inSpace, depth } = overlay;
  context.lineJoin = context.lineCap = "round";
  const sides = depth[0] === depth[1] ? [depth[0]] : depth;
  const [low, high] = overlay.box;
  const middle = place([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2], 0);
  const inFront = (at: readonly number[]): Pixel => place(at, sides.at(-1)!);
  const pen = { context, camera, place: inFront, theme };

  if (layers.rulers && model.dimension === 3) drawBox(context, camera, overlay.box, theme);
  if (layers.outline) {
    for (const polygon of model.polygons) {
      sides.forEach((z, side) => {
        const back = inSpace && side === (Math.cos(camera.azimuth) >= 0 ? 0 : 1);
        context.globalAlpha = back ? 0.3 : 0.85;
        const line = polygon.points.map((p) => place(p, z));
        strokeLine(context, line, { colour: theme.ink, width: 1.2, dash: [6, 4], closed: true });
      });
      if (sides.length === 2) {
        context.globalAlpha = 0.4;
        for (const p of polygon.points) {
          const line = [place(p, sides[0]!), place(p, sides[1]!)];
          strokeLine(context, line, { colour: theme.ink, width: 1, dash: [6, 4] });
        }
      }
    }
    context.globalAlpha = 1;
  }
  if (layers.present) {
    for (const line of overlay.present) {
      const pixels = line.map(inFront);
      strokeLine(context, pixels, { colour: theme.ink, width: 1.4, closed: true });
    }
  }
  if (layers.boundaries && model.dimension === 2) {
    context.strokeStyle = theme.symbol;
    for (const boundary of model.boundaries) {
      for (const line of boundary.lines) {
        const pixels = line.map(inFront);
        if (inSpace) strokeLine(context, pixels, { colour: theme.symbol, width: 2.5 });
        else drawSupport(context, pixels, boundary.fix, middle);
      }
    }
  }
  if (layers.hydraulics && !inSpace) {
    const sketch = { ...pen, middle };
    for (const condition of overlay.hydraulics) drawHydraulic(sketch, condition, overlay.time);
  }
  const start = findUsedWater();
  const atStart = start?.water_table ?? [];
  if (layers.startWater && overlay.waterTables) {
    for (const points of atStart) {
      const line = points.map(inFront);
      strokeLine(context, line, { colour: theme.water, width: 1.2, dash: [2, 4] });
    }
  }
  if (layers.water) {
    for (const points of overlay.waterTables ?? atStart) {
      const line = points.map(inFront);
      strokeLine(context, line, { colour: theme.ground, width: 4 });
      strokeLine(context, line, { colour: theme.water, width: 2, dash: [10, 3, 2, 3] });
      drawWaterMark(context, line, theme);
    }
    // Later a pond is that of its condition.
    if (start && !inSpace && (!overlay.waterTables || !overlay.hydraulics.length)) drawPonds(pen, start);
    if (!inSpace && overlay.waterTables) drawExitMarks(pen, findExits(overlay.waterTables, overlay.box), false);
    else if (!inSpace) drawExitMarks(pen, listExits(start));
  }
  if (layers.otherSurfaces) {
    for (const surface of overlay.otherSurfaces.filter((s) => s.shown).reverse()) {
      if (surface.method === "lem" && !inSpace) drawCrack(pen, surface.points);
      drawSurface(context, surface.points.map(inFront), chooseLook(surface.look), 2);
    }
  }
  if (layers.slip) {
    for (const slip of overlay.slips) {
      const line = slip.map(inFront);
      strokeLine(context, line, { colour: "#ffffff", width: 4 });
      strokeLine(context, line, { colour: "#c2185b", width: 2 });
    }
  }
  if (layers.ridge && overlay.ridge.length) {
    const line = overlay.ridge.map(inFront);
    strokeLine(context, line, { colour: "#ffffff", width: 3.5 });
    strokeLine(context, line, { colour: "#b35900", width: 1.8, dash: [7, 4] });
  }
  if (layers.supports && !inSpace) drawBentBars(pen, overlay.bars);
  if (layers.soils && model.dimension === 2 && !inSpace)
    drawSoilNames(pen, overlay.follow);
  if (overlay.arrows) drawArrows(context, overlay.arrows, camera.width, theme);
  if (layers.path) drawPath(context, overlay.path.map((at) => place(at)), theme);
  if (layers.monitors) {
    for (const monitor of overlay.monitors) drawMonitor(context, place(monitor.at), monitor.name, theme);
  }
  if (overlay.picked) drawPicked(context, place(overlay.picked), theme);
  if (layers.rulers && !inSpace) drawRulers(context, camera, theme);
  if (layers.rulers && inSpace) drawAxes(context, camera, theme);
}
