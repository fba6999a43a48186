// SPDX-License-Identifier: MIT
/** Strength reduction by FEM: factors by both criteria, the picture at failure, the trials. */
import { useState } from "preact/hooks";

import { Choice, CsvButton } from "../charts/base/Legend";
import { formatNumber, formatQuantity, titleWithUnit } from "../charts/base/numbers";
import { ChartTable } from "../page/DataTable";
import type { ReductionSoFar } from "../contract";
import { formatCount, formatFactor, formatSentence } from "../page/format";
import { report } from "../state";
import { ElementsFigure } from "./ElementsFigure";
import { ReductionChart } from "./ReductionChart";
import { type FlowRun, flowRuns } from "./fields";

function TrialTable({ runs }: { runs: Pick<FlowRun, "title" | "trials">[] }) {
  const { displacement: unit } = report.value.units;
  const rows = runs.flatMap((run) => run.trials.map((trial) => ({ run, trial })));
  const take = <K extends keyof (typeof rows)[number]["trial"]>(key: K) => rows.map(({ trial }) => trial[key]);
  const columns = () => [
    { name: "flow", values: rows.map(({ run }) => run.title) },
    { name: "factor", unit: "-", values: take("factor") },
    { name: "equilibrium", values: rows.map(({ trial }) => (trial.converged ? "yes" : "no")) },
    { name: "iterations", unit: "-", values: take("iterations") },
    { name: "force residual", unit: "-", values: take("force_residual") },
    { name: "displacement residual", unit: "-", values: take("displacement_residual") },
    { name: "largest displacement", unit: unit.name, values: take("displacement").map((u) => u / unit.si) },
    { name: "time", unit: "s", values: take("seconds") },
  ];
  return (
    <figure class="chart-figure" aria-label="Trials of the strength reduction">
      <div class="chart-head">
        <h4>Trials</h4>
        <CsvButton part="finite-element-trials" columns={columns} />
      </div>
      <details>
        <summary class="elements-summary">
          {rows.length} trials, {rows.filter(({ trial }) => trial.converged).length} of them in equilibrium
        </summary>
        <ChartTable
          label="Trials of the strength reduction by FEM"
          rows={rows}
          columns={[
            runs.length > 1 && ["Flow", ({ run }) => run.title],
            ["F", ({ trial }) => trial.factor.toFixed(4), "name number"],
            [
              "Equilibrium",
              ({ trial }) =>
                trial.converged ? <span class="chart-good">✓ found</span> : <span class="chart-bad">✗ none</span>,
            ],
            ["Iterations", ({ trial }) => formatNumber(trial.iterations), "number"],
            ["Force residual", ({ trial }) => formatNumber(trial.force_residual, 2), "wrap"],
            ["Displacement residual", ({ trial }) => formatNumber(trial.displacement_residual, 2), "wrap"],
            [
              titleWithUnit("Largest displacement", unit.name),
              ({ trial }) => formatNumber(trial.displacement / unit.si, 4),
              "wrap",
            ],
            ["Time [s]", ({ trial }) => formatNumber(trial.seconds, 3), "number"],
          ]}
        />
      </details>
    </figure>
  );
}

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
      rows={runs}
      columns={[
        ["Flow", (run) => run.title, "name"],
        ["ψ", (run) => describeAngles(run.psi), "number"],
        ["F, non-convergence", (run) => <strong>{formatFactor(run.factor, "none")}</strong>, "number"],
        ["between", (run) => `${formatFactor(run.stable, "none")} and ${formatFactor(run.failed, "none")}`, "number"],
        ["F, sharp rise of displacement", (run) => formatFactor(run.by_displacement, "none"), "number"],
      ]}
    />
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

/** Why the size of the fields has no meaning. */
const noteAtFailure =
  "Displacements and strains since the equilibrium at full strength, in the last trial without equilibrium: their " +
  "pattern tells the mechanism, their size has no meaning.";
const noteOfTrial = "Displacements and strains since the equilibrium at full strength, in the last trial.";

const atFailure = (run: FlowRun) => ({
  ...run,
  heading: `At F = ${run.failed.toFixed(3)}, without equilibrium (${run.title})`,
  note: noteAtFailure,
});

/** The strength reduction of a run in progress. */
function InProgress({ reduction }: { reduction: ReductionSoFar }) {
  const { title, stable, failed, trials } = reduction;
  const last = trials.at(-1);
  const run = { flow: "as_given" as const, title, trials: trials.toSorted((a, b) => a.factor - b.factor), failed };
  return (
    <section class="chart-section" aria-labelledby="chart-elements-title">
      <h3 id="chart-elements-title">Finite elements (FEM), in progress</h3>
      <p>
        {title}: {formatCount(trials.length, "trial", "trials")} so far; equilibrium{" "}
        {stable === undefined ? "in none" : `up to F = ${stable.toFixed(3)}`}
        {failed !== undefined && `, none at F = ${failed.toFixed(3)}`}.
      </p>
      {last && reduction.fields && (
        <ElementsFigure
          run={{
            ...reduction,
            slip_lines: [],
            heading: `Trial at F = ${last.factor.toFixed(3)}, ${last.converged ? "in equilibrium" : "without equilibrium"}`,
            note: noteOfTrial,
          }}
        />
      )}
      <ReductionChart runs={[run]} />
      <TrialTable runs={[run]} />
    </section>
  );
}

export function ElementsSection() {
  const { result, reduction } = report.value;
  const elements = result.fem;
  const [flow, setFlow] = useState("");
  if (!elements) return reduction ? <InProgress reduction={reduction} /> : null;
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
      {run?.fields ? <ElementsFigure run={atFailure(run)} /> : run && <NotDrawn element={elements.element} />}
      {runs.length > 0 && <ReductionChart runs={runs} />}
      {runs.length > 0 && <TrialTable runs={runs} />}
    </section>
  );
}
