// SPDX-License-Identifier: MIT
/** The stage: two canvases, the body below and the lines above, the camera, and when they are drawn anew. */
import { carryBars } from "../drawing/ground";
import { effect } from "@preact/signals";

import { pickedPoint, report } from "../state";
import { arrowArrays, chooseArrows } from "./arrows";
import { bar, colourTable, describeBody, findDepth } from "./body";
import { Camera, type Margins, type Vec } from "./camera";
import { makeGlPainter } from "./glPainter";
import { meshEdges } from "./meshEdges";
import { chosenSurfaces, cut, inSpace, layers, limitMode, listOtherSurfaces } from "./settings";
import { drawOverlay, type Overlay } from "./overlay";
import { makePlainPainter, type Painter } from "./painter";
import { drawOnPaper, savePicture } from "./picture";
import { findRulerWidth } from "./rulers";
import { drawScaleBar, uprightFrom } from "./scaleBar";
import { frame, scale, shown } from "./shown";
import { cells } from "./sizes";
import { readTheme, type Theme, watchTheme } from "./theme";
import { slipSurfaces, strainRidge, waterTables } from "./tracedLines";

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

function layOut(camera: Camera, width: number): void {
  const [low, high] = report.value.model.bounds;
  const upright = width >= uprightFrom;
  const margins = { left: (upright ? 62 : 52) + findRulerWidth(low[1]!, high[1]!), right: upright ? 126 : 24, top: upright ? 34 : 70, bottom: 48 };
  Object.assign(camera, { width, height: chooseHeight(width, margins), margins });
}

/** Device pixels that the distance of two points may be zoomed to: many devices draw points of some 500 at most. */
const largestSpacing = 160;

export class Stage {
  readonly camera = new Camera();
  private painter: Painter;
  private readonly lines = document.createElement("canvas");
  private readonly paper = document.createElement("canvas");
  private readonly ends: (() => void)[] = [];
  private density = 1;
  private pending = 0;
  private fitted: { id: string; space: boolean } | null = null;
  private touched = false;
  private theme: Theme = readTheme();
  /** Index of the point that lay nearest to a place, by the sequence and the place. */
  private readonly nearest = new Map<string, number>();
  private indexOf: { ids: ArrayLike<number>; map: Map<number, number> } | null = null;

  constructor(private readonly host: HTMLElement) {
    this.painter = this.makePainter();
    this.lines.className = "viewer-lines";
    this.paper.className = "viewer-paper";
    host.append(this.painter.canvas, this.lines, this.paper);
    const observer = new ResizeObserver(() => this.resize());
    observer.observe(host);
    this.ends.push(() => observer.disconnect());
    this.ends.push(watchTheme(() => this.changeTheme()));
    const toPaper = () => drawOnPaper(this, this.paper) && host.classList.add("viewer-has-paper");
    addEventListener("beforeprint", toPaper);
    this.ends.push(() => removeEventListener("beforeprint", toPaper));
    this.ends.push(
      effect(() => {
        void [shown.value, frame.value, scale.value, colourTable.value, layers.value, inSpace.value, cut.value];
        void [meshEdges.value, slipSurfaces.value, strainRidge.value, pickedPoint.value, arrowArrays.value];
        void [limitMode.value, waterTables.value, chosenSurfaces.value];
        this.request();
      }),
    );
    this.resize();
  }

  private makePainter(): Painter {
    let painter: Painter;
    try {
      painter = makeGlPainter(() => this.fallBack());
    } catch {
      painter = makePlainPainter();
    }
    painter.canvas.className = "viewer-body";
    return painter;
  }

  /** Goes on with the plain canvas when the device takes WebGL away. */
  private fallBack(): void {
    const old = this.painter;
    this.painter = makePlainPainter();
    this.painter.canvas.className = "viewer-body";
    old.canvas.replaceWith(this.painter.canvas);
    this.resize();
  }

  private changeTheme(): void {
    this.theme = readTheme();
    this.request();
  }

