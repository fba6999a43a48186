// SPDX-License-Identifier: MIT
/** The two canvases of a drawing, its view, when they are drawn; mouse, fingers and wheel over it. */
import { saveFile } from "../charts/base/rows";
import { printing } from "../state";
import { Camera, type Vec } from "../viewer/camera";
import { drawRulers, findRulerWidth } from "../viewer/rulers";
import { type Bar, drawScaleBar, type Key, uprightFrom } from "../viewer/scaleBar";
import { isDark, listenTo, paperTheme, readTheme, type Theme, watchTheme } from "../viewer/theme";
import type { Box, Pen } from "./pen";
import { drawLengthBar } from "./standingWater";

interface Drawing {
  box: Box;
  /** The costly part, and what lies over it and changes often. */
  draw: (pen: Pen) => void;
  drawOver?: (pen: Pen) => void;
  bar: Bar | Key | null;
  /** Largest height [px]. */
  tallest: number;
}

/** From a picture that takes two frames as long on, its copy moves with the mouse, and it is drawn anew at rest [ms]. */
const slowPicture = 60;
const rest = 150;

/** Width on paper [px]. */
const paperWidth = 680;

export class View {
  readonly camera = new Camera();
  private readonly below = document.createElement("canvas");
  private readonly above = document.createElement("canvas");
  private readonly ends: (() => void)[] = [];
  private pending = { below: false, above: false, frame: 0 };
  private density = 1;
  private fitted = "";
  /** The camera of the lower picture, and how long its two frames took [ms]. */
  private painted = { target: [0, 0], centre: [0, 0], scale: 1 };
  private cost = 0;
  private settling: ReturnType<typeof setTimeout> | undefined;
  /** True after the reader moved the view. */
  touched = false;

  constructor(
    private readonly host: HTMLElement,
    private drawing: Drawing,
  ) {
    this.below.className = "drawing-below";
    this.below.style.transformOrigin = "0 0";
    this.above.className = "drawing-above";
    host.append(this.below, this.above);
    // Its height is the drawing's own doing.
    const observer = new ResizeObserver(() => host.clientWidth !== this.camera.width && this.resize());
    observer.observe(host);
    const toPaper = () => this.resize(paperWidth, paperTheme);
    const toScreen = () => this.resize();
    this.ends.push(
      () => observer.disconnect(),
      watchTheme(() => this.request(true)),
      listenTo(window, { beforeprint: toPaper, afterprint: toScreen }),
    );
    if (printing.value) toPaper();
    else toScreen();
  }

  /** Draws what has changed: all of it, or what lies above. */
  update(drawing: Drawing, all: boolean): void {
    this.drawing = drawing;
    if (all) this.resize();
    else this.request(false);
  }

  private resize(wanted = this.host.clientWidth, theme?: Theme): void {
    if (!wanted) return;
    this.density = theme ? 2 : Math.min(2, devicePixelRatio || 1);
    const { box, bar, tallest } = this.drawing;
    const [low, high] = box;
    const upright = wanted >= uprightFrom;
    const margins = {
      left: (upright ? 62 : 52) + findRulerWidth(low[1]!, high[1]!),
      right: upright && bar ? 126 : 24,
      top: bar && !upright ? 70 : 34,
      bottom: 48,
    };
    const body = ((wanted - margins.left - margins.right) * (high[1]! - low[1]!)) / (high[0]! - low[0]! || 1);
    const height = Math.round(Math.min(tallest, Math.max(220, body + margins.top + margins.bottom + 8)));
    Object.assign(this.camera, { width: wanted, height, margins });
    const key = JSON.stringify([box, wanted, height]);
    if (!this.touched || theme) this.fitOnce(key);
    this.host.style.height = `${height}px`;
    for (const canvas of [this.below, this.above]) {
      canvas.width = Math.round(wanted * this.density);
      canvas.height = Math.round(height * this.density);
    }
    this.paint(this.below, true, theme);
    this.paint(this.above, true, theme);
  }

  private fitOnce(key: string): void {
    if (this.fitted === key) return;
    this.fitted = key;
    const [low, high] = this.drawing.box;
    this.camera.fit([low[0]!, low[1]!, 0], [high[0]!, high[1]!, 0]);
    this.camera.scales = [this.camera.scale / 6, this.camera.scale * 60];
  }

  fit(): void {
    this.fitted = "";
    this.setTouched(false);
    this.resize();
  }

  zoom(factor: number, x?: number, y?: number): void {
    this.camera.zoom(factor, x, y);
    this.setTouched(true);
    this.followCamera();
  }

  pan(dx: number, dy: number): void {
    this.camera.pan(dx, dy);
    this.setTouched(true);
    this.followCamera();
  }

  /** Moves the lower picture if drawing it takes long, such as thousands of arcs. */
  private followCamera(): void {
    if (this.cost < slowPicture) return this.request(true);
    const { painted, camera } = this;
    const k = camera.scale / painted.scale;
    const [x, y] = [0, 1].map((d) => {
      const moved = (painted.target[d]! - camera.target[d]!) * camera.scale;
      return camera.centre[d]! - k * painted.centre[d]! + (d === 0 ? moved : -moved);
    });
    this.below.style.transform = `translate(${x}px, ${y}px) scale(${k})`;
    this.request(false);
    clearTimeout(this.settling);
    this.settling = setTimeout(() => this.request(true), rest);
  }

