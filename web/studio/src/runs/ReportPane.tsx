// SPDX-License-Identifier: MIT
/** The report of a run over the section or beside it, by the page of the reports in a frame; a run in progress renews it. */
import { signal, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { watchTheme } from "../../../src/viewer/theme";
import { size } from "../canvas/camera";
import type { Run, Workspace } from "../engine/http";
import { setting } from "../session";
import { makeFollower } from "./follow";

/** The run whose report is shown. */
export const reported = signal<Pick<Run, "id" | "path"> | null>(null);
export const isBeside = signal(false);

/** Width of the stage from which the section stays beside the report [px]. */
const roomForBoth = 1100;

export function showReport(run: Pick<Run, "id" | "path">): void {
  if (!reported.value) isBeside.value = size.value.width >= roomForBoth;
  reported.value = run;
}

function Frame({ run, workspace }: { run: Pick<Run, "id" | "path">; workspace: Workspace }) {
  const frame = useRef<HTMLIFrameElement>(null);
  const note = useSignal("The report is being loaded …");
  const isActive = useSignal(false);
  useEffect(() => {
    // The frame has an origin of its own, which no other name addresses.
    const post = (message: object) => frame.current?.contentWindow?.postMessage(message, "*");
    const sendTheme = () => post({ theme: document.documentElement.dataset.theme });
    const follower = makeFollower((known) => workspace.readReport(run.id, known), {
      send: (data) => post({ data }),
      tell: (text, active) => {
        note.value = text;
        isActive.value = active;
      },
    });
    const listen = ({ source, data }: MessageEvent) => {
      if (source !== frame.current?.contentWindow || data !== "talus-report") return;
      sendTheme();
      follower.start();
    };
    addEventListener("message", listen);
    const stopTheme = watchTheme(sendTheme);
    frame.current!.src = workspace.reportPage;
    return () => {
      removeEventListener("message", listen);
      stopTheme();
      follower.stop();
    };
  }, [run.id]);
  return (
    <>
      <div class="tools">
        <h2>
          {run.path} <span class="muted">{run.id}</span>
        </h2>
        <span class="muted" role="status">
          {isActive.value && "in progress"}
        </span>
        <button type="button" aria-pressed={isBeside.value} onClick={() => (isBeside.value = !isBeside.value)}>
          Beside the section
        </button>
        <button type="button" aria-label="Close the report" onClick={() => (reported.value = null)}>
          Close
        </button>
      </div>
      {note.value && <p class="muted">{note.value}</p>}
      <iframe ref={frame} title={`Report of ${run.path}, run ${run.id}`} />
    </>
  );
}

export function ReportPane() {
  const workspace = setting.value?.workspace;
  const run = reported.value;
  const pane = useRef<HTMLElement>(null);
  // On a phone the list of runs is below it.
  useEffect(() => pane.current?.scrollIntoView({ block: "nearest" }), [run?.id]);
  if (!workspace || !run) return null;
  return (
    <section ref={pane} class="report-pane" aria-label="Report">
      <Frame key={run.id} run={run} workspace={workspace} />
    </section>
  );
}