  private resize(): void {
    const width = this.host.clientWidth;
    if (!width) return;
    this.density = Math.min(2, devicePixelRatio || 1);
    this.layOut(width);
    const { height } = this.camera;
    this.host.style.height = `${height + 2}px`;
    this.painter.resize(width, height, this.density);
    this.lines.width = Math.round(width * this.density);
    this.lines.height = Math.round(height * this.density);
    this.draw();
  }

  private layOut(width: number): void {
    layOut(this.camera, width);
    if (!this.touched) this.fitted = null;
  }

  request(): void {
    if (!this.pending) this.pending = requestAnimationFrame(() => ((this.pending = 0), this.draw()));
  }

  /** Calls when the reader moved the view: it is kept then when the box changes its size. */
  moved(): void {
    this.setTouched(true);
    this.request();
  }

  /** Shows everything, as it was in the beginning. */
  fit(): void {
    this.fitted = null;
    this.setTouched(false);
    this.request();
  }

  /** Looks at the whole model from these angles [rad]. */
  look(azimuth: number, elevation: number): void {
    this.fitted = { id: "", space: inSpace.value };
    Object.assign(this.camera, { azimuth, elevation });
    this.setTouched(false);
    this.request();
  }

  /** A finger scrolls the page over a view that is whole; one that was zoomed or turned follows the finger. */
  private setTouched(touched: boolean): void {
    this.touched = touched;
    this.host.style.touchAction = touched ? "none" : "";
  }

  private fitOnce(): void {
    const now = shown.value!;
    if (this.fitted && this.fitted.id === now.sequence.id && this.fitted.space === inSpace.value) return;
    if (this.fitted && this.touched && this.fitted.space === inSpace.value) return;
    if (this.fitted?.space !== inSpace.value && !(this.touched && this.camera.azimuth)) {
      [this.camera.azimuth, this.camera.elevation] = inSpace.value ? [-0.4, 0.3] : [0, 0];
    }
    if (!inSpace.value) [this.camera.azimuth, this.camera.elevation] = [0, 0];
    const [low, high] = now.box;
    const depth = findDepth();
    this.camera.fit([low[0], low[1], depth[0]], [high[0], high[1], depth[1]]);
    this.fitted = { id: now.sequence.id, space: inSpace.value };
    const whole = this.camera.scale;
    this.camera.scales = [whole / 8, Math.max(whole, largestSpacing / (now.spacing * this.density))];
  }

  /** Position of a point in a frame, by default the shown one [m]; NaN where it is absent. */
  locate(index: number, at = frame.value): Vec {
    const now = shown.value!;
    const { dimension } = report.value.model;
    const from = (at * now.sequence.point_count + index) * dimension;
    return [now.positions[from]!, now.positions[from + 1]!, dimension === 3 ? now.positions[from + 2]! : 0];
  }

  /** Present position of the point that was nearest to a place in the first frame [m]. */
  private follow(at: readonly number[]): Vec {
    return this.locate(this.findNearest(at));
  }

  /** A place of the first frame, moved as the point that was nearest to it [m]. */
  private carry(at: readonly number[]): [number, number] {
    const nearest = this.findNearest(at);
    const [now, first] = [this.locate(nearest), this.locate(nearest, 0)];
    return [at[0]! + now[0] - first[0], at[1]! + now[1] - first[1]];
  }

  /** Supports at the end of the stages as they were calculated, with their slip; in other frames carried by the soil. */
  private findBars(): number[][][] {
    const now = shown.value!;
    const { supports } = report.value.result;
    const isEnd = now.sequence.id === "stages" && frame.value === now.sequence.frames.length - 1;
    if (isEnd && supports) return supports.map(({ line }) => line.map((at) => at.map((x) => x ?? NaN)));
    return carryBars((at) => this.carry(at));
  }