  /** The browser draws after the script: the second frame after it shows how long that takes. */
  private notePainting(): void {
    const { target, scale, centre } = this.camera;
    this.painted = { target: [...target], centre: [...centre], scale };
    this.below.style.transform = "";
    const from = performance.now();
    requestAnimationFrame(() => requestAnimationFrame(() => (this.cost = performance.now() - from)));
  }

  /** A finger scrolls the page over a view that is whole; one that was zoomed follows the finger. */
  private setTouched(touched: boolean): void {
    this.touched = touched;
    this.host.style.touchAction = touched ? "none" : "";
  }

  /** Place in the section of a pixel of the screen [m]. */
  locate(clientX: number, clientY: number): [number, number] {
    const { left, top } = this.host.getBoundingClientRect();
    const [cx, cy] = this.camera.centre;
    const { target, scale } = this.camera;
    return [target[0] + (clientX - left - cx) / scale, target[1] - (clientY - top - cy) / scale];
  }

  private request(all: boolean): void {
    this.pending.below ||= all;
    this.pending.above = true;
    this.pending.frame ||= requestAnimationFrame(() => {
      const { below } = this.pending;
      this.pending = { below: false, above: false, frame: 0 };
      if (below) this.paint(this.below, false);
      this.paint(this.above, false);
    });
  }

  private makePen(context: CanvasRenderingContext2D, theme: Theme, dark: boolean): Pen {
    const project = this.camera.makeProjection();
    const place = (at: readonly number[]) => project(at[0]!, at[1]!, 0).slice(0, 2) as [number, number];
    return { context, camera: this.camera, theme, density: this.density, dark, place };
  }

  /** A fresh canvas is not cleared: printed, the clearing of the upper one would wipe out the lower one. */
  private paint(canvas: HTMLCanvasElement, fresh: boolean, paper?: Theme): void {
    const context = canvas.getContext("2d");
    if (!context || !canvas.width) return;
    context.setTransform(this.density, 0, 0, this.density, 0, 0);
    if (!fresh) context.clearRect(0, 0, this.camera.width, this.camera.height);
    const pen = this.makePen(context, paper ?? readTheme(), !paper && isDark());
    context.lineJoin = context.lineCap = "round";
    if (canvas === this.below) {
      this.notePainting();
      this.drawing.draw(pen);
    } else {
      this.drawing.drawOver?.(pen);
      drawRulers(context, this.camera, pen.theme);
      const { bar } = this.drawing;
      if (bar) drawScaleBar(context, bar, this.camera.width, this.camera.height, pen.theme);
      drawLengthBar(pen);
      // As the viewer of points does: the browser tests measure how long the first picture takes.
      if (!performance.getEntriesByName("talus-interactive").length) performance.mark("talus-interactive");
    }
  }

  save(name: string): void {
    if (this.below.style.transform) this.paint(this.below, false);
    const picture = document.createElement("canvas");
    Object.assign(picture, { width: this.below.width, height: this.below.height });
    const context = picture.getContext("2d")!;
    context.fillStyle = readTheme().ground;
    context.fillRect(0, 0, picture.width, picture.height);
    for (const canvas of [this.below, this.above]) context.drawImage(canvas, 0, 0);
    picture.toBlob((blob) => blob && saveFile(blob, name));
  }

  dispose(): void {
    cancelAnimationFrame(this.pending.frame);
    clearTimeout(this.settling);
    this.ends.forEach((end) => end());
    this.host.replaceChildren();
  }
}

/** Moves by dragging with the mouse, or with a finger once the view is not whole; the wheel zooms where it has focus. */
export function listen(host: HTMLElement, view: View, point: (at: [number, number] | null) => void): () => void {
  let last: Vec | null = null;
  const down = (event: PointerEvent) => {
    if (event.button !== 0 || (event.pointerType === "touch" && !view.touched)) return;
    last = [event.clientX, event.clientY, 0];
    host.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent) => {
    if (last) {
      view.pan(event.clientX - last[0], event.clientY - last[1]);
      last = [event.clientX, event.clientY, 0];
    } else point(view.locate(event.clientX, event.clientY));
  };
  const up = () => (last = null);
  const leave = (event: PointerEvent) => {
    if (event.pointerType !== "touch") point(null);
  };
  const wheel = (event: WheelEvent) => {
    if (document.activeElement !== host) return;
    event.preventDefault();
    const { left, top } = host.getBoundingClientRect();
    view.zoom(Math.exp(-event.deltaY * 0.0015), event.clientX - left, event.clientY - top);
  };
  return listenTo(host, {
    pointerdown: down,
    pointermove: move,
    pointerup: up,
    pointercancel: up,
    pointerleave: leave,
    wheel,
  });
}
