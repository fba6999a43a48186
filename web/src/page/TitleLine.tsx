// SPDX-License-Identifier: MIT
/** The first line of the page: what was computed, for whom, when, by which version, and whether it finished; on paper a title block with lines to sign on. */
import { report } from "../state";
import { formatDate, formatSentence } from "./format";

/** Text of a status for the reader of the results. */
const statusTexts: { [status: string]: string } = {
  interrupted: "This calculation was interrupted: what follows is what had been computed by then.",
  unstable: "This calculation became unstable and was stopped: results up to the last good state only.",
  failed: "This calculation failed: what follows is incomplete.",
  unfinished: "This calculation has not finished: what follows is what had been computed so far.",
};

export function TitleLine() {
  const { title, kind, result } = report.value;
  const { project, provenance, status, error } = result;
  const facts: [string, string][] = [
    ["Project", project.project],
    ["Revision", project.revision],
    ["Date", provenance.started && formatDate(provenance.started)],
    ["Talus", provenance.version],
    ["Input", provenance.input_hash.slice(0, 8)],
  ];
  return (
    <div class="title-line">
      {/* A title without spaces must not widen the page. */}
      <h1 style={{ overflowWrap: "anywhere", minWidth: 0 }}>
        {title}
        {kind === "study" && <span class="kind"> – parameter study</span>}
        {kind === "tests" && <span class="kind"> – element tests</span>}
      </h1>
      <dl class="facts no-print">
        {facts
          .filter(([, value]) => value)
          .map(([name, value]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value}</dd>
            </div>
          ))}
      </dl>
      {status !== "finished" && (
        <div class="not-finished" role="alert">
          <strong>{statusTexts[status] ?? `This calculation ended as “${status}”.`}</strong>
          {error && <p>{formatSentence(error)}</p>}
        </div>
      )}
    </div>
  );
}

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
