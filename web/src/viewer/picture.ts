// SPDX-License-Identifier: MIT
/** Pictures of the stage for outside: a file with a head that describes it, a sheet of paper. */
import { saveFile } from "../charts/base/rows";
import { report } from "../state";
import { fontFamily } from "./scaleBar";
import { frame, shown } from "./shown";
import { paperTheme, type Theme } from "./theme";

/** Height of the head [px]. */
const captionHeight = 46;

/** Title of the run, and sequence with frame below it. */
function writeCaption(): [string, string] {
  const now = shown.value!;
  const { title, result } = report.value;
  const { revision } = result.project;
  const head = [title || result.provenance.case_file, revision && `revision ${revision}`];
  const label = now.sequence.frames[frame.value]?.label ?? "";
  const below = [now.sequence.title, label, now.field.title];
  return [head.filter(Boolean).join(", "), below.filter(Boolean).join(" · ")];
}

function drawCaption(context: CanvasRenderingContext2D, width: number, theme: Theme): void {
  const [head, below] = writeCaption();
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  context.fillStyle = theme.ink;
  context.font = `600 15px ${fontFamily}`;
  context.fillText(head, 12, 21, width - 24);
  context.fillStyle = theme.muted;
  context.font = `12.5px ${fontFamily}`;
  context.fillText(below, 12, 39, width - 24);
}

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
