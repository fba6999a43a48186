// SPDX-License-Identifier: MIT
/** The first line of the page: what was computed, for whom, when, by which version, and whether it finished. */
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
