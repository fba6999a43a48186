/** Draws over the body, in pixels: outline, supports, water, monitored points, slip surface, ridge of the strain, rulers, picked point. */
import type { Model } from "../contract";
import type { Camera, Vec } from "./camera";
import { makeTicks } from "./format";
import type { LayerName } from "./settings";
import { fontFamily, uprightFrom, veil } from "./scaleBar";
import { drawSupport } from "./supports";
import type { Theme } from "./theme";

export interface Overlay {
  model: Model;
  layers: Record<LayerName, boolean>;
  /** Whether the view is turned in space. */
  inSpace: boolean;
  /** Front and back of the body along z [m]; equal for a section seen from the front. */
  depth: [number, number];
  box: [Vec, Vec];
  slip: [number, number][];
  ridge: [number, number][];
  monitors: { name: string; at: Vec }[];
  picked: Vec | null;
}

type Pixel = [number, number];

export function drawOverlay(context: CanvasRenderingContext2D, overlay: Overlay, camera: Camera, theme: Theme): void {
  const project = camera.makeProjection();
  const place = (at: readonly number[], z = at[2] ?? 0): Pixel => project(at[0]!, at[1]!, z).slice(0, 2) as Pixel;
  const { model, layers, inSpace, depth } = overlay;
  context.lineJoin = context.lineCap = "round";
  const sides = depth[0] === depth[1] ? [depth[0]] : depth;

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
  if (layers.boundaries && model.dimension === 2) {
    context.strokeStyle = theme.symbol;
    const [low, high] = overlay.box;
    const middle = place([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2], 0);
    for (const boundary of model.boundaries) {
      for (const line of boundary.lines) {
        const pixels = line.map((p) => place(p, sides.at(-1)!));
        if (inSpace) strokeLine(context, pixels, { colour: theme.symbol, width: 2.5 });
        else drawSupport(context, pixels, boundary.fix, middle);
      }
    }
  }
  if (layers.water) {
    for (const water of model.water) {
      const line = water.points.map((p) => place(p, sides.at(-1)!));
      strokeLine(context, line, { colour: theme.water, width: 1.8, dash: [10, 3, 2, 3] });
      drawWaterMark(context, line, theme);
    }
  }
  if (layers.slip && overlay.slip.length) {
    const line = overlay.slip.map((p) => place(p, sides.at(-1)!));
    strokeLine(context, line, { colour: "#ffffff", width: 4 });
    strokeLine(context, line, { colour: "#c2185b", width: 2 });
  }
  if (layers.ridge && overlay.ridge.length) {
    const line = overlay.ridge.map((p) => place(p, sides.at(-1)!));
    strokeLine(context, line, { colour: "#ffffff", width: 3.5 });
    strokeLine(context, line, { colour: "#b35900", width: 1.8, dash: [7, 4] });
  }
  if (layers.monitors) {
    for (const monitor of overlay.monitors) drawMonitor(context, place(monitor.at), monitor.name, theme);
  }
  if (overlay.picked) drawPicked(context, place(overlay.picked), theme);
  if (layers.rulers && !inSpace) drawRulers(context, camera, theme);
  if (layers.rulers && inSpace) drawAxes(context, camera, theme);
}

function strokeLine(
  context: CanvasRenderingContext2D,
  line: Pixel[],
  style: { colour: string; width: number; dash?: number[]; closed?: boolean },
): void {
  context.strokeStyle = style.colour;
  context.lineWidth = style.width;
  context.setLineDash(style.dash ?? []);
  context.beginPath();
  for (const [x, y] of line) context.lineTo(x, y);
  if (style.closed) context.closePath();
  context.stroke();
  context.setLineDash([]);
}

