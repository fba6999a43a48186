// SPDX-License-Identifier: MIT
/** Displacement over strength reduction factor of FEM: where equilibrium ends. */
import * as Plot from "@observablehq/plot";
import { useMemo, useState } from "preact/hooks";

import { layOut, makeAxis } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { AxisChoice, type AxisKind, Legend, useSwitches } from "../charts/base/Legend";
import { formatQuantity } from "../charts/base/numbers";
import { styleOf } from "../charts/base/styles";
import { report } from "../state";
import type { FlowRun } from "./fields";

/** Without factors while it is in progress. */
export type ChartedRun = Pick<FlowRun, "flow" | "title" | "trials"> & Partial<Pick<FlowRun, "factor" | "failed" | "by_displacement">>;

export function ReductionChart({ runs }: { runs: ChartedRun[] }) {
  const { displacement: unit } = report.value.units;
  const [axis, setAxis] = useState<AxisKind>("linear");
  const [hidden, toggle] = useSwitches();
  // Failed trials far above the factor carry no information, and would compress the curve.
  const beyond = useMemo(() => {
    const least = Math.min(...runs.flatMap((r) => r.trials.map((t) => t.factor)));
    const failed = Math.max(...runs.map((r) => r.failed ?? Infinity));
    return failed + 0.4 * Math.max(failed - least, 0.1);
  }, [runs]);
  const points = useMemo(
    () =>
      runs
        .flatMap((run, k) => run.trials.map((t) => ({ ...t, k, run, u: t.displacement / unit.si })))
        .filter((p) => p.factor <= beyond)
        .sort((a, b) => a.factor - b.factor),
    [runs],
  );
  const seen = points.filter((p) => !hidden.has(p.run.flow) && (axis === "linear" || p.u > 0));
  const stops = seen.map((p) => p.factor);
  const highest = Math.max(1e-12, ...seen.map((p) => p.u));
  const settled = Math.max(0, ...seen.filter((p) => p.converged).map((p) => p.u));
  // Displacements without equilibrium grow with the number of iterations: they must not flatten the curve.
  const largest = axis === "linear" && settled > 0 ? Math.min(highest, 2.5 * settled) : highest;
  const shown = (u: number) => Math.min(u, largest);
  const smallest = Math.min(largest, ...seen.filter((p) => p.u > 0).map((p) => p.u));
  const draw = (width: number) =>
    layOut({
      height: Math.max(280, Math.min(360, width * 0.5)),
      margins: [28, 20, 46, 62],
      x: { label: "Strength reduction factor F", ticks: Math.max(4, width / 90) },
      y: makeAxis({
        title: "Largest displacement",
        unit: unit.name,
        domain: axis === "log" ? [smallest / 1.3, largest * 1.3] : [0, largest * 1.05],
        log: axis === "log",
      }),
      marks: runs.map((run, k) => {
        if (hidden.has(run.flow)) return null;
        const own = seen.filter((p) => p.k === k);
        const [settledOnes, others] = [own.filter((p) => p.converged), own.filter((p) => !p.converged)];
        const { colour, dash } = styleOf(k);
        const place = { x: "factor", y: "u", stroke: colour };
        return [
          run.factor === undefined ? null : Plot.ruleX([run.factor], { stroke: colour, strokeDasharray: "4 3" }),
          run.by_displacement === null || run.by_displacement === undefined
            ? null
            : Plot.ruleX([run.by_displacement], { stroke: colour, strokeDasharray: "1.5 3" }),
          Plot.line(settledOnes, { ...place, strokeWidth: 1.6, strokeDasharray: dash }),
          Plot.dot(settledOnes, { ...place, r: 3.5, fill: colour }),
          Plot.dot(others, {
            ...place,
            y: (p: (typeof own)[number]) => shown(p.u),
            r: 4.5,
            symbol: "times",
            strokeWidth: 2,
          }),
        ];
      }),
    });
  return (
    <figure class="chart-figure" aria-label="Displacement over strength reduction factor, FEM">
      <div class="chart-head">
        <h4>Displacement over strength reduction factor</h4>
        <AxisChoice label="Axis of the displacement" value={axis} onChange={setAxis} />
      </div>
      <Legend
        hidden={hidden}
        onToggle={runs.length > 1 ? toggle : undefined}
        items={runs.map((run, k) => ({ id: run.flow, title: run.title, style: styleOf(k) }))}
      />
      <Chart
        label="Largest displacement over strength reduction factor by FEM"
        draw={draw}
        depends={[axis, hidden, runs]}
        stops={stops}
        hint="Point at a trial to read it: dots converged, crosses did not."
        read={(i) => {
          const p = seen[i]!;
          const state = p.converged ? "converged" : "not converged";
          return {
            text: `F = ${p.factor.toFixed(4)}: ${formatQuantity(p.u, unit.name, 3)}, ${state} after ${p.iterations} iterations (${p.run.title})`,
            marks: [{ value: shown(p.u), at: p.factor, colour: styleOf(p.k).colour }],
          };
        }}
      />
      <p class="chart-note">
        Dashed: the factor of non-convergence; dotted: of the sharp rise of displacement. Crosses are trials that did
        not converge; their displacement is that of the last iteration
        {largest < highest && ", or beyond the upper edge"}.
      </p>
    </figure>
  );
}
