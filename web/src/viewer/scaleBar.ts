// SPDX-License-Identifier: MIT
/** The scalar bar: the colours with their values in engineering units; or the key of the materials. */
import { writeColour } from "./colours";
import { findShare, type Level, makeLevels, type Scale } from "./scale";
import type { Theme } from "./theme";

/** Width of the canvas [px] from which the bar is vertical at the right; below, it is horizontal at the top. */
export const uprightFrom = 900;

export interface Bar {
  title: string;
  colours: Uint8Array;
  /** In the unit of the title. */
  scale: Scale;
  /** Ends of bands in that unit, or null where colours run. */
  levels: Level[] | null;
  /** True with values beyond the ends. */
  below: boolean;
  above: boolean;
}

export interface Key {
  title: string;
  colours: Uint8Array;
  /** Places in the table of colours with their names. */
  items: { place: number; text: string }[];
}

type Box = [number, number, number, number];

/** Takes back what is drawn under rulers and the bar, so that their texts can be read over a body that is zoomed in. */
export function veil(context: CanvasRenderingContext2D, theme: Theme, [x, y, w, h]: Box): void {
  context.globalAlpha = 0.88;
  context.fillStyle = theme.ground;
  context.fillRect(x, y, w, h);
  context.globalAlpha = 1;
}

/** Draws the bar or the key at the right or the upper end of the canvas. */
export function drawScaleBar(
  context: CanvasRenderingContext2D,
  bar: Bar | Key,
  width: number,
  height: number,
  theme: Theme,
): void {
  const upright = width >= uprightFrom;
  veil(context, theme, upright ? [width - 112, 0, 112, height] : [0, 0, width, 62]);
  context.fillStyle = theme.ink;
  context.font = `600 12px ${fontFamily}`;
  context.textBaseline = "alphabetic";
  context.textAlign = upright ? "right" : "center";
  context.fillText(bar.title, upright ? width - 12 : width / 2, upright ? 22 : 17);
  context.font = `11px ${fontFamily}`;
  context.lineWidth = 1;
  if ("items" in bar) drawKey(context, bar, width, upright, theme);
  else drawBar(context, bar, width, height, upright, theme);
}

function drawBar(
  context: CanvasRenderingContext2D,
  bar: Bar,
  width: number,
  height: number,
  upright: boolean,
  theme: Theme,
): void {
  const length = upright ? height - 160 : Math.min(240, width - 90);
  const thick = upright ? 14 : 10;
  const [x, y] = upright ? [width - 74, 48] : [(width - length) / 2, 26];
  /** Pixel along the bar at a fraction of its length, from the low end. */
  const at = (share: number) => (upright ? y + length * (1 - share) : x + length * share);
  for (let p = 0; p < length; ++p) {
    context.fillStyle = writeColour(bar.colours, Math.round((255 * p) / (length - 1)));
    if (upright) context.fillRect(x, y + length - p - 1, thick, 1.5);
    else context.fillRect(x + p, y, 1.5, thick);
  }
  for (const end of [0, 1]) {
    // An arrow head marks that values beyond this end have its colour.
    if (!(end ? bar.above : bar.below)) continue;
    const [s, out] = [at(end), end === 1 ? 8 : -8];
    const corners = upright
      ? [[x, s], [x + thick, s], [x + thick / 2, s - out]]
      : [[s, y], [s, y + thick], [s + out, y + thick / 2]];
    context.fillStyle = writeColour(bar.colours, end * 255);
    context.beginPath();
    for (const [px, py] of corners) context.lineTo(px!, py!);
    context.fill();
  }
  context.fillStyle = context.strokeStyle = theme.muted;
  context.textAlign = upright ? "left" : "center";
  const levels = (bar.levels ?? makeLevels(bar.scale, upright ? 6 : 4)).map((level) => ({
    text: level.text,
    s: at(findShare(level.value, bar.scale)),
  }));
  // Many bands have more ends than texts fit along the top: then every second has one, or every third.
  const fits = (stride: number) =>
    levels.every(({ s, text }, i) => i < stride || i % stride || s - levels[i - stride]!.s > 8 + 6 * text.length);
  const stride = upright ? 1 : ([1, 2, 3, 4].find(fits) ?? 5);
  levels.forEach(({ s, text }, i) => {
    context.beginPath();
    context.moveTo(...((upright ? [x + thick, s] : [s, y + thick]) as [number, number]));
    context.lineTo(...((upright ? [x + thick + 4, s] : [s, y + thick + 4]) as [number, number]));
    context.stroke();
    if (i % stride) return;
    if (upright) context.fillText(text, x + thick + 7, s + 4);
    else context.fillText(text, s, y + thick + 15);
  });
}

function drawKey(context: CanvasRenderingContext2D, key: Key, width: number, upright: boolean, theme: Theme): void {
  context.textAlign = "left";
  const share = (width - 20) / Math.max(1, key.items.length);
  key.items.forEach(({ place, text }, i) => {
    const [x, y] = upright ? [width - 100, 40 + 20 * i] : [10 + share * i, 32];
    context.fillStyle = writeColour(key.colours, place);
    context.fillRect(x, y, 12, 12);
    context.strokeStyle = theme.muted;
    context.strokeRect(x + 0.5, y + 0.5, 11, 11);
    context.fillStyle = theme.ink;
    context.fillText(shorten(context, text, (upright ? 92 : share) - 22), x + 18, y + 10);
  });
}

/** The text, or its beginning with dots where it is longer than `width` [px]. */
function shorten(context: CanvasRenderingContext2D, text: string, width: number): string {
  if (context.measureText(text).width <= width) return text;
  let kept = text.length - 1;
  while (kept > 1 && context.measureText(text.slice(0, kept) + "…").width > width) --kept;
  return text.slice(0, kept) + "…";
}

export const fontFamily = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';
