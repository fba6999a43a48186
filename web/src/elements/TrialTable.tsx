// SPDX-License-Identifier: MIT
/** The trials of the strength reduction with their residuals. */
import { CsvButton } from "../charts/base/Legend";
import { formatNumber, titleWithUnit } from "../charts/base/numbers";
import { ChartTable, numbers, wrapped } from "../page/DataTable";
import { report } from "../state";
import type { FlowRun } from "./flowRuns";

export function TrialTable({ runs }: { runs: FlowRun[] }) {
  const { displacement: unit } = report.value.units;
  const rows = runs.flatMap((run) => run.trials.map((trial) => ({ run, trial })));
  const several = runs.length > 1;
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
          head={[
            several && "Flow",
            ...numbers("F"),
            "Equilibrium",
            ...numbers("Iterations"),
            ...wrapped("Force residual", "Displacement residual", titleWithUnit("Largest displacement", unit.name)),
            ...numbers("Time [s]"),
          ]}
        >
          {rows.map(({ run, trial }, i) => (
            <tr key={i}>
              {several && <td>{run.title}</td>}
              <th scope="row" class="number">
                {trial.factor.toFixed(4)}
              </th>
              <td>
                {trial.converged ? <span class="chart-good">✓ found</span> : <span class="chart-bad">✗ none</span>}
              </td>
              <td class="number">{formatNumber(trial.iterations)}</td>
              <td class="number">{formatNumber(trial.force_residual, 2)}</td>
              <td class="number">{formatNumber(trial.displacement_residual, 2)}</td>
              <td class="number">{formatNumber(trial.displacement / unit.si, 4)}</td>
              <td class="number">{formatNumber(trial.seconds, 3)}</td>
            </tr>
          ))}
        </ChartTable>
      </details>
    </figure>
  );
}
