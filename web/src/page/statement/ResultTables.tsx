// SPDX-License-Identifier: MIT
/** Factors of safety with their spread, and every other number of the results. */
import { report } from "../../state";
import { DataTable, numbers } from "../DataTable";
import { describeDrainage, getMethodTitle } from "../FactorTable";
import { formatFactor, formatNumber, formatQuantity, formatSentence } from "../format";
import type { Factor } from "../../contract";

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

function FactorRows({ factors }: { factors: Factor[] }) {
  const isWet = factors.some((factor) => factor.water);
  return (
    <DataTable
      caption="Factors of safety, with the bracket of each search"
      head={["Method", "Criterion", isWet && "Pore water", ...numbers("F", "from", "to"), "Found how"]}
    >
      {factors.map((factor) => (
        <tr key={`${factor.method} ${factor.name} ${factor.title}`} class={factor.main ? "main" : undefined}>
          <td>{getMethodTitle(factor.method)}</td>
          <th scope="row">
            {factor.title}
            {factor.main && <span class="note"> (the answer)</span>}
          </th>
          {isWet && <td>{factor.water ? describeDrainage(factor.water) : "–"}</td>}
          <td class="number">{formatFactor(factor.value, "none")}</td>
          <td class="number">{formatFactor(factor.lower)}</td>
          <td class="number">{formatFactor(factor.upper)}</td>
          <td class="prose">{formatSentence(factor.note) || "–"}</td>
        </tr>
      ))}
    </DataTable>
  );
}

export function ResultTables() {
  const { factors, results, sentences } = report.value.answer;
  return (
    <>
      {sentences.length > 0 && <p>{sentences.map(formatSentence).join(" ")}</p>}
      {factors.length > 0 && <FactorRows factors={factors} />}
      {factors.length > 1 && <p class="note">{describeSpread(factors)}</p>}
      {results.length > 0 && (
        <DataTable
          caption="All results, by the names that comparisons use"
          head={["Result", ...numbers("Value"), "Name"]}
        >
          {results.map((result) => (
            <tr key={result.name}>
              <th scope="row">{result.title}</th>
              <td class="number">{formatQuantity(result.value, result.unit, 4, true)}</td>
              <td>
                <code>{result.name}</code>
              </td>
            </tr>
          ))}
        </DataTable>
      )}
    </>
  );
}
