// SPDX-License-Identifier: MIT
/** The outcome of each variant of a study: its status, why it did not finish, its warnings. */
import { shownStudy } from "../charts/study/studyData";
import { DataTable } from "./DataTable";
import { formatCount, formatSentence } from "./format";
import { Part } from "./Part";

export function Variants() {
  const rows = shownStudy.value?.rows ?? [];
  const bad = rows.filter((row) => row.status !== "finished").length;
  const warned = rows.filter((row) => row.warnings.length > 0).length;
  const lead = `${formatCount(rows.length, "variant")}: ${bad === 0 ? "all finished" : `${bad} did not finish`}, ${
    warned === 0 ? "none has warnings" : `${warned} with warnings`
  }.`;
  return (
    <Part id="variants" title="Variants and their warnings" lead={lead}>
      <DataTable
        caption="Status and warnings of each variant"
        quiet
        rows={rows}
        columns={[
          ["Variant", (row) => row.name, "name"],
          [
            "Status",
            (row) => (
              <span class={row.status === "finished" ? undefined : "bad"}>
                {row.status}
                {row.reason && <span class="note">: {row.reason}</span>}
              </span>
            ),
          ],
          [
            "Warnings",
            (row) =>
              row.warnings.length === 0 ? (
                <span class="muted">none</span>
              ) : (
                <ul class="plain">
                  {row.warnings.map((warning, i) => (
                    <li key={i}>{formatSentence(warning)}</li>
                  ))}
                </ul>
              ),
            "prose",
          ],
        ]}
      />
    </Part>
  );
}
