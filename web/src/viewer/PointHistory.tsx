// SPDX-License-Identifier: MIT
/** The shown field at the picked point over the frames, as a small plot; a click goes to the frame. */
import * as Plot from "@observablehq/plot";
import { useEffect, useRef } from "preact/hooks";

import { writeNumber, writeTitle } from "./format";
import { goTo } from "./play";
import { frame, type Shown } from "./shown";

export function PointHistory(props: { now: Shown; values: Float32Array | undefined }) {
  const host = useRef<HTMLDivElement>(null);
  const { now } = props;
  const { frames, axis } = now.sequence;
  // While another sequence is being decoded the values are still those of the one before.
  const values = props.values?.length === frames.length ? props.values : undefined;
  const index = frame.value;
  const start = frames[0]!.time;
  const along = (f: number) => (axis === "factor" ? (frames[f]!.factor ?? f) : frames[f]!.time - start);
  const axisTitle = axis === "factor" ? "Strength reduction factor" : "Time [s]";

  useEffect(() => {
    if (!values || !host.current) return;
    const { si } = now.field.unit;
    const rows = Array.from(values, (value, f) => ({ x: along(f), y: Number.isNaN(value) ? null : value / si }));
    const plot = Plot.plot({
      width: 360,
      height: 190,
      marginLeft: 52,
      marginBottom: 34,
      style: { background: "transparent", fontSize: "11px" },
      x: { label: axisTitle, labelArrow: "none", ticks: 5, nice: true },
      y: { label: writeTitle(now.field.title, now.field.unit), labelArrow: "none", ticks: 5, nice: true, grid: true },
      marks: [
        Plot.lineY(rows, { x: "x", y: "y", stroke: "var(--accent, #0b62a8)", strokeWidth: 1.8 }),
        Plot.ruleX([along(index)], { stroke: "currentColor", strokeOpacity: 0.35 }),
        Plot.dot(rows.slice(index, index + 1), { x: "x", y: "y", r: 4, fill: "var(--accent, #0b62a8)" }),
      ],
    });
    plot.setAttribute("aria-hidden", "true");
    const goToClicked = (event: Event) => {
      const wanted = plot.scale("x")!.invert!((event as PointerEvent).offsetX * (360 / plot.clientWidth)) as number;
      const distance = (f: number) => Math.abs(along(f) - wanted);
      goTo(frames.reduce((best, _, f) => (distance(f) < distance(best) ? f : best), 0));
    };
    plot.addEventListener("click", goToClicked);
    host.current.replaceChildren(plot);
  });

  if (!values || values.every(Number.isNaN)) return <div class="viewer-history" ref={host} />;
  let [smallest, largest] = [0, 0];
  values.forEach((value, f) => {
    if (value < values[smallest]!) smallest = f;
    if (value > values[largest]!) largest = f;
  });
  const link = (name: string, f: number) => (
    <button type="button" class="viewer-link" onClick={() => goTo(f)}>
      {name}: {writeNumber(values[f]! / now.field.unit.si)} at {frames[f]!.label}
    </button>
  );
  return (
    <figure class="viewer-history" aria-label={`${now.field.title} at the picked point over the frames`}>
      <div ref={host} />
      <figcaption>
        {link("Largest", largest)}
        {link("Smallest", smallest)}
      </figcaption>
    </figure>
  );
}