  private findNearest(at: readonly number[]): number {
    const now = shown.value!;
    const key = `${now.sequence.id} ${at.join(" ")}`;
    let nearest = this.nearest.get(key);
    if (nearest === undefined) {
      nearest = 0;
      let least = Infinity;
      for (let i = 0; i < now.sequence.point_count; ++i) {
        const [x, y] = this.locate(i, 0);
        const distance = Math.hypot(x - at[0]!, y - at[1]!);
        if (distance < least) [least, nearest] = [distance, i];
      }
      this.nearest.set(key, nearest);
    }
    return nearest;
  }

  /** Index of the point with a number, or undefined. */
  findIndex(id: number): number | undefined {
    const ids = shown.value!.ids;
    if (this.indexOf?.ids !== ids) this.indexOf = { ids, map: new Map(Array.from(ids, (n, i) => [n, i])) };
    return this.indexOf.map.get(id);
  }

  private describeOverlay(): Overlay {
    const now = shown.value!;
    const { model } = report.value;
    const monitors = model.monitors.map((m) => {
      const index = this.findIndex(m.id);
      const original: Vec = [m.at[0]!, m.at[1]!, m.at[2] ?? 0];
      return { name: m.name, at: index === undefined ? original : this.locate(index) };
    });
    const index = pickedPoint.value;
    const picked = index !== null && index < now.sequence.point_count ? index : null;
    return {
      model,
      layers: layers.value,
      inSpace: inSpace.value,
      depth: findDepth(),
      box: now.box,
      slips: slipSurfaces.value,
      ridge: strainRidge.value,
      otherSurfaces: model.dimension === 2 ? listOtherSurfaces() : [],
      waterTables: waterTables.value,
      hydraulics: report.value.water?.conditions ?? [],
      time: now.sequence.frames[frame.value]?.time ?? 0,
      present: cells.value?.outlines ?? [],
      follow: (at) => this.follow(at),
      bars: this.findBars(),
      arrows: chooseArrows(this.camera),
      monitors,
      picked: picked === null ? null : this.locate(picked),
      path: picked === null ? [] : now.sequence.frames.map((_, f) => this.locate(picked, f)),
    };
  }

  private drawLines(context: CanvasRenderingContext2D, theme: Theme): void {
    drawOverlay(context, this.describeOverlay(), this.camera, theme);
    if (bar.value) drawScaleBar(context, bar.value, this.camera.width, this.camera.height, theme);
  }

  draw(): void {
    if (!shown.value || !this.camera.width) return;
    this.fitOnce();
    this.painter.draw(describeBody(this.theme), this.camera);
    const context = this.lines.getContext("2d")!;
    context.setTransform(this.density, 0, 0, this.density, 0, 0);
    context.clearRect(0, 0, this.camera.width, this.camera.height);
    this.drawLines(context, this.theme);
    if (!performance.getEntriesByName("talus-interactive").length) performance.mark("talus-interactive");
  }

  /** Draws body and lines onto another canvas; within drawElsewhere only. */
  drawInto(context: CanvasRenderingContext2D, theme: Theme, density: number): void {
    const { width, height } = this.camera;
    this.painter.resize(width, height, density);
    this.painter.draw(describeBody(theme), this.camera);
    context.drawImage(this.painter.canvas, 0, 0, width, height);
    this.drawLines(context, theme);
  }

  /** Calls `draw` with the view laid out for a width [px], or as it is, and goes back; false: nothing to draw. */
  drawElsewhere(wanted: number | null, draw: () => void): boolean {
    if (!shown.value || !this.lines.width) return false;
    const { camera, fitted } = this;
    const { width, height, margins, scale: magnification } = camera;
    const target: Vec = [...camera.target];
    if (wanted !== null) {
      this.layOut(wanted);
      if (this.touched) camera.scale *= wanted / width;
      else this.fitOnce();
    }
    draw();
    Object.assign(camera, { width, height, margins, scale: magnification, target });
    this.fitted = fitted;
    this.painter.resize(width, height, this.density);
    this.draw();
    return true;
  }

  save(name: string): void {
    savePicture(this, this.theme, name);
  }

  dispose(): void {
    cancelAnimationFrame(this.pending);
    this.ends.forEach((end) => end());
    this.painter.dispose();
    this.host.replaceChildren();
  }
}
