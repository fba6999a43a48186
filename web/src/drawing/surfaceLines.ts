// SPDX-License-Identifier: MIT
/** How slip surfaces are drawn over fields and soils: colours and dashes by number, on a light edge. */
import { strokeLine, type Pixel } from "../viewer/lines";
import { fontFamily } from "../viewer/scaleBar";

/** Seen on any field because of their white edge; those of charts.css for light ground. */
const colours = ["#0068a5", "#b84e00", "#00755a", "#a33f78", "#8a6100", "#2b2f36", "#5b5bc0"];
const dashes: number[][] = [[], [8, 4], [2, 3], [10, 3, 2, 3], [14, 4], [6, 3, 2, 3, 2, 3], [4, 2]];

export interface LineLook {
  colour: string;
  dash: number[];
}

export function chooseLook(index: number): LineLook {
  const round = Math.floor(index / colours.length);
  return { colour: colours[index % colours.length]!, dash: dashes[(index + 2 * round) % dashes.length]! };
}

export function drawSurface(context: CanvasRenderingContext2D, line: Pixel[], look: LineLook, width = 2.2): void {
  strokeLine(context, line, { colour: "#ffffff", width: width + 2 });
  strokeLine(context, line, { ...look, width });
}

export interface SurfaceLabel {
  line: Pixel[];
  /** "1.006". */
  text: string;
  colour: string;
}

/** Places along a line that are tried for its label, as fractions of its points. */
const shares = [0.5, 0.38, 0.62, 0.26, 0.74, 0.16, 0.84, 0.32, 0.68, 0.44, 0.56, 0.2, 0.8, 0.1, 0.9];

/** A text in a picture: its middle, half its width and half its height [px]. */
export interface LabelBox {
  x: number;
  y: number;
  half: number;
  high: number;
}

/** Pixels that texts keep from each other. */
const gap = 5;

/** How far two texts are apart, along x or y, less the gap; below 0: they are closer. */
export const measureGap = (a: LabelBox, b: LabelBox): number =>
  Math.max(Math.abs(a.x - b.x) - a.half - b.half, Math.abs(a.y - b.y) - a.high - b.high) - gap;

/** Selects the first place that is free of the taken ones, else the one farthest from them. */
export function choosePlace(places: LabelBox[], taken: LabelBox[]): LabelBox {
  const free = (box: LabelBox) => Math.min(Infinity, ...taken.map((other) => measureGap(box, other)));
  return places.find((box) => free(box) >= 0) ?? places.reduce((best, box) => (free(box) > free(best) ? box : best));
}

/** Each text is on its line, in a box of the line's colour; where it would meet another, or one of `taken`, it moves
 * along. */
export function drawSurfaceLabels(
  context: CanvasRenderingContext2D,
  labels: SurfaceLabel[],
  taken: LabelBox[] = [],
): void {
  taken = [...taken];
  context.font = `600 11px ${fontFamily}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const { line, text, colour } of labels) {
    if (line.length < 2) continue;
    const half = context.measureText(text).width / 2 + 4;
    const places = shares.map((share) => {
      const [x, y] = walkAlong(line, share);
      return { x, y, half, high: 8 };
    });
    const chosen = choosePlace(places, taken);
    const { x, y } = chosen;
    taken.push(chosen);
    context.fillStyle = "#ffffff";
    context.strokeStyle = colour;
    context.lineWidth = 1.2;
    context.beginPath();
    context.rect(x - half, y - 8, 2 * half, 16);
    context.fill();
    context.stroke();
    context.fillStyle = colour;
    context.fillText(text, x, y + 0.5);
  }
}

/** The place at a fraction of the length of a line. */
function walkAlong(line: Pixel[], share: number): Pixel {
  const lengths = line.slice(1).map((p, i) => Math.hypot(p[0] - line[i]![0], p[1] - line[i]![1]));
  let left = share * lengths.reduce((a, b) => a + b, 0);
  for (let i = 0; i < lengths.length; ++i) {
    if (left > lengths[i]!) {
      left -= lengths[i]!;
      continue;
    }
    const t = left / (lengths[i]! || 1);
    return [0, 1].map((d) => line[i]![d]! + t * (line[i + 1]![d]! - line[i]![d]!)) as Pixel;
  }
  return line.at(-1)!;
}
