// SPDX-License-Identifier: MIT
/** Strength reduction by FEM: factors by both criteria, the picture at failure, the trials. */
import { useState } from "preact/hooks";

import { Choice } from "../charts/base/Legend";
import { formatNumber, formatQuantity } from "../charts/base/numbers";
import { formatFactor, formatSentence } from "../page/format";
import { ChartTable, numbers } from "../page/DataTable";
import { report } from "../state";
import { ElementsFigure } from "./ElementsFigure";
import { flowRuns, type FlowRun } from "./flowRuns";
import { ReductionChart } from "./ReductionChart";
import { TrialTable } from "./TrialTable";

function describeAngles(psi: number[]): string {
  const degrees = psi.map((angle) => `${formatNumber((angle * 180) / Math.PI, 3)}°`);
  if (degrees.length === 0) return "–";
  return degrees[0] === degrees.at(-1) ? degrees[0]! : `${degrees[0]} to ${degrees.at(-1)}`;
}

function FactorRows({ runs }: { runs: FlowRun[] }) {
  return (
    <ChartTable
      label="Factors of safety by FEM"
      class="elements-factors"
      head={["Flow", ...numbers("ψ", "F, non-convergence", "between", "F, sharp rise of displacement")]}
    >
      {runs.map((run) => (
        <tr key={run.flow}>
          <th scope="row">{run.title}</th>
          <td class="number">{describeAngles(run.psi)}</td>
          <td class="number">
            <strong>{formatFactor(run.factor, "none")}</strong>
          </td>
          <td class="number">
            {formatFactor(run.stable, "none")} and {formatFactor(run.failed, "none")}
          </td>
          <td class="number">{formatFactor(run.by_displacement, "none")}</td>
        </tr>
      ))}
    </ChartTable>
  );
}

/** Why there is no picture, and where the fields are. */
function NotDrawn({ element }: { element: string }) {
  return (
    <p>
      {element === "T10" ? "Elements in three dimensions are" : "The elements of this run are"} not drawn
      here; ParaView shows them from <code>fem.vtu</code> in the results folder.
    </p>
  );
}

export function ElementsSection() {
  const elements = report.value.result.fem;
  const [flow, setFlow] = useState("");
  if (!elements) return null;
  const runs = flowRuns.value;
  const run = runs.find((r) => r.flow === flow) ?? runs[0];
  const { length } = report.value.units;
  const warnings = [...new Set(runs.flatMap((r) => r.warnings))];
  return (
    <section class="chart-section" aria-labelledby="chart-elements-title">
      <h3 id="chart-elements-title">Finite elements (FEM)</h3>
      {elements.elements > 0 && (
        <p>
          {formatNumber(elements.elements, 6)}{" "}
          {elements.element === "T10" ? "quadratic tetrahedra" : "quadratic triangles"} of{" "}
          {formatQuantity(elements.size / length.si, length.name, 3)}, {formatNumber(elements.nodes, 6)} nodes,{" "}
          {formatNumber(elements.unknowns, 6)} unknowns; {formatQuantity(elements.seconds ?? 0, "s", 3)}.
        </p>
      )}
      {elements.error && (
        <p>
          <span class="chart-bad">No answer:</span> {formatSentence(elements.error)}
        </p>
      )}
      {runs.length > 0 && <FactorRows runs={runs} />}
      {warnings.map((text) => (
        <p key={text} class="chart-note">
          {formatSentence(text)}
        </p>
      ))}
      {runs.length > 1 && (
        <div class="chart-bar">
          <Choice
            label="Flow rule of the picture"
            value={run?.flow ?? ""}
            options={runs.map((r) => ({ value: r.flow, title: r.title }))}
            onChange={setFlow}
          />
        </div>
      )}
      {run?.fields ? <ElementsFigure run={run} /> : run && <NotDrawn element={elements.element} />}
      {runs.length > 0 && <ReductionChart runs={runs} />}
      {runs.length > 0 && <TrialTable runs={runs} />}
    </section>
  );
}
