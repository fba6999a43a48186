// SPDX-License-Identifier: MIT
/** Provenance: program, machine and computing times. */
import type { ComponentChildren } from "preact";

import { report } from "../state";
import { CaptionedTable, Facts } from "./DataTable";
import { formatCount, formatDate, formatDuration, formatNumber } from "./format";
import { Part } from "./Part";

/** Seconds beside each other as bars on one axis. */
function Bars({ caption, rows }: { caption: string; rows: { title: string; seconds: number }[] }) {
  const most = Math.max(...rows.map((row) => row.seconds), 1e-12);
  const sum = rows.reduce((total, row) => total + row.seconds, 0);
  return (
    <CaptionedTable caption={caption} class="bars">
      <tbody>
        {rows.map((row) => (
          <tr key={row.title}>
            <th scope="row">{row.title}</th>
            <td class="number">{formatDuration(row.seconds)}</td>
            <td class="number muted">{sum > 0 ? `${formatNumber((100 * row.seconds) / sum, 2)} %` : ""}</td>
            <td class="bar-cell">
              <span class="bar" style={{ width: `${(100 * row.seconds) / most}%` }} />
            </td>
          </tr>
        ))}
      </tbody>
    </CaptionedTable>
  );
}

/** Older folders, and those of killed runs, are incomplete. */
const known = (rows: [string, ComponentChildren][]): [string, ComponentChildren][] =>
  rows.map(([name, value]) => [name, value || "not known"]);

export function ProvenancePart() {
  const { result, folder } = report.value;
  const { provenance } = result;
  const { wall = 0, cpu = 0, parts: timed = [] } = result.timing ?? {};
  const parts = [...timed].sort((a, b) => b.seconds - a.seconds);
  const busy = wall > 0 ? cpu / wall : 0;
  return (
    <Part id="provenance" title="Provenance and time" lead="What is needed to make the same numbers again.">
      <div class="columns">
        <div>
          <h3>Program and machine</h3>
          <Facts
            caption="Program and machine"
            rows={known([
              ["Program", `${provenance.program} ${provenance.version}`.trim()],
              ["Commit", <code>{provenance.commit || "unknown"}</code>],
              [
                "Compiler",
                [...new Set([provenance.compiler, provenance.build_type, provenance.architecture, provenance.level])]
                  .filter(Boolean)
                  .join(", "),
              ],
              ["Lane width", provenance.lane_width > 0 && `${provenance.lane_width} numbers at a time`],
              ["Machine", provenance.machine && `${provenance.machine}, ${formatCount(provenance.threads, "thread")}`],
              ["Device", provenance.device],
              ["Started", provenance.started && formatDate(provenance.started)],
              ["Case file", provenance.case_file && <code>{provenance.case_file}</code>],
              ["Input hash", provenance.input_hash && <code>{provenance.input_hash}</code>],
              ["Results folder", <code>{folder}</code>],
            ])}
          />
        </div>
        <div>
          <h3>Time</h3>
          <Facts
            caption="Time of the whole calculation"
            rows={[
              ["Wall time", wall > 0 ? formatDuration(wall) : "not known"],
              [
                "Processor time",
                cpu > 0 && busy > 0
                  ? `${formatDuration(cpu)}, ${formatNumber(busy, 2)} cores busy on average`
                  : "not known",
              ],
            ]}
          />
          {parts.length > 0 && <Bars caption="By part of the time step, over all threads" rows={parts} />}
        </div>
      </div>
    </Part>
  );
}
