// SPDX-License-Identifier: MIT
/** The stages of the calculation and how each ended. */
import { report } from "../../state";
import { DataTable, numbers } from "../DataTable";
import { formatDuration, formatNumber, formatSentence } from "../format";

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
      head={["Stage", "Settings", "Ended", ...numbers("Simulated", "Steps", "Wall time")]}
    >
      {stages.map((stage, i) => (
        <tr key={i}>
          <th scope="row">{stage.name}</th>
          <td class="prose">{formatSentence(stage.text) || "–"}</td>
          <td>{(ends[stage.end] ?? stage.end) || "–"}</td>
          {stage.steps > 0 ? (
            <>
              <td class="number">{formatNumber(stage.time)}&nbsp;s</td>
              <td class="number">{formatNumber(stage.steps)}</td>
              <td class="number">{formatDuration(stage.wall)}</td>
            </>
          ) : (
            ["time", "steps", "wall"].map((key) => (
              <td key={key} class="number">
                –
              </td>
            ))
          )}
        </tr>
      ))}
    </DataTable>
  );
}
