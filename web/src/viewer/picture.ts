// SPDX-License-Identifier: MIT
/** Pictures of the stage for outside: a file, a sheet of paper. */
import { saveFile } from "../charts/base/saveFile";
import { drawCaption, captionHeight } from "./caption";
import type { Theme } from "./theme";
import { paperTheme } from "./theme";

/** Width that the picture is laid out in for paper [px], so that its texts can be read there. */
const paperWidth = 760;

/** Parts of the stage that a picture needs. */
interface Pictured {
  readonly camera: { width: number; height: number };
  drawInto(context: CanvasRenderingContext2D, theme: Theme, density: number): void;
  drawElsewhere(wanted: number | null, draw: () => void): boolean;
}

/** Draws everything onto one canvas, on a filled ground, with `head` pixels free above. */
function compose(stage: Pictured, canvas: HTMLCanvasElement, theme: Theme, density: number, head = 0): void {
  const { width, height } = stage.camera;
  canvas.width = Math.round(width * density);
  canvas.height = Math.round((height + head) * density);
  const context = canvas.getContext("2d")!;
  context.setTransform(density, 0, 0, density, 0, 0);
  context.fillStyle = theme.ground;
  context.fillRect(0, 0, width, height + head);
  if (head) drawCaption(context, width, theme);
  context.setTransform(density, 0, 0, density, 0, head * density);
  stage.drawInto(context, theme, density);
}

/** Paper is white whatever the screen is, and a canvas of WebGL does not survive every printing. */
export function drawOnPaper(stage: Pictured, paper: HTMLCanvasElement): boolean {
  return stage.drawElsewhere(paperWidth, () => compose(stage, paper, paperTheme, 2.5));
}

/** Saves the picture as shown, at twice the resolution, with a head that describes it. */
export function savePicture(stage: Pictured, theme: Theme, name: string): void {
  const canvas = document.createElement("canvas");
  if (!stage.drawElsewhere(null, () => compose(stage, canvas, theme, 2, captionHeight))) return;
  canvas.toBlob((blob) => blob && saveFile(blob, name), "image/png");
}