/** The inverted triangle over two short lines, in the middle of the longest piece of the water table. */
function drawWaterMark(context: CanvasRenderingContext2D, line: Pixel[], theme: Theme): void {
  let best = 0;
  const width = (i: number) => Math.abs(line[i + 1]![0] - line[i]![0]);
  for (let i = 0; i + 1 < line.length; ++i) if (width(i) > width(best)) best = i;
  if (line.length < 2) return;
  const [x, y] = [(line[best]![0] + line[best + 1]![0]) / 2, (line[best]![1] + line[best + 1]![1]) / 2];
  context.fillStyle = theme.water;
  context.beginPath();
  for (const [dx, dy] of [[-7, -12], [7, -12], [0, -1]] as const) context.lineTo(x + dx, y + dy);
  context.fill();
  strokeLine(context, [[x - 5, y + 4], [x + 5, y + 4]], { colour: theme.water, width: 1.2 });
  strokeLine(context, [[x - 2.5, y + 7], [x + 2.5, y + 7]], { colour: theme.water, width: 1.2 });
}

function drawMonitor(context: CanvasRenderingContext2D, [x, y]: Pixel, name: string, theme: Theme): void {
  context.fillStyle = theme.ground;
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.6;
  context.beginPath();
  context.arc(x, y, 4.5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.font = `600 12px ${fontFamily}`;
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  context.lineWidth = 3.5;
  context.strokeStyle = theme.ground;
  context.strokeText(name, x + 8, y - 7);
  context.fillStyle = theme.ink;
  context.fillText(name, x + 8, y - 7);
}

function drawPicked(context: CanvasRenderingContext2D, [x, y]: Pixel, theme: Theme): void {
  for (const [colour, width] of [[theme.ground, 4.5], [theme.accent, 2]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.arc(x, y, 8, 0, 2 * Math.PI);
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) {
      context.moveTo(x + 8 * dx, y + 8 * dy);
      context.lineTo(x + 14 * dx, y + 14 * dy);
    }
    context.stroke();
  }
}

/** Lengths along the lower and the left edge [m]. */
function drawRulers(context: CanvasRenderingContext2D, camera: Camera, theme: Theme): void {
  const { width, height, scale, target } = camera;
  const [cx, cy] = camera.centre;
  const right = width - (width >= uprightFrom ? camera.margins.right : 0);
  const toX = (px: number) => target[0] + (px - cx) / scale;
  const toY = (py: number) => target[1] - (py - cy) / scale;
  context.fillStyle = context.strokeStyle = theme.muted;
  context.font = `11px ${fontFamily}`;
  context.lineWidth = 1;
  context.textBaseline = "alphabetic";
  const [left, base, top] = [40, height - 22, camera.margins.top];
  veil(context, theme, [0, 0, left, height]);
  veil(context, theme, [left, base, width - left, height - base]);
  context.fillStyle = theme.muted;
  context.beginPath();
  context.textAlign = "center";
  for (const tick of makeTicks(toX(left), toX(right), (right - left) / 90)) {
    const x = cx + (tick.value - target[0]) * scale;
    context.moveTo(x, base);
    context.lineTo(x, base + 5);
    if (x > left + 24 && x < right - 14) context.fillText(tick.text, x, base + 17);
  }
  context.textAlign = "right";
  for (const tick of makeTicks(toY(base), toY(top), (base - top) / 60)) {
    const y = cy - (tick.value - target[1]) * scale;
    context.moveTo(left, y);
    context.lineTo(left - 5, y);
    if (y < base - 4 && y > top) context.fillText(tick.text, left - 9, y + 4);
  }
  context.moveTo(left, top);
  context.lineTo(left, base);
  context.lineTo(right, base);
  context.stroke();
  context.fillText("m", left - 9, base + 17);
}

/** Directions of the axes in the lower left corner. */
function drawAxes(context: CanvasRenderingContext2D, camera: Camera, theme: Theme): void {
  const { right, up } = camera.findAxes();
  const [x, y] = [44, camera.height - 44];
  context.font = `600 11px ${fontFamily}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  ["x", "y", "z"].forEach((name, k) => {
    const [dx, dy] = [right[k]!, -up[k]!];
    strokeLine(context, [[x, y], [x + 26 * dx, y + 26 * dy]], { colour: theme.muted, width: 1.4 });
    context.fillStyle = theme.muted;
    context.fillText(name, x + 35 * dx, y + 35 * dy);
  });
}
