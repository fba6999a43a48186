// SPDX-License-Identifier: MIT
/** Two runs side by side: the keys of their inputs and the results that differ, as the program compares them, and both reports. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import type { Run, RunComparison, Workspace } from "../engine/http";

interface Props {
  workspace: Workspace;
  ids: [string, string];
  runs: Run[];
  close: () => void;
}

const sentence = (error: unknown) => (error instanceof Error ? error.message : String(error));
const show = (value: number | string | null) =>
  value === null ? "–" : typeof value === "string" ? value : Number(value.toPrecision(5)).toString().replace("-", "−");
const showText = (value: string | null) => (value === null ? "–" : value === "" ? "none" : value);

function showPercent(relative: number | null): string {
  if (relative === null) return "–";
  const percent = 100 * relative;
  return `${percent > 0 ? "+" : ""}${percent.toPrecision(3)} %`.replace("-", "−");
}

function Tables({ found, names }: { found: RunComparison; names: [string, string] }) {
  const all = useSignal(false);
  const values = found.values.filter(({ difference }) => all.value || difference !== 0);
  return (
    <>
      {found.warnings.map((text) => (
        <p key={text} class="bad">
          {text}
        </p>
      ))}
      <table class="factors">
        <caption>{found.inputs.length ? "Keys that differ" : "The inputs are equal."}</caption>
        {found.inputs.length > 0 && (
          <>
            <thead>
              <tr>
                <th scope="col">Key</th>
                <th scope="col">{names[0]}</th>
                <th scope="col">{names[1]}</th>
                <th scope="col">Unit</th>
              </tr>
            </thead>
            <tbody>
              {found.inputs.map(({ key, first, second, unit }) => (
                <tr key={key}>
                  <th scope="row">{key}</th>
                  <td>{showText(first)}</td>
                  <td>{showText(second)}</td>
                  <td class="muted">{unit}</td>
                </tr>
              ))}
            </tbody>
          </>
        )}
      </table>
      <table class="factors">
        <caption>
          {values.length ? "Results" : "No result differs."}{" "}
          <label>
            <input type="checkbox" checked={all.value} onChange={(e) => (all.value = e.currentTarget.checked)} /> equal ones too
          </label>
        </caption>
        {values.length > 0 && (
          <>
            <thead>
              <tr>
                <th scope="col">Result</th>
                <th scope="col">{names[0]}</th>
                <th scope="col">{names[1]}</th>
                <th scope="col">Difference</th>
                <th scope="col">Relative</th>
                <th scope="col">Unit</th>
              </tr>
            </thead>
            <tbody>
              {values.map(({ name, title, unit, first, second, difference, relative }) => (
                <tr key={name}>
                  <th scope="row" title={name}>
                    {title}
                  </th>
                  <td class="number">{show(first)}</td>
                  <td class="number">{show(second)}</td>
                  <td class="number">{show(difference)}</td>
                  <td class="number">{showPercent(relative)}</td>
                  <td class="muted">{unit}</td>
                </tr>
              ))}
            </tbody>
          </>
        )}
      </table>
    </>
  );
}

export function ComparisonDialog({ workspace, ids, runs, close }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const found = useSignal<RunComparison | null>(null);
  const fault = useSignal("");
  const reports = useSignal(false);
  useEffect(() => {
    dialog.current!.showModal();
    workspace.compareRuns(...ids).then(
      (answer) => (found.value = answer),
      (error) => (fault.value = sentence(error)),
    );
  }, []);
  const names = ids.map((id) => `${runs.find((run) => run.id === id)?.path ?? ""} ${id}`) as [string, string];
  return (
    <dialog ref={dialog} class="comparison" aria-label="Two runs side by side" onClose={close}>
      <div class="tools">
        <h2>Two runs side by side</h2>
        <button type="button" aria-pressed={reports.value} onClick={() => (reports.value = !reports.value)}>
          Both reports
        </button>
        <button type="button" onClick={() => dialog.current!.close()}>
          Close
        </button>
      </div>
      {fault.value && <p class="bad">{fault.value}</p>}
      <div class="comparison-tables" tabIndex={0} role="group" aria-label="Differences">
        {found.value && <Tables found={found.value} names={names} />}
      </div>
      {reports.value && (
        <div class="comparison-reports">
          {ids.map((id, i) => (
            <iframe key={id} title={`Report of ${names[i]}`} src={workspace.reportAddress(id)} />
          ))}
        </div>
      )}
    </dialog>
  );
}
