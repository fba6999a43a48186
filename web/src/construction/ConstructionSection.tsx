// SPDX-License-Identifier: MIT
/** Stages of construction: settlement, excess pore pressure and factors on one axis of time, monitored places, and a table of the stages. */
import * as Plot from "@observablehq/plot";

import { layOut, makeAxis } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { Legend } from "../charts/base/Legend";
import { styleOf } from "../charts/base/styles";
import type { Unit } from "../contract";
import type { Construction } from "../contract/results";
import { ChartTable } from "../page/DataTable";
import { formatFactor, formatNumber, formatQuantity } from "../page/format";
import { report } from "../state";
import { LinesOfStages, MonitorsInTime, SupportsOfStages } from "./ConstructionPlaces";
import { chooseTimeUnit, findFurthestExcess, listFactors, listSteps } from "./construction";
import { Curves } from "./Curves";
import { StageFigure } from "./StageFigure";

/** The factors of all methods at the ends of the stages. */
function Factors({ construction, time, ends }: { construction: Construction; time: Unit; ends: number[] }) {
  const factors = listFactors(construction);
  if (factors.length === 0) return null;
  const methods = [...new Set(factors.map(({ method }) => method))];
  const titles: Record<string, string> = {
    lem: "LEM",
    fem: "FEM",
    lem_undrained: "LEM, failure without drainage",
    fem_undrained: "FEM, failure without drainage",
    bounds: "Limit analysis, lower bound",
    bounds_undrained: "Limit analysis, lower bound, failure without drainage",
  };
  const points = factors.map((f) => ({ ...f, t: f.time / time.si, style: styleOf(methods.indexOf(f.method)) }));
  const values = points.map(({ factor }) => factor);
  const [low, high] = [Math.min(1, ...values), Math.max(1, ...values)];
  const pad = 0.08 * Math.max(high - low, 0.05);
  const draw = (width: number) =>
    layOut({
      height: 240,
      margins: [22, 20, 46, 62],
      x: { domain: [0, ends.at(-1) ?? 1], label: `Time [${time.name}]`, ticks: Math.max(4, width / 90) },
      y: makeAxis({ title: "Factor of safety", domain: [low - pad, high + pad], count: 4 }),
      marks: [
        Plot.ruleX(ends, { stroke: "var(--line)", strokeDasharray: "3 3" }),
        Plot.ruleY([1], { stroke: "#c2185b", strokeDasharray: "4 3" }),
        ...methods.map((method) => {
          const own = points.filter((p) => p.method === method);
          const colour = own[0]!.style.colour;
          return [
            Plot.line(own, { x: "t", y: "factor", stroke: colour, strokeDasharray: "2 4" }),
            Plot.dot(own, { x: "t", y: "factor", fill: colour, r: 4 }),
          ];
        }),
      ],
    });
  return (
    <>
      <Legend items={methods.map((method, k) => ({ id: method, title: titles[method] ?? method, style: styleOf(k) }))} />
      <Chart
        label="Factor of safety at the ends of the stages"
        draw={draw}
        depends={[construction]}
        stops={points.map(({ t }) => t)}
        read={(i) => ({
          text: `end of '${points[i]!.stage}': F = ${formatFactor(points[i]!.factor)}, ${points[i]!.title}`,
          marks: [{ value: points[i]!.factor, at: points[i]!.t, colour: points[i]!.style.colour }],
        })}
      />
    </>
  );
}

export function ConstructionSection() {
  const construction = report.value.result.construction;
  if (!construction) return null;
  const { units, construction_stages: drawn } = report.value;
  const { stages } = construction;
  const steps = listSteps(construction);
  const time = chooseTimeUnit(stages.at(-1)?.to ?? 0);
  const ends = stages.map(({ to }) => to / time.si);
  const times = steps.map((s) => s.time);
  const isWet = steps.some(({ excess, least_excess }) => excess > 0 || (least_excess ?? 0) < 0);
  const monitorTimes = times.slice(1);
  return (
    <>
      <Factors construction={construction} time={time} ends={ends} />
      <Curves
        title="Largest displacement"
        unit={units.displacement}
        along="Time"
        at={times}
        atUnit={time}
        marks={ends}
        curves={[
          { title: "settlement", values: steps.map((s) => s.settlement) },
          { title: "heave", values: steps.map((s) => s.heave) },
          { title: "horizontal", values: steps.map((s) => s.lateral) },
        ]}
      />
      {isWet && (
        <Curves
          title="Excess pressure"
          unit={units.stress}
          along="Time"
          at={times}
          atUnit={time}
          marks={ends}
          curves={[
            { title: "largest", values: steps.map((s) => s.excess) },
            { title: "least", values: steps.map((s) => s.least_excess ?? 0) },
          ]}
        />
      )}
      <MonitorsInTime construction={construction} time={time} times={monitorTimes} ends={ends} isWet={isWet} />
      <LinesOfStages construction={construction} isWet={isWet} />
      {drawn && <StageFigure construction={construction} drawn={drawn} />}
      <SupportsOfStages construction={construction} />
      <ChartTable
        label="Stages of construction"
        rows={stages}
        columns={[
          ["Stage", (s) => s.name, "name"],
          ["Ends", (s) => `${formatNumber(s.to / time.si)} ${time.name}`, "number"],
          ["Adds", (s) => s.added.join(", ") || "–"],
          ["Removes", (s) => s.removed.join(", ") || "–"],
          ["Settlement", (s) => formatQuantity(s.steps.at(-1)?.settlement, units.displacement, 3), "number"],
          ["Heave", (s) => formatQuantity(s.steps.at(-1)?.heave, units.displacement, 3), "number"],
          isWet && ["Excess pressure", (s) => formatQuantity(findFurthestExcess(s.steps.at(-1)), units.stress, 3), "number"],
          [
            "Factor",
            (s) =>
              s.error !== null ? (
                <span class="chart-reason">{s.error}</span>
              ) : (
                s.factors.map((f) => (
                  <div key={f.title}>
                    {f.factor === null ? `${f.title}: none, ${f.error ?? "no surface"}` : `${formatFactor(f.factor)} ${f.title}`}
                  </div>
                ))
              ),
          ],
          ["Steps", (s) => `${s.steps.length}`, "number"],
          ["Largest error", (s) => formatNumber(100 * Math.max(0, ...s.steps.map((x) => x.error)), 2) + " %", "number"],
        ]}
      />
      <p class="chart-note">
        Dashed lines are the ends of the stages. Excess pressure is pore pressure above that of steady flow under the conditions of the time. The error of a step is over the largest change of pore pressure of its
        stage. The results of the methods at the end of a stage have a folder of their own, {stages.find((s) => s.folder)?.folder ?? "stage_1"} and so on.
      </p>
    </>
  );
}
