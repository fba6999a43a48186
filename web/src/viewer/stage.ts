/** The stage: two canvases, the body below and the lines above, the camera, and when they are drawn anew. */
import { effect } from "@preact/signals";

import { pickedPoint, report } from "../state";
import { Camera, type Margins, type Vec } from "./camera";
import { tabulateColours } from "./colours";
import { makeGlPainter } from "./glPainter";
import { drawOverlay, type Overlay } from "./overlay";
import type { Body, Painter } from "./painter";
import { makePlainPainter } from "./plainPainter";
import { drawScaleBar, uprightFrom } from "./scaleBar";
import { colourMap, cut, inSpace, layers } from "./settings";
import { frame, limits, meshEdges, shown, slipSurface, strainRidge, takeFrame } from "./shown";
import { paperTheme, readTheme, watchTheme, type Theme } from "./theme";

/** Slices that a section is repeated in when it is turned in space. */
const slabSlices = 6;

/** Width that the picture is laid out in for paper [px], so that its texts can be read there. */
const paperWidth = 760;

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
  /** Whether each point's number stands at its index. */
  private indexOf: { ids: Float32Array; map: Map<number, number> } | null = null;

  constructor(private readonly host: HTMLElement) {
    this.painter = this.makePainter();
    this.lines.className = "viewer-lines";
    this.paper.className = "viewer-paper";
    host.append(this.painter.canvas, this.lines, this.paper);
    const observer = new ResizeObserver(() => this.resize());
    observer.observe(host);
    this.ends.push(() => observer.disconnect());
    this.ends.push(watchTheme(() => this.changeTheme()));
    const toPaper = () => this.drawOnPaper();
    addEventListener("beforeprint", toPaper);
    this.ends.push(() => removeEventListener("beforeprint", toPaper));
    this.ends.push(
      effect(() => {
        void [shown.value, frame.value, limits.value, colourMap.value, layers.value, inSpace.value, cut.value];
        void [meshEdges.value, slipSurface.value, strainRidge.value, pickedPoint.value];
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

  /** Shares a width out between the body and what stands around it. */
  private layOut(width: number): void {
    const upright = width >= uprightFrom;
    const margins = { left: upright ? 62 : 52, right: upright ? 126 : 24, top: upright ? 34 : 70, bottom: 48 };
    Object.assign(this.camera, { width, height: chooseHeight(width, margins), margins });
    if (!this.touched) this.fitted = null;
  }

  request(): void {
    if (!this.pending) this.pending = requestAnimationFrame(() => ((this.pending = 0), this.draw()));
  }

  /** Calls when the reader moved the view: it is kept then when the box changes its size. */
  moved(): void {
    this.touched = true;
    this.request();
  }

  fit(): void {
    this.fitted = null;
    this.touched = false;
    this.request();
  }

  /** Front and back of what is shown along z [m]. */
  private findDepth(): [number, number] {
    const [low, high] = shown.value!.box;
    if (report.value.model.dimension === 3) return [low[2], high[2]];
    const depth = inSpace.value ? (slabSlices - 1) * shown.value!.spacing : 0;
    return [-depth, 0];
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
    const depth = this.findDepth();
    this.camera.fit([low[0], low[1], depth[0]], [high[0], high[1], depth[1]]);
    this.fitted = { id: now.sequence.id, space: inSpace.value };
    // Graphics processors draw no larger points than some 500 device pixels.
    this.camera.scales = [this.camera.scale / 8, Math.max(this.camera.scale, 500 / (2.1 * now.spacing * this.density))];
  }

  private describeBody(theme: Theme): Body {
    const now = shown.value!;
    const { dimension } = report.value.model;
    const [low, high] = now.box;
    const count = now.sequence.point_count;
    const ends = (end: 0 | 1) => low.map((l, k) => l + (high[k]! - l) * cut.value[k]![end] + (end ? 1e-6 : -1e-6));
    const solid = dimension === 3;
    const walls = report.value.model.bounds;
    return {
      dimension,
      count,
      positions: takeFrame(now.positions, frame.value, count, dimension),
      values: takeFrame(now.values, frame.value, count),
      limits: limits.value,
      colours: tabulateColours(colourMap.value ?? (now.field.diverging ? "blueRed" : "viridis")),
      size: now.spacing * (solid ? 1.5 : 2.4),
      slices: inSpace.value && !solid ? Array.from({ length: slabSlices }, (_, i) => -i * now.spacing) : [0],
      shaded: inSpace.value,
      cut: solid ? [ends(0), ends(1)] : [[-1e9, -1e9, -1e9], [1e9, 1e9, 1e9]],
      extent: Math.hypot(...high.map((h, k) => h - low[k]!)) + 10 * now.spacing,
      walls: [walls[0][0]!, walls[0][1]!, walls[1][0]!, Infinity],
      showPoints: layers.value.points,
      edges: layers.value.mesh ? meshEdges.value : null,
      edgeColour: layers.value.points && !inSpace.value ? "#20262e" : theme.muted,
    };
  }

  /** Where a point stands in the shown frame [m]. */
  locate(index: number): Vec {
    const now = shown.value!;
    const { dimension } = report.value.model;
    const from = (frame.value * now.sequence.point_count + index) * dimension;
    return [now.positions[from]!, now.positions[from + 1]!, dimension === 3 ? now.positions[from + 2]! : 0];
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
    return {
      model,
      layers: layers.value,
      inSpace: inSpace.value,
      depth: this.findDepth(),
      box: now.box,
      slip: slipSurface.value,
      ridge: strainRidge.value,
      monitors,
      picked: index !== null && index < now.sequence.point_count ? this.locate(index) : null,
    };
  }

  private drawLines(context: CanvasRenderingContext2D, body: Body, theme: Theme): void {
    const now = shown.value!;
    drawOverlay(context, this.describeOverlay(), this.camera, theme);
    const [low, high] = now.field.values.range ?? limits.value;
    const { limits: ends, colours } = body;
    const bar = { field: now.field, limits: ends, colours, below: low < ends[0], above: high > ends[1] };
    drawScaleBar(context, bar, this.camera.width, this.camera.height, theme);
  }

  draw(): void {
    if (!shown.value || !this.camera.width) return;
    this.fitOnce();
    const body = this.describeBody(this.theme);
    this.painter.draw(body, this.camera);
    const context = this.lines.getContext("2d")!;
    context.setTransform(this.density, 0, 0, this.density, 0, 0);
    context.clearRect(0, 0, this.camera.width, this.camera.height);
    this.drawLines(context, body, this.theme);
    if (!performance.getEntriesByName("talus-interactive").length) performance.mark("talus-interactive");
  }

  /** Draws everything onto one canvas, on a filled ground. */
  compose(canvas: HTMLCanvasElement, theme: Theme, density: number): void {
    const { width, height } = this.camera;
    if (!shown.value || !this.lines.width) return;
    canvas.width = Math.round(width * density);
    canvas.height = Math.round(height * density);
    const context = canvas.getContext("2d")!;
    context.setTransform(density, 0, 0, density, 0, 0);
    context.fillStyle = theme.ground;
    context.fillRect(0, 0, width, height);
    const body = this.describeBody(theme);
    this.painter.resize(width, height, density);
    this.painter.draw(body, this.camera);
    context.drawImage(this.painter.canvas, 0, 0, width, height);
    this.drawLines(context, body, theme);
  }

  /** Goes back to the screen after drawing elsewhere. */
  private restore(): void {
    this.painter.resize(this.camera.width, this.camera.height, this.density);
    this.draw();
  }

  /** Paper is white whatever the screen is, and a canvas of WebGL does not survive every printing. */
  private drawOnPaper(): void {
    if (!shown.value || !this.lines.width) return;
    const { camera, fitted } = this;
    const { width, height, margins, scale } = camera;
    const target: Vec = [...camera.target];
    this.layOut(paperWidth);
    if (this.touched) camera.scale *= paperWidth / width;
    else this.fitOnce();
    this.compose(this.paper, paperTheme, 2.5);
    Object.assign(camera, { width, height, margins, scale, target });
    this.fitted = fitted;
    this.restore();
    this.host.classList.add("viewer-has-paper");
  }

  /** Saves the picture as it is seen, at twice the resolution. */
  save(name: string): void {
    const canvas = document.createElement("canvas");
    this.compose(canvas, this.theme, 2);
    this.restore();
    canvas.toBlob((blob) => {
      if (!blob) return;
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    }, "image/png");
  }

  dispose(): void {
    cancelAnimationFrame(this.pending);
    this.ends.forEach((end) => end());
    this.painter.dispose();
    this.host.replaceChildren();
  }
}
