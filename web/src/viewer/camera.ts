// SPDX-License-Identifier: MIT
/** The view onto the model: parallel projection, so that lengths can be compared; metres to pixels and back. */

export type Vec = [number, number, number];

/** Pixels kept free of the model at the edges of the canvas, for rulers and the scalar bar. */
export interface Margins {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export class Camera {
  /** Point of the model [m] in the middle of the free area. */
  target: Vec = [0, 0, 0];
  /** Pixels per metre. */
  scale = 1;
  /** Ends of the zoom [pixels per metre]. */
  scales: [number, number] = [0, Infinity];
  /** Angles [rad] about the vertical and above the horizon; 0, 0 is the section seen from the front. */
  azimuth = 0;
  elevation = 0;
  width = 1;
  height = 1;
  margins: Margins = { left: 0, right: 0, top: 0, bottom: 0 };

  /** Directions in the model of right, up, and towards the reader. */
  findAxes(): { right: Vec; up: Vec; near: Vec } {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    return { right: [ca, 0, -sa], up: [-se * sa, ce, -se * ca], near: [sa * ce, se, ca * ce] };
  }

  /** Pixel of the target. */
  get centre(): [number, number] {
    const m = this.margins;
    return [(m.left + this.width - m.right) / 2, (m.top + this.height - m.bottom) / 2];
  }

  /** Makes a function from a point [m] to x, y [px from the left and the top] and depth [m towards the reader]. */
  makeProjection(): (x: number, y: number, z: number) => Vec {
    const { right: r, up: u, near: n } = this.findAxes();
    const [cx, cy] = this.centre;
    const [tx, ty, tz] = this.target;
    const s = this.scale;
    return (x, y, z) => {
      const [a, b, c] = [x - tx, y - ty, z - tz];
      const along = (v: Vec) => a * v[0] + b * v[1] + c * v[2];
      return [cx + s * along(r), cy - s * along(u), along(n)];
    };
  }

  /** Moves the model by pixels. */
  pan(dx: number, dy: number): void {
    const { right, up } = this.findAxes();
    for (let k = 0; k < 3; ++k) this.target[k]! += (-dx * right[k]! + dy * up[k]!) / this.scale;
  }

  /** Zooms; the point of the model under the pixel stays where it is. */
  zoom(factor: number, x = this.centre[0], y = this.centre[1]): void {
    const [cx, cy] = this.centre;
    this.pan(cx - x, cy - y);
    this.scale = Math.min(this.scales[1], Math.max(this.scales[0], this.scale * factor));
    this.pan(x - cx, y - cy);
  }

  rotate(dx: number, dy: number): void {
    this.azimuth -= dx * 0.008;
    this.elevation = Math.min(1.5, Math.max(-1.5, this.elevation + dy * 0.008));
  }

  /** Shows the whole box. */
  fit(low: Vec, high: Vec): void {
    this.target = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
    this.scale = 1;
    const project = this.makeProjection();
    let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let corner = 0; corner < 8; ++corner) {
      const at = [0, 1, 2].map((k) => ((corner >> k) & 1 ? high[k]! : low[k]!));
      const [x, y] = project(at[0]!, at[1]!, at[2]!);
      [x0, x1, y0, y1] = [Math.min(x0, x), Math.max(x1, x), Math.min(y0, y), Math.max(y1, y)];
    }
    const m = this.margins;
    const free = [Math.max(40, this.width - m.left - m.right), Math.max(40, this.height - m.top - m.bottom)];
    this.scale = Math.min(free[0]! / Math.max(x1 - x0, 1e-9), free[1]! / Math.max(y1 - y0, 1e-9));
  }
}
