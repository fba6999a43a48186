// SPDX-License-Identifier: MIT
/** Rulers: along a section, or a box with lengths and the axes in space. */
import { report } from "../state";
import type { Camera, Vec } from "./camera";
import { makeTicks } from "./scale";
import { strokeLine, type Pixel } from "./lines";
import { fontFamily, uprightFrom, veil } from "./scaleBar";
import type { Theme } from "./theme";

/** Pixels beside a body whose heights lie between two ends [m], for its ruler. */
export function findRulerWidth(low: number, high: number): number {
  return Math.max(0, ...[low, high].map((y) => 7 * (Math.round(y / report.value.units.length.si).toFixed(0).length - 4)));
}

/** Lengths along the lower and the left edge, in the unit of the report. */
export function drawRulers(context: CanvasRenderingContext2D, camera: Camera, theme: Theme): void {
  const { width, height, scale, target } = camera;
  const [cx, cy] = camera.centre;
  const right = width - (width >= uprightFrom ? camera.margins.right : 0);
  const { name, si } = report.value.units.length;
  const toX = (px: number) => (target[0] + (px - cx) / scale) / si;
  const toY = (py: number) => (target[1] - (py - cy) / scale) / si;
  context.fillStyle = context.strokeStyle = theme.muted;
  context.font = `11px ${fontFamily}`;
  context.lineWidth = 1;
  context.textBaseline = "alphabetic";
  const [base, top] = [height - 22, camera.margins.top];
  const heights = makeTicks(toY(base), toY(top), (base - top) / 60);
  const left = Math.max(40, 12 + Math.max(...heights.map(({ text }) => context.measureText(text).width)));
  veil(context, theme, [0, 0, left, height]);
  veil(context, theme, [left, base, width - left, height - base]);
  context.fillStyle = theme.muted;
  context.beginPath();
  context.textAlign = "center";
  for (const tick of makeTicks(toX(left), toX(right), (right - left) / 90)) {
    const x = cx + (tick.value * si - target[0]) * scale;
    context.moveTo(x, base);
    context.lineTo(x, base + 5);
    const half = context.measureText(tick.text).width / 2;
    if (x > left + half + 12 && x < right - half - 4) context.fillText(tick.text, x, base + 17);
  }
  context.textAlign = "right";
  for (const tick of heights) {
    const y = cy - (tick.value * si - target[1]) * scale;
    context.moveTo(left, y);
    context.lineTo(left - 5, y);
    if (y < base - 4 && y > top) context.fillText(tick.text, left - 9, y + 4);
  }
  context.moveTo(left, top);
  context.lineTo(left, base);
  context.lineTo(right, base);
  context.stroke();
  context.fillText(name, left - 9, base + 17);
}

/** Directions of the axes in the lower left corner; one that points at the reader is left out. */
export function drawAxes(context: CanvasRenderingContext2D, camera: Camera, theme: Theme): void {
  const { right, up } = camera.findAxes();
  const [x, y] = [44, camera.height - 44];
  context.font = `600 11px ${fontFamily}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  ["x", "y", "z"].forEach((name, k) => {
    const [dx, dy] = [right[k]!, -up[k]!];
    if (Math.hypot(dx, dy) < 0.15) return;
    strokeLine(context, [[x, y], [x + 26 * dx, y + 26 * dy]], { colour: theme.muted, width: 1.4 });
    context.fillStyle = theme.muted;
    context.fillText(name, x + 35 * dx, y + 35 * dy);
  });
}

/** The box around a model in space, with the coordinates of its ends at three edges that meet. */
export function drawBox(context: CanvasRenderingContext2D, camera: Camera, box: [Vec, Vec], theme: Theme): void {
  const [low, high] = box;
  const project = camera.makeProjection();
  const corner = (bits: number) =>
    project(...([0, 1, 2].map((k) => ((bits >> k) & 1 ? high[k]! : low[k]!)) as Vec));
  const place = (bits: number) => corner(bits).slice(0, 2) as Pixel;
  // The lower corner that is nearest to the reader: its three edges are not behind the body.
  const lower = [0, 1, 4, 5];
  const near = lower.reduce((a, b) => (corner(b)[2] > corner(a)[2] ? b : a));
  const leftmost = lower.reduce((a, b) => (corner(b)[0] < corner(a)[0] ? b : a));
  context.globalAlpha = 0.55;
  for (let bits = 0; bits < 8; ++bits) {
    for (let k = 0; k < 3; ++k) {
      if (bits & (1 << k)) continue;
      strokeLine(context, [place(bits), place(bits | (1 << k))], { colour: theme.muted, width: 0.8 });
    }
  }
  context.globalAlpha = 1;
  context.font = `11px ${fontFamily}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const { si } = report.value.units.length;
  const middle = project(...([0, 1, 2].map((k) => (low[k]! + high[k]!) / 2) as Vec));
  for (let k = 0; k < 3; ++k) {
    // Heights are at the left, beside the body.
    const start = k === 1 ? leftmost : near;
    const [a, b] = [place(start & ~(1 << k)), place(start | (1 << k))];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 60) continue;
    // Texts are on the side of the edge that is away from the body.
    let out: Pixel = [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
    const [dx, dy] = [(a[0] + b[0]) / 2 - middle[0], (a[1] + b[1]) / 2 - middle[1]];
    if (out[0] * dx + out[1] * dy < 0) out = [-out[0], -out[1]];
    for (const tick of makeTicks(low[k]! / si, high[k]! / si, Math.max(2, length / 70))) {
      const fraction = (tick.value * si - low[k]!) / (high[k]! - low[k]!);
      const [x, y] = [a[0] + fraction * (b[0] - a[0]), a[1] + fraction * (b[1] - a[1])];
      strokeLine(context, [[x, y], [x + 5 * out[0], y + 5 * out[1]]], { colour: theme.muted, width: 1 });
      context.fillStyle = theme.muted;
      context.fillText(tick.text, x + 15 * out[0], y + 13 * out[1]);
    }
  }
}
