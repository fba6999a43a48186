/** The scalar bar: the colours with their values in engineering units. */
import type { SequenceField } from "../contract";
import { writeColour } from "./colours";
import { makeTicks, writeTitle } from "./format";
import type { Theme } from "./theme";

/** Width of the canvas [px] from which the bar stands upright at the right; below, it lies along the top. */
export const uprightFrom = 900;

export interface Bar {
  field: SequenceField;
  limits: [number, number];
  colours: Uint8Array;
  /** Whether there are values beyond the ends. */
  below: boolean;
  above: boolean;
}

type Box = [number, number, number, number];

/** Takes back what is drawn under rulers and the bar, so that their texts can be read over a body that is zoomed in. */
export function veil(context: CanvasRenderingContext2D, theme: Theme, [x, y, w, h]: Box): void {
  context.globalAlpha = 0.88;
  context.fillStyle = theme.ground;
  context.fillRect(x, y, w, h);
  context.globalAlpha = 1;
}

export function drawScaleBar(
  context: CanvasRenderingContext2D,
  bar: Bar,
  width: number,
  height: number,
  theme: Theme,
): void {
  const upright = width >= uprightFrom;
  const { si } = bar.field.unit;
  const [low, high] = [bar.limits[0] / si, bar.limits[1] / si];
  const length = upright ? height - 160 : Math.min(240, width - 90);
  const thick = upright ? 14 : 10;
  const [x, y] = upright ? [width - 74, 48] : [(width - length) / 2, 26];
  /** Pixel along the bar of a share of its length, from the low end. */
  const at = (share: number) => (upright ? y + length * (1 - share) : x + length * share);

  veil(context, theme, upright ? [width - 112, 0, 112, height] : [0, 0, width, 62]);
  context.fillStyle = theme.ink;
  context.font = `600 12px ${fontFamily}`;
  context.textBaseline = "alphabetic";
  context.textAlign = upright ? "right" : "center";
  context.fillText(writeTitle(bar.field.title, bar.field.unit), upright ? width - 12 : width / 2, upright ? 22 : 17);

  for (let p = 0; p < length; ++p) {
    context.fillStyle = writeColour(bar.colours, Math.round((255 * p) / (length - 1)));
    if (upright) context.fillRect(x, y + length - p - 1, thick, 1.5);
    else context.fillRect(x + p, y, 1.5, thick);
  }
  for (const end of [0, 1]) {
    // An arrow head says that values beyond this end have its colour.
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
  context.font = `11px ${fontFamily}`;
  context.lineWidth = 1;
  for (const tick of makeTicks(low, high, upright ? 6 : 4)) {
    const s = at((tick.value - low) / (high - low));
    context.beginPath();
    if (upright) {
      context.moveTo(x + thick, s);
      context.lineTo(x + thick + 4, s);
      context.textAlign = "left";
      context.fillText(tick.text, x + thick + 7, s + 4);
    } else {
      context.moveTo(s, y + thick);
      context.lineTo(s, y + thick + 4);
      context.textAlign = "center";
      context.fillText(tick.text, s, y + thick + 15);
    }
    context.stroke();
  }
}

export const fontFamily = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';
