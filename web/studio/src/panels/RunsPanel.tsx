// SPDX-License-Identifier: MIT
/** Runs of the open file: start, progress, stop, resume, report; and LEM by every method of the case at once. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { formatFactor } from "../../../src/page/format";
import { findNode } from "../document/tree";
import type { Message, SolvedSurface } from "../engine/engine";
import type { Run, Workspace } from "../engine/http";
import { ComparisonDialog } from "../runs/Comparison";
import { file, isChanged, save, setting } from "../session";
import * as state from "../state";
import { RunRow } from "./RunRow";
import { Warnings } from "./Warnings";

const sentence = (error: unknown) => (error instanceof Error ? error.message : String(error));

/** LEM with the settings of the case: the numbers of `talus run`. */
function FullSearch() {
  const busy = useSignal(false);
  const found = useSignal<{ surfaces: SolvedSurface[]; messages?: Message[]; text: string } | null>(null);
  const fault = useSignal("");
  const run = async () => {
    busy.value = true;
    fault.value = "";
    const text = state.text.value;
    try {
      const answer = await setting.value!.engine.solve(text, {});
      const { method, title, factor, surface: points, circle } = answer;
      const surfaces = answer.surfaces?.length ? answer.surfaces : [{ method, title, factor, points, circle }];
      found.value = { surfaces, messages: answer.messages, text };
    } catch (error) {
      fault.value = sentence(error);
    }
    busy.value = false;
  };
  const show = (surface: SolvedSurface) => {
    state.solved.value = { ...surface, surface: surface.points, searched: state.solved.value?.searched ?? 0 };
  };
  return (
    <section>
      <h3>Limit equilibrium with the settings of the case</h3>
      <p class="tools">
        <button type="button" disabled={busy.value || state.chains.value.length === 0} onClick={() => void run()}>
          {busy.value ? "Calculating …" : "Calculate"}
        </button>
      </p>
      {fault.value && <p class="bad">{fault.value}</p>}
      {found.value && (
        <table class="factors">
          <caption>{found.value.text === state.text.value ? "Factors of safety" : "Factors of an earlier state of the case"}</caption>
          <tbody>
            {found.value.surfaces.map((surface, i) => (
              <tr key={i}>
                <th scope="row">
                  <button type="button" class="link" onClick={() => show(surface)}>
                    {surface.title ?? surface.method}
                  </button>
                </th>
                <td class="muted">{surface.circle ? "circle" : "polyline"}</td>
                <td class="number">{formatFactor(surface.factor)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
      <Warnings messages={found.value?.messages} />
    </section>
  );
}

function ServerRuns({ workspace }: { workspace: Workspace }) {
  const runs = useSignal<Run[]>([]);
  const chosen = useSignal<string[]>([]);
  const compared = useSignal<[string, string] | null>(null);
  const refresh = () =>
    void workspace
      .listRuns()
      .then((found) => (runs.value = found))
      .catch((error) => (state.notice.value = { text: sentence(error), bad: true }));
  useEffect(refresh, []);
  const start = async (settings: Record<string, unknown>) => {
    try {
      if (isChanged()) await save();
      if (isChanged() || !file.value) return;
      await workspace.startRun(file.value.path, settings);
      refresh();
    } catch (error) {
      state.notice.value = { text: sentence(error), bad: true };
    }
  };
  const choose = (id: string, on: boolean) => {
    const others = chosen.value.filter((other) => other !== id);
    chosen.value = on ? [...others.slice(-1), id] : others;
  };
  const hasStudy = findNode(state.tree.value, ["study"]) !== null;
  const word = isChanged() ? "Save and run" : "Run";
  return (
    <section>
      <h3>Runs by all methods of the case</h3>
      <p class="tools">
        <button type="button" disabled={!file.value} onClick={() => void start({})}>
          {word}
        </button>
        {hasStudy && (
          <button type="button" disabled={!file.value} onClick={() => void start({ study: true })}>
            {word} the study
          </button>
        )}
        <button
          type="button"
          disabled={chosen.value.length !== 2}
          title="Mark two runs to see the differences of their inputs and results"
          onClick={() => {
            const [earlier, later] = chosen.value.toSorted();
            compared.value = [earlier!, later!];
          }}
        >
          Compare two runs
        </button>
      </p>
      {!file.value && <p class="muted">Save the case under a name first (File, Save as).</p>}
      <ul class="runs">
        {runs.value.map((run) => (
          <RunRow
            key={run.id}
            run={run}
            workspace={workspace}
            refresh={refresh}
            chosen={chosen.value.includes(run.id)}
            choose={(on) => choose(run.id, on)}
          />
        ))}
      </ul>
      {compared.value && (
        <ComparisonDialog workspace={workspace} ids={compared.value} runs={runs.value} close={() => (compared.value = null)} />
      )}
    </section>
  );
}

export function RunsPanel() {
  const workspace = setting.value?.workspace;
  return (
    <>
      <h2>Runs</h2>
      <FullSearch />
      {workspace ? (
        <ServerRuns workspace={workspace} />
      ) : (
        <section>
          <h3>Other methods</h3>
          <p class="muted">
            FEM, limit analysis, seepage and MPM need the installed program. Download the case and run <code>talus run {file.value?.path ?? "case.toml"}</code>.
          </p>
        </section>
      )}
    </>
  );
}
