// SPDX-License-Identifier: MIT
/** A chart: Observable Plot as wide as its box, with a crosshair for mouse, touch and keyboard that moves without drawing anew. */
import * as Plot from "@observablehq/plot";
import type { Scale } from "@observablehq/plot";
import { effect, type Signal, signal } from "@preact/signals";
import { useLayoutEffect, useRef, useState } from "preact/hooks";

import { printing } from "../../state";
import { findNearest } from "./rows";

/** A value that the crosshair marks, in the units of the axes. */
interface CrossMark {
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

class Crosshair {
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

interface ChartProps {
  /** Name of the chart for assistive technology. */
  label: string;
  draw: (width: number) => Plot.PlotOptions;
  /** Dependencies of `draw` besides the width. */
  depends: unknown[];
  /** Axis that the crosshair runs along. */
  along?: "x" | "y";
  /** Ascending abscissas at which the crosshair stops. */
  stops: ArrayLike<number>;
  /** Abscissa of the crosshair; charts with the same signal move together. */
  cross?: Signal<number | null>;
  /** Reading of the crosshair at a stop, and its marks (in the units of the axes). */
  read: (stop: number) => { text: string; marks: CrossMark[] };
  /** The reading is for screen readers only. */
  quiet?: boolean;
  /** Text in place of a reading before the first one. */
  hint?: string;
  onPick?: (stop: number) => void;
  /** Abscissa of a second line that the viewer moves; read inside an effect. */
  ruler?: () => number | null;
  /** Largest width in print [px]. */
  printWidth?: number;
}

const steps: Record<string, (i: number, last: number) => number> = {
  ArrowLeft: (i) => i - 1,
  ArrowDown: (i) => i - 1,
  ArrowRight: (i) => i + 1,
  ArrowUp: (i) => i + 1,
  PageDown: (i, last) => i - Math.max(1, Math.round(last / 10)),
  PageUp: (i, last) => i + Math.max(1, Math.round(last / 10)),
  Home: () => 0,
  End: (_, last) => last,
};

/** Plot with a left margin that fits the longest text of its ordinate. */
function drawPlot(options: Plot.PlotOptions): ReturnType<typeof Plot.plot> {
  const plot = Plot.plot(options);
  const texts = plot.querySelectorAll('[aria-label="y-axis tick label"] text');
  const room = 18 + 6.2 * Math.max(0, ...Array.from(texts, (text) => text.textContent?.length ?? 0));
  return room > (options.marginLeft ?? room) ? Plot.plot({ ...options, marginLeft: room }) : plot;
}

export function Chart(props: ChartProps) {
  const box = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  const [own] = useState(() => signal<number | null>(null));
  const cross = props.cross ?? own;
  const crosshair = useRef<Crosshair | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const drawn = printing.value ? Math.min(width || 640, props.printWidth ?? 660) : width;

  useLayoutEffect(() => {
    const element = box.current!;
    const measure = () => setWidth(Math.floor(element.clientWidth));
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  useLayoutEffect(() => {
    if (drawn <= 0) return;
    const options = latest.current.draw(drawn);
    const plot = drawPlot({ ...options, width: drawn, className: "talus-plot" });
    const svg = plot as unknown as SVGSVGElement;
    svg.setAttribute("aria-hidden", "true");
    box.current!.replaceChildren(svg);
    const along = latest.current.along ?? "x";
    const hair = new Crosshair(svg, plot.scale("x")!, plot.scale("y")!, along);
    crosshair.current = hair;
    const stopCross = effect(() => {
      const { stops, read } = latest.current;
      const i = cross.value === null ? -1 : findNearest(stops, cross.value);
      hair.moveTo(i < 0 ? null : stops[i]!, i < 0 ? [] : read(i).marks);
    });
    const stopRuler = effect(() => hair.moveRuler(latest.current.ruler?.() ?? null));
    return () => {
      stopCross();
      stopRuler();
    };
  }, [drawn, cross, ...props.depends]);

  const stops = props.stops;
  const find = () => (cross.value === null ? -1 : findNearest(stops, cross.value));
  const at = find();
  const reading = at < 0 ? "" : props.read(at).text;
  const follow = (event: PointerEvent) => {
    const x = crosshair.current?.invert(event.clientX, event.clientY) ?? null;
    const i = x === null ? -1 : findNearest(stops, x);
    cross.value = i < 0 ? null : stops[i]!;
  };
  const press = (event: KeyboardEvent) => {
    const last = stops.length - 1;
    const step = steps[event.key];
    if (last < 0) return;
    if (step) {
      // The first key press starts from the side that it goes away from.
      const start = at < 0 ? (/Left|Down/.test(event.key) ? last + 1 : -1) : at;
      cross.value = stops[Math.min(last, Math.max(0, step(start, last)))]!;
    } else if ((event.key === "Enter" || event.key === " ") && at >= 0 && props.onPick) props.onPick(at);
    else if (event.key === "Escape") cross.value = null;
    else return;
    event.preventDefault();
  };

  return (
    <div class="chart">
      <p class={props.quiet ? "unseen" : "chart-reading"} aria-live="polite">
        {reading || props.hint}
      </p>
      <div
        ref={box}
        class={props.onPick ? "chart-box chart-picks" : "chart-box"}
        role="slider"
        tabIndex={0}
        aria-label={`${props.label}. Arrow keys read it${props.onPick ? ", Enter shows it in the viewer" : ""}.`}
        aria-valuemin={stops.length ? stops[0] : 0}
        aria-valuemax={stops.length ? stops[stops.length - 1] : 0}
        aria-valuenow={at < 0 ? (stops[0] ?? 0) : stops[at]}
        aria-valuetext={at < 0 ? "nothing read yet" : `${at + 1} of ${stops.length}`}
        onPointerMove={follow}
        onPointerDown={follow}
        onPointerLeave={(event) => {
          // After a touch the reading stays, for the finger no longer hides it.
          if (event.pointerType !== "touch") cross.value = null;
        }}
        onBlur={() => (cross.value = null)}
        onClick={(event) => {
          follow(event as unknown as PointerEvent);
          const i = find();
          if (i >= 0) props.onPick?.(i);
        }}
        onKeyDown={press}
      />
    </div>
  );
}
