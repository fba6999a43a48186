// SPDX-License-Identifier: MIT
/** Division of the width and height of the stage between the body and the parts around it. */
import { report } from "../state";
import type { Camera, Margins } from "./camera";
import { findRulerWidth } from "./rulers";
import { uprightFrom } from "./scaleBar";

/** Height of the stage [px] that the section fills, within what a screen can spare. */
function chooseHeight(width: number, margins: Margins): number {
  const { model } = report.value;
  const corners = model.polygons.flatMap((polygon) => polygon.points);
  const outline = corners.length ? corners : model.bounds;
  const reach = (k: number) => Math.max(...outline.map((p) => p[k]!)) - Math.min(...outline.map((p) => p[k]!));
  const body = ((width - margins.left - margins.right) * reach(1)) / (reach(0) || 1);
  const wanted = model.dimension === 3 ? 0.55 * width : body + margins.top + margins.bottom + 8;
  return Math.round(Math.min(430, Math.max(300, wanted)));
}

export function layOut(camera: Camera, width: number): void {
  const [low, high] = report.value.model.bounds;
  const upright = width >= uprightFrom;
  const margins = { left: (upright ? 62 : 52) + findRulerWidth(low[1]!, high[1]!), right: upright ? 126 : 24, top: upright ? 34 : 70, bottom: 48 };
  Object.assign(camera, { width, height: chooseHeight(width, margins), margins });
}
