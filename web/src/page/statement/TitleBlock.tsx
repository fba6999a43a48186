// SPDX-License-Identifier: MIT
/** The title block of the report, as on a drawing, with lines to sign on. */
import { report } from "../../state";
import { formatDate } from "../format";

export function TitleBlock() {
  const { title, result } = report.value;
  const { project, provenance } = result;
  const cells: [string, string][] = [
    ["Title", title],
    ["Project", project.project],
    ["Client", project.client],
    ["Author", project.author],
    ["Checked by", project.checked_by],
    ["Revision", project.revision],
    ["Calculated", provenance.started && formatDate(provenance.started)],
    ["Program", provenance.version && `Talus ${provenance.version}, commit ${provenance.commit || "unknown"}`],
    ["Case file", provenance.case_file],
    ["Input hash", provenance.input_hash],
  ];
  return (
    <div class="title-block">
      <dl>
        {cells.map(([name, value]) => (
          <div key={name} class={name === "Title" ? "wide" : undefined}>
            <dt>{name}</dt>
            <dd>{value || <span class="muted">not given</span>}</dd>
          </div>
        ))}
      </dl>
      {project.notes && <p class="notes">{project.notes}</p>}
      <div class="signatures print-only">
        {["Author", "Checked"].map((who) => (
          <p key={who}>
            <span>{who}: name, signature</span>
            <span>Date</span>
          </p>
        ))}
      </div>
    </div>
  );
}
