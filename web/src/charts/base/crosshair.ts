// SPDX-License-Identifier: MIT
/** The lines that a chart moves without being drawn again: the crosshair with its marks, and the viewer's time. */
import type { Scale } from "@observablehq/plot";

/** A value that the crosshair marks, in the units of the axes. */
export interface CrossMark {
  value: number;
  colour: string;
  /** Position along the crosshair's axis; default: at the stop. */
  at?: number;
}

const namespace = "http://www.w3.org/2000/svg";

function append(parent: Element, tag: string, attributes: Record<string, string | number>): Element {
  const element = document.createElementNS(namespace, tag);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  parent.append(element);
  return element;
}

export class Crosshair {
  private readonly svg: SVGSVGElement;
  private readonly along: "x" | "y";
  /** The axis that the crosshair runs along, and that of the values. */
  private readonly stops: Scale;
  private readonly values: Scale;
  private readonly group: Element;
  private readonly ruler: Element;

  constructor(svg: SVGSVGElement, x: Scale, y: Scale, along: "x" | "y") {
    this.svg = svg;
    this.along = along;
    this.stops = along === "x" ? x : y;
    this.values = along === "x" ? y : x;
    this.ruler = append(svg, "g", { class: "chart-ruler" });
    this.group = append(svg, "g", { class: "chart-cross" });
  }

  /** Abscissa under a place of the window [px]. */
  invert(clientX: number, clientY: number): number | null {
    const box = this.svg.getBoundingClientRect();
    if (box.width === 0 || !this.stops.invert) return null;
    const drawn = this.svg.viewBox.baseVal;
    const fraction = this.along === "x" ? (clientX - box.left) / box.width : (clientY - box.top) / box.height;
    const place = fraction * (this.along === "x" ? drawn.width : drawn.height);
    const [low, high] = readRange(this.stops);
    return this.stops.invert(Math.min(Math.max(place, low), high)) as number;
  }

  moveTo(stop: number | null, marks: CrossMark[]) {
    this.group.replaceChildren();
    if (stop === null || this.drawLine(this.group, stop) === null) return;
    const [low, high] = readRange(this.values);
    for (const mark of marks) {
      const a = this.stops.apply(mark.at ?? stop) as number;
      const b = this.values.apply(mark.value) as number;
      if (!Number.isFinite(b) || b < low - 1 || b > high + 1) continue;
      const [cx, cy] = this.along === "x" ? [a, b] : [b, a];
      append(this.group, "circle", { cx, cy, r: 4.5, fill: "none", stroke: mark.colour, "stroke-width": 2 });
    }
  }

  moveRuler(stop: number | null) {
    this.ruler.replaceChildren();
    if (stop !== null) this.drawLine(this.ruler, stop);
  }

  private drawLine(parent: Element, stop: number): number | null {
    const a = this.stops.apply(stop) as number;
    const [low, high] = readRange(this.stops);
    if (!Number.isFinite(a) || a < low - 1 || a > high + 1) return null;
    const [from, to] = readRange(this.values);
    const ends = this.along === "x" ? { x1: a, x2: a, y1: from, y2: to } : { x1: from, x2: to, y1: a, y2: a };
    append(parent, "line", ends);
    return a;
  }
}

/** The ends of a scale on the screen [px], the smaller first. */
function readRange(scale: Scale): [number, number] {
  const [a, b] = scale.range as [number, number];
  return [Math.min(a, b), Math.max(a, b)];
}
