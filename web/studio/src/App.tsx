// SPDX-License-Identifier: MIT
/** The page: bar, tools, canvas with the factor, panels beside it, messages and coordinates below. */
import { useEffect } from "preact/hooks";

import { Canvas } from "./canvas/Canvas";
import { watchSelection } from "./canvas/drawing";
import { Bar } from "./panels/Bar";
import { FactorBox } from "./panels/FactorBox";
import { Messages } from "./panels/Messages";
import { Palette } from "./panels/Palette";
import { Side } from "./panels/Side";
import { StatusBar } from "./panels/StatusBar";
import { isChanged, openLocal, save } from "./session";
import { notice, redo, undo, undoNames } from "./state";

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

/** A case file that is dropped on the page is opened, if nothing would be lost. */
async function dropFile(event: DragEvent): Promise<void> {
  const found = event.dataTransfer?.files[0];
  if (!found) return;
  event.preventDefault();
  if (!found.name.endsWith(".toml")) {
    notice.value = { text: `“${found.name}” is no case file (.toml). Drawings and tables are read by talus import.`, bad: true };
  } else if (isChanged() && undoNames.value.length) {
    notice.value = { text: "Save or undo the changes before another case is opened.", bad: true };
  } else openLocal(found.name, await found.text());
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
  return (
    <div class="studio" onDragOver={(e) => e.preventDefault()} onDrop={(e) => void dropFile(e)}>
      <Bar />
      <main class="workbench">
        <h1 class="unseen">Talus studio</h1>
        <Palette />
        <section class="stage" aria-label="Section">
          <Canvas />
          <FactorBox />
        </section>
        <Side />
        <div class="below">
          <Messages />
          <StatusBar />
        </div>
      </main>
    </div>
  );
}
