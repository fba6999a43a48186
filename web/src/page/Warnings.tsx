// SPDX-License-Identifier: MIT
/** Warnings, counted, each a sentence: seen at once, never folded away before the third. */
import { listLimits } from "../slices/sliceData";
import { report } from "../state";
import { formatCount, formatSentence } from "./format";

function WarningSign() {
  return (
    <svg class="sign" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
      <path d="M8 1.5 15 14H1z" fill="none" stroke="currentColor" stroke-width="1.5" stroke-linejoin="round" />
      <path d="M8 6v4M8 11.4v1" stroke="currentColor" stroke-width="1.6" />
    </svg>
  );
}

export function WarningList({ warnings }: { warnings: string[] }) {
  return (
    <ol class="warning-list">
      {warnings.map((warning, i) => (
        <li key={i}>{formatSentence(warning)}</li>
      ))}
    </ol>
  );
}

/** Link beside the answer, wherever the warnings themselves are. */
export function WarningLink() {
  const { warnings } = report.value;
  if (warnings.length === 0) return null;
  return (
    <a class="warning-link no-print" href="#warnings">
      <WarningSign /> {formatCount(warnings.length, "warning")}
    </a>
  );
}

export function Warnings() {
  const { warnings, result } = report.value;
  const limits = listLimits();
  if (warnings.length === 0 && limits.length > 0) {
    return (
      <div class="warnings">
        <h3>
          <WarningSign /> {formatCount(limits.length, "limit of the search", "limits of the search")}
        </h3>
        <WarningList warnings={limits} />
      </div>
    );
  }
  if (warnings.length === 0) {
    return (
      <p class="no-warnings">
        <svg class="sign" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
          <path d="m2.5 8.5 3.5 3.5 7.5-8" fill="none" stroke="currentColor" stroke-width="1.8" />
        </svg>
        {result.status === "finished" ? "No warnings." : "No warnings so far."}
      </p>
    );
  }
  const rest = warnings.slice(3);
  return (
    <div class="warnings" id="warnings">
      <h3>
        <WarningSign /> {formatCount(warnings.length, "warning")}
      </h3>
      <WarningList warnings={warnings.slice(0, 3)} />
      {rest.length > 0 && (
        <details class="no-print">
          <summary>{formatCount(rest.length, "more warning")}</summary>
          <WarningList warnings={rest} />
        </details>
      )}
    </div>
  );
}
