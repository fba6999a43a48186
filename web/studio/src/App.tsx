// SPDX-License-Identifier: MIT
/** The page: bar, tools, canvas with the factor, panels beside it, messages and coordinates below. */
import { useEffect } from "preact/hooks";

import { Canvas } from "./canvas/Canvas";
import { watchSelection } from "./canvas/drawing";
import { takeFiles } from "./imports/imports";
import { Bar } from "./panels/Bar";
import { FactorBox } from "./panels/FactorBox";
import { ImportDialog } from "./panels/ImportDialog";
import { Messages } from "./panels/Messages";
import { FurtherTools, Palette } from "./panels/Palette";
import { Side } from "./panels/Side";
import { StatusBar } from "./panels/StatusBar";
import { isBeside, reported, ReportPane } from "./runs/ReportPane";
import { isChanged, save } from "./session";
import { redo, undo } from "./state";

/** Keys of the whole page. Undo covers every kind of edit, so that it also acts in the text. */
function pressPageKey(event: KeyboardEvent): void {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  if (key === "z" && event.shiftKey) redo();
  else if (key === "z") undo();
  else if (key === "y") redo();
  else if (key === "s") void save();
  else return;
  event.preventDefault();
}

/** Files that are dropped on the page: a case is opened, others are imported. */
function dropFiles(event: DragEvent): void {
  const files = [...(event.dataTransfer?.files ?? [])];
  if (!files.length) return;
  event.preventDefault();
  void takeFiles(files);
}

export function App() {
  useEffect(() => {
    watchSelection();
    const warn = (event: BeforeUnloadEvent) => {
      if (isChanged()) event.preventDefault();
    };
    addEventListener("keydown", pressPageKey);
    addEventListener("beforeunload", warn);
    return () => {
      removeEventListener("keydown", pressPageKey);
      removeEventListener("beforeunload", warn);
    };
  }, []);
  const stage = !reported.value ? "stage" : isBeside.value ? "stage beside-report" : "stage under-report";
  return (
    <div class="studio" onDragOver={(e) => e.preventDefault()} onDrop={dropFiles}>
      <Bar />
      <main class="workbench">
        <h1 class="unseen">Talus studio</h1>
        <Palette />
        <section class={stage} aria-label="Section">
          <Canvas />
          <FactorBox />
          <FurtherTools />
          <ReportPane />
        </section>
        <Side />
        <div class="below">
          <Messages />
          <StatusBar />
        </div>
      </main>
      <ImportDialog />
    </div>
  );
}
