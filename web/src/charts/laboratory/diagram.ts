// SPDX-License-Identifier: MIT
/** Common parts of the diagrams of element tests and of calibrations: margins, axes, grid. */
import * as Plot from "@observablehq/plot";

import { centred, describeAxis, formatLogTick, titleWithPower } from "../base/axes";
import { titleWithUnit } from "../base/numbers";
import { listTicks } from "./pointData";

export function capitalise(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

interface Axis {
  title: string;
  unit: string;
  /** Smallest and largest value. */
  ends: [number, number];
}

interface Look {
  height: number;
  /** Room between the frame and what is drawn [px]. */
  inset: number;
  logX: boolean;
}

export function layOutDiagram(
  x: Axis,
  y: Axis,
  { height, inset, logX }: Look,
  marks: Plot.Markish[],
): Plot.PlotOptions {
  const domain = logX ? [x.ends[0] / 1.1, x.ends[1] * 1.1] : x.ends;
  const axis = describeAxis(...y.ends, 5);
  return {
    height,
    marginLeft: 62,
    marginRight: 14,
    marginTop: 26,
    marginBottom: 44,
    x: {
      type: logX ? "log" : "linear",
      domain,
      label: titleWithUnit(capitalise(x.title), x.unit),
      ...centred,
      inset,
      ticks: logX ? listTicks(domain[0]!, domain[1]!) : 6,
      tickFormat: logX ? formatLogTick : describeAxis(...x.ends, 6).format,
    },
    y: {
      domain: y.ends,
      label: titleWithPower(capitalise(y.title), y.unit, axis.power),
      labelArrow: "none",
      ticks: 5,
      tickFormat: axis.format,
      inset,
    },
    symbol: { type: "identity" },
    marks: [
      Plot.gridY({ ticks: 5, stroke: "var(--line)", strokeOpacity: 1 }),
      y.ends[0] < 0 && y.ends[1] > 0 ? Plot.ruleY([0], { stroke: "var(--muted)" }) : [],
      marks,
    ],
  };
}
