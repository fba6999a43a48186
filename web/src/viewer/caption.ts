// SPDX-License-Identifier: MIT
/** The head of a picture that leaves the page: what it shows, of which run, when. */
import { report } from "../state";
import { fontFamily } from "./scaleBar";
import { frame, shown } from "./shown";
import type { Theme } from "./theme";

/** Height of the head [px]. */
export const captionHeight = 46;

/** Title of the run, and sequence with frame below it. */
export function writeCaption(): [string, string] {
  const now = shown.value!;
  const { title, result } = report.value;
  const { revision } = result.project;
  const head = [title || result.provenance.case_file, revision && `revision ${revision}`];
  const label = now.sequence.frames[frame.value]?.label ?? "";
  const below = [now.sequence.title, label, now.field.title];
  return [head.filter(Boolean).join(", "), below.filter(Boolean).join(" · ")];
}

export function drawCaption(context: CanvasRenderingContext2D, width: number, theme: Theme): void {
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
