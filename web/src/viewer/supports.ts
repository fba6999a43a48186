// SPDX-License-Identifier: MIT
/** Symbols of boundary conditions as engineers draw them, in pixels. */

type Point = [number, number];

/** Symbol of a support by its kind in the case. */
export function chooseSymbol(fix: string): "hatching" | "rollers" | "dashes" {
  return fix === "full" ? "hatching" : fix === "friction" ? "dashes" : "rollers";
}

/**
 * Draws one line of a support with its symbol on the side that is away from the model.
 * Hatching: fixed in all directions; rollers: fixed across, free along; dashed hatching: friction.
 */
export function drawSupport(context: CanvasRenderingContext2D, line: Point[], fix: string, middle: Point): void {
  const kind = chooseSymbol(fix);
  for (let i = 0; i + 1 < line.length; ++i) {
    const [a, b] = [line[i]!, line[i + 1]!];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 2) continue;
    const along: Point = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    let out: Point = [-along[1], along[0]];
    const outwards = ((a[0] + b[0]) / 2 - middle[0]) * out[0] + ((a[1] + b[1]) / 2 - middle[1]) * out[1];
    if (outwards < 0) out = [-out[0], -out[1]];
    const place = (s: number, d: number): Point => [a[0] + along[0] * s + out[0] * d, a[1] + along[1] * s + out[1] * d];
    const stroke = (from: Point, to: Point) => {
      context.moveTo(...from);
      context.lineTo(...to);
    };
    const steps = Math.max(1, Math.round(length / (kind === "rollers" ? 22 : 9)));
    const step = length / steps;
    context.lineWidth = 1;
    context.beginPath();
    if (kind === "rollers") {
      stroke(place(0, 1), place(length, 1));
      stroke(place(0, 9), place(length, 9));
      for (let k = 0; k < steps; ++k) {
        const [x, y] = place((k + 0.5) * step, 5);
        context.moveTo(x + 3.2, y);
        context.arc(x, y, 3.2, 0, 2 * Math.PI);
      }
    } else {
      stroke(place(0, 1), place(length, 1));
      if (kind === "dashes") context.setLineDash([3, 2]);
      for (let k = 0; k < steps; ++k) stroke(place((k + 1) * step - 1, 1), place((k + 1) * step - 8, 9));
    }
    context.stroke();
    context.setLineDash([]);
  }
}
