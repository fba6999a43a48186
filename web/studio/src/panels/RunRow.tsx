// SPDX-License-Identifier: MIT
/** One run: its progress, curves and points as they are computed, stop and resume, results on the section, exports. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { formatFactor } from "../../../src/page/format";
import type { Run, RunProgress, RunResults, Workspace } from "../engine/http";
import { writeCsv } from "../output/csv";
import { downloadBlob, downloadText } from "../output/download";
import { addMotion, addValue, emptyRun, findSurface, listCurves, listFindings, type LiveRun } from "../runs/liveRun";
import { Plot } from "../runs/Plot";
import { reported, showReport } from "../runs/ReportPane";
import { shown, showResults, showValue } from "../runs/shown";
import * as state from "../state";

const sentence = (error: unknown) => (error instanceof Error ? error.message : String(error));

interface Props {
  run: Run;
  workspace: Workspace;
  refresh: () => void;
  chosen: boolean;
  choose: (on: boolean) => void;
}

function Findings({ live }: { live: LiveRun }) {
  const findings = listFindings(live.values);
  const curves = listCurves(live);
  return (
    <>
      {findings.length > 0 && (
        <dl class="findings">
          {findings.map(({ name, text }) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{text}</dd>
            </div>
          ))}
        </dl>
      )}
      {curves.map((curve) => (
        <Plot key={curve.title} curve={curve} />
      ))}
    </>
  );
}

/** What a finished run offers. */
function Results({ run, workspace }: { run: Run; workspace: Workspace }) {
  const results = useSignal<RunResults | null>(null);
  const read = async (apply: (found: RunResults) => void) => {
    try {
      results.value ??= await workspace.readRun(run.id);
      apply(results.value);
    } catch (error) {
      state.notice.value = { text: sentence(error), bad: true };
    }
  };
  const download = async (format: "dxf" | "xlsx") => {
    try {
      downloadBlob(`run-${run.id}.${format}`, await workspace.exportRun(run.id, format));
    } catch (error) {
      state.notice.value = { text: sentence(error), bad: true };
    }
  };
  const isShown = shown.value?.id === run.id;
  return (
    <>
      {!run.is_study && (
        <>
          <button type="button" aria-pressed={isShown} onClick={() => (isShown ? (shown.value = null) : void read((found) => showResults(run.id, found)))}>
            On the section
          </button>
          <button type="button" onClick={() => void read((found) => downloadText(`run-${run.id}.csv`, writeCsv(found), "text/csv"))}>
            CSV
          </button>
          <button type="button" onClick={() => void download("dxf")}>
            DXF
          </button>
        </>
      )}
      <button type="button" onClick={() => void download("xlsx")}>
        XLSX
      </button>
    </>
  );
}

export function RunRow({ run, workspace, refresh, chosen, choose }: Props) {
  const progress = useSignal<RunProgress>({});
  const live = useSignal<LiveRun>(emptyRun);
  const open = useSignal(run.state === "running" || run.state === "waiting");
  const isActive = run.state === "running" || run.state === "waiting";
  useEffect(() => {
    if (!isActive && !open.value) return;
    live.value = emptyRun;
    return workspace.watchRun(run.id, (event) => {
      if (event.kind === "value") {
        live.value = addValue(live.value, event.data);
        const found = findSurface(live.value.values);
        if (isActive && found) showValue(run.id, found, live.value.frame);
        return;
      }
      if (event.kind === "frame") {
        live.value = { ...live.value, frame: event.data };
        if (isActive) showValue(run.id, findSurface(live.value.values), event.data);
        return;
      }
      progress.value = { ...progress.value, ...event.data };
      if (event.data.state === "running" && run.state === "waiting") refresh();
      const { stage, time, values } = event.data;
      if (stage && time !== undefined && values?.displacement !== undefined && values.factor === undefined)
        live.value = addMotion(live.value, stage, time, values.displacement);
      if (event.kind !== "done" || !isActive) return;
      if (shown.value?.id === run.id) shown.value = null;
      refresh();
    });
  }, [run.id, isActive, open.value]);
  const stored = typeof run.progress === "number" ? { fraction: run.progress } : (run.progress ?? {});
  const { fraction, line } = { ...stored, ...progress.value };
  const message = (isActive && line) || run.message || "";
  const act = (what: Promise<void>) =>
    void what.then(refresh).catch((error) => (state.notice.value = { text: sentence(error), bad: true }));
  const isReported = reported.value?.id === run.id;
  const name = `${run.path}, run ${run.id}`;
  return (
    <li class={`run ${run.state}`}>
      <div class="run-head">
        {run.state === "done" && !run.is_study && (
          <input type="checkbox" checked={chosen} aria-label={`Compare ${name}`} onChange={(e) => choose(e.currentTarget.checked)} />
        )}
        <span>
          <b>{run.path}</b> <span class="muted">{run.id}</span>
          {run.is_study && <span class="muted"> study</span>} <span class="muted">{run.is_stopping && isActive ? "stopping" : run.state}</span>
          {typeof run.factor === "number" && <span> · F = {formatFactor(run.factor)}</span>}
        </span>
      </div>
      {isActive && <progress max="1" value={fraction ?? undefined} aria-label={`Progress of ${name}`} />}
      {message && <p class="muted">{message}</p>}
      {open.value && <Findings live={live.value} />}
      <p class="tools">
        {isActive && (
          <button type="button" onClick={() => act(workspace.stopRun(run.id))}>
            {run.is_stopping ? "Stop at once" : "Stop"}
          </button>
        )}
        {(run.state === "stopped" || run.state === "failed") && (
          <button type="button" onClick={() => act(workspace.resumeRun(run.id))}>
            Resume
          </button>
        )}
        {run.state !== "waiting" && (
          <button type="button" aria-expanded={open.value} onClick={() => (open.value = !open.value)}>
            Course
          </button>
        )}
        <button type="button" aria-pressed={isReported} onClick={() => (isReported ? (reported.value = null) : showReport(run))}>
          Read
        </button>
        {run.state === "done" && (
          <a href={workspace.reportAddress(run.id)} target="_blank" rel="noopener">
            Report
          </a>
        )}
        {run.state === "done" && <Results run={run} workspace={workspace} />}
      </p>
    </li>
  );
}
