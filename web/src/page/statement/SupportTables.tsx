// SPDX-License-Identifier: MIT
/** Boundary conditions, loads, and the monitored places. */
import { report } from "../../state";
import { selectsMethod } from "../selected";
import { DataTable } from "../DataTable";
import { formatPlace, formatSentence } from "../format";

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
        <DataTable caption="Boundary conditions" head={["Where", "Condition", "Meaning"]}>
          {boundaries.map((boundary, i) => (
            <tr key={i}>
              <th scope="row">{boundary.on}</th>
              <td>{boundary.fix}</td>
              <td class="prose">{formatSentence(boundary.text)}</td>
            </tr>
          ))}
        </DataTable>
      )}
      {loads.length === 0 ? (
        <p>The results name no loads.</p>
      ) : (
        <DataTable caption="Loads" head={["Load", "Description"]}>
          {loads.map((load, i) => (
            <tr key={i}>
              <th scope="row">{load.name}</th>
              <td class="prose">{formatSentence(load.text)}</td>
            </tr>
          ))}
        </DataTable>
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
