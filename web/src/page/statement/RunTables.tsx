// SPDX-License-Identifier: MIT
/** Supports, loads and monitored places; the stages and how each ended; factors of safety and every other number. */
import type { Factor } from "../../contract";
import { report } from "../../state";
import { DataTable } from "../DataTable";
import { describeDrainage, getMethodTitle } from "../FactorTable";
import { formatDuration, formatFactor, formatNumber, formatPlace, formatQuantity, formatSentence } from "../format";
import { selectsMethod } from "../methods/settings";

export function SupportTables() {
  const { model, result } = report.value;
  const { boundaries, loads, monitors } = model;
  // LEM has no supports; FEM without given supports is fixed at the sides and at the bottom.
  const hasSupports = boundaries.length > 0 || selectsMethod(report.value, "mpm");
  if (Object.keys(result.input).length === 0) return <p>Not known: the results hold no summary of the input.</p>;
  return (
    <>
      {!hasSupports ? null : boundaries.length === 0 ? (
        <p>No boundary is held: nothing supports the soil.</p>
      ) : (
        <DataTable
          caption="Boundary conditions"
          rows={boundaries}
          columns={[
            ["Where", (boundary) => boundary.on, "name"],
            ["Condition", (boundary) => boundary.fix],
            ["Meaning", (boundary) => formatSentence(boundary.text), "prose"],
          ]}
        />
      )}
      {loads.length === 0 ? (
        <p>The results name no loads.</p>
      ) : (
        <DataTable
          caption="Loads"
          rows={loads}
          columns={[
            ["Load", (load) => load.name, "name"],
            ["Description", (load) => formatSentence(load.text), "prose"],
          ]}
        />
      )}
      {monitors.length > 0 && (
        <p>
          Monitored points:{" "}
          {monitors.map((monitor) => `${monitor.name} at ${formatPlace(monitor.at)} (point ${monitor.id})`).join("; ")}.
        </p>
      )}
    </>
  );
}

const ends: { [end: string]: string } = {
  rest: "at rest",
  time: "when its time was up",
  failed: "by failing",
  unstable: "unstable",
  interrupted: "by an interruption",
};

export function StageTable() {
  const { stages } = report.value.model;
  if (stages.length === 0) return <p>No stage has come to its end.</p>;
  return (
    <DataTable
      caption="Stages"
      quiet
      rows={stages}
      columns={[
        ["Stage", (stage) => stage.name, "name"],
        ["Settings", (stage) => formatSentence(stage.text) || "–", "prose"],
        ["Ended", (stage) => (ends[stage.end] ?? stage.end) || "–"],
        ["Simulated", ({ steps, time }) => (steps > 0 ? `${formatNumber(time)}\u00a0s` : "–"), "number"],
        ["Steps", ({ steps }) => (steps > 0 ? formatNumber(steps) : "–"), "number"],
        ["Wall time", ({ steps, wall }) => (steps > 0 ? formatDuration(wall) : "–"), "number"],
      ]}
    />
  );
}

/** How far the highest of several factors lies above the lowest. */
function describeSpread(factors: Factor[]): string {
  const values = factors.map((factor) => factor.value).filter((value) => value !== null);
  if (values.length < 2) return "";
  const low = Math.min(...values);
  const high = Math.max(...values);
  const apart = formatNumber((100 * (high - low)) / low, 2);
  return (
    `The criteria lie between ${formatFactor(low)} and ${formatFactor(high)}, ${apart} % apart. ` +
    "They answer different questions; brackets are the width of each search, and only the interval at frozen geometry " +
    "holds the error of the mesh."
  );
}

export function ResultTables() {
  const { factors, results, sentences } = report.value.answer;
  return (
    <>
      {sentences.length > 0 && <p>{sentences.map(formatSentence).join(" ")}</p>}
      {factors.length > 0 && (
        <DataTable
          caption="Factors of safety, with the bracket of each search"
          rows={factors}
          rowClass={(factor) => factor.main && "main"}
          columns={[
            ["Method", (factor) => getMethodTitle(factor.method)],
            [
              "Criterion",
              (factor) => (
                <>
                  {factor.title}
                  {factor.main && <span class="note"> (the answer)</span>}
                </>
              ),
              "name",
            ],
            factors.some((factor) => factor.water) && [
              "Pore water",
              (factor) => (factor.water ? describeDrainage(factor.water) : "–"),
            ],
            ["F", (factor) => formatFactor(factor.value, "none"), "number"],
            ["from", (factor) => formatFactor(factor.lower), "number"],
            ["to", (factor) => formatFactor(factor.upper), "number"],
            ["Found how", (factor) => formatSentence(factor.note) || "–", "prose"],
          ]}
        />
      )}
      {factors.length > 1 && <p class="note">{describeSpread(factors)}</p>}
      {results.length > 0 && (
        <DataTable
          caption="All results, by the names that comparisons use"
          rows={results}
          columns={[
            ["Result", (result) => result.title, "name"],
            ["Value", (result) => formatQuantity(result.value, result.unit, 4, true), "number"],
            ["Name", (result) => <code>{result.name}</code>],
          ]}
        />
      )}
    </>
  );
}
