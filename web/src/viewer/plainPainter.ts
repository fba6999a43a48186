/** Draws the body on a plain canvas, where the browser offers no WebGL: the same picture from squares. */
import { findColour, writeColour } from "./colours";
import type { Body, Painter } from "./painter";

export function makePlainPainter(): Painter {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d")!;
  let density = 1;

  function drawPoints(body: Body, project: (x: number, y: number, z: number) => number[], scale: number): void {
    const { dimension, count, positions, values, cut } = body;
    const [low, high] = body.limits;
    const side = Math.max(1.5, (body.size / 1.3) * scale);
    const found: { x: number; y: number; depth: number; colour: number }[] = [];
    for (const slice of body.slices) {
      for (let i = 0; i < count; ++i) {
        const at = [0, 1, 2].map((k) => (k < dimension ? positions[dimension * i + k]! : 0));
        if (at.some((p, k) => !(p >= cut[0][k]! && p <= cut[1][k]!))) continue;
        const [x, y, depth] = project(at[0]!, at[1]!, at[2]! + slice);
        found.push({ x: x!, y: y!, depth: depth!, colour: findColour(values[i]!, low, high) });
      }
    }
    // From the back to the front in space; by colour in a section, for changing the colour is what costs.
    found.sort(body.shaded ? (a, b) => a.depth - b.depth : (a, b) => a.colour - b.colour);
    let last = NaN;
    for (const point of found) {
      if (point.colour !== last) context.fillStyle = writeColour(body.colours, (last = point.colour));
      context.fillRect(point.x - side / 2, point.y - side / 2, side, side);
    }
  }

  function clipToWalls({ walls }: Body, project: (x: number, y: number, z: number) => number[], height: number): void {
    const [left, lower] = project(walls[0], walls[1], 0);
    const [right] = project(walls[2], walls[1], 0);
    context.beginPath();
    context.rect(left!, -height, right! - left!, lower! + height);
    context.clip();
  }

  return {
    canvas,
    resize(width, height, pixels) {
      density = pixels;
      canvas.width = Math.round(width * density);
      canvas.height = Math.round(height * density);
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
    },
    draw(body, camera) {
      context.setTransform(density, 0, 0, density, 0, 0);
      context.clearRect(0, 0, camera.width, camera.height);
      const project = camera.makeProjection();
      context.save();
      if (!body.shaded) clipToWalls(body, project, camera.height);
      if (body.showPoints) drawPoints(body, project, camera.scale);
      context.restore();
      if (!body.edges) return;
      context.strokeStyle = body.edgeColour;
      context.globalAlpha = 0.3;
      context.lineWidth = 1;
      context.beginPath();
      for (let i = 0; i < body.edges.length; i += 6) {
        const [x0, y0] = project(body.edges[i]!, body.edges[i + 1]!, body.edges[i + 2]!);
        const [x1, y1] = project(body.edges[i + 3]!, body.edges[i + 4]!, body.edges[i + 5]!);
        context.moveTo(x0, y0);
        context.lineTo(x1, y1);
      }
      context.stroke();
      context.globalAlpha = 1;
    },
    dispose() {},
  };
}
