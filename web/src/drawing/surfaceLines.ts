// SPDX-License-Identifier: MIT
/** How slip surfaces are drawn over fields and soils: colours and dashes by number, on a light edge. */
import { strokeLine, type Pixel } from "../viewer/lines";

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
