// SPDX-License-Identifier: MIT
/** The bar at the top: file, undo and redo with their names, save, colours; below it what needs an answer. */
import { useSignal } from "@preact/signals";

import { ThemeButton } from "../../../src/page/ThemeButton";
import { accepted, takeFiles } from "../imports/imports";
import * as session from "../session";
import { conflict, engineFault, file, files, openFile, openLocal, recovered, save, savedText, setting, settle } from "../session";
import * as state from "../state";
import { ExportMenu } from "./ExportMenu";

const icons = {
  undo: "M6 3L2.5 6.5 6 10M3 6.500h6.500a4 4 0 010 8H7",
  redo: "M10 3l3.500 3.500L10 10M13 6.500H6.500a4 4 0 000 8H9",
};

function StepButton({ kind }: { kind: "undo" | "redo" }) {
  const names = kind === "undo" ? state.undoNames.value : state.redoNames.value;
  const word = kind === "undo" ? "Undo" : "Redo";
  const label = names[0] ? `${word}: ${names[0]}` : word;
  return (
    <button type="button" disabled={!names.length} aria-label={label} title={label} onClick={kind === "undo" ? state.undo : state.redo}>
      <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
        <path d={icons[kind]} fill="none" stroke="currentColor" stroke-width="1.5" />
      </svg>
    </button>
  );
}

/** Discards changes only after a second press. */
function useGuard(): { asked: string; guard: (what: string, act: () => void) => void } {
  const asked = useSignal("");
  return {
    asked: asked.value,
    guard(what, act) {
      if (state.text.value !== savedText.value && state.undoNames.value.length && asked.value !== what) {
        asked.value = what;
        return;
      }
      if (asked.value) session.forgetText();
      asked.value = "";
      act();
    },
  };
}

function FileMenu() {
  const isOpen = useSignal(false);
  const { asked, guard } = useGuard();
  const workspace = setting.value?.workspace;
  const close = () => (isOpen.value = false);
  const startNew = () => {
    void session.showNewCase();
    close();
  };
  const read = async (chosen: File | undefined) => {
    if (!chosen) return;
    openLocal(chosen.name, await chosen.text());
    close();
  };
  const saveAs = () => {
    const name = prompt("Save as (path below the folder of the program)", file.value?.path ?? "slope.toml");
    if (name) void save(name.endsWith(".toml") ? name : `${name}.toml`).then(close);
  };
  const item = (what: string, act: () => void) => (
    <li key={what}>
      <button type="button" onClick={() => guard(what, act)}>
        {asked === what ? `${what}: discard the changes?` : what}
      </button>
    </li>
  );
  return (
    <details class="menu" open={isOpen.value} onToggle={(e) => (isOpen.value = e.currentTarget.open)}>
      <summary>File</summary>
      <ul>
        {item("New case", startNew)}
        {files.value.map(({ path }) => item(path, () => void openFile(path).then(close)))}
        {item("Open from this computer …", () => document.getElementById("case-file")?.click())}
        <li>
          <button type="button" onClick={() => document.getElementById("import-files")?.click()}>
            Import DXF, CSV, AGS, GeoStudio …
          </button>
        </li>
        {workspace && (
          <li>
            <button type="button" onClick={saveAs}>
              Save as …
            </button>
          </li>
        )}
      </ul>
      <input
        id="case-file"
        type="file"
        accept=".toml"
        class="unseen"
        tabIndex={-1}
        aria-label="Case file"
        onChange={(e) => void read(e.currentTarget.files?.[0])}
      />
      <input
        id="import-files"
        type="file"
        multiple
        accept={accepted}
        class="unseen"
        tabIndex={-1}
        aria-label="Files to import"
        onChange={(e) => {
          const chosen = [...(e.currentTarget.files ?? [])];
          e.currentTarget.value = "";
          close();
          void takeFiles(chosen);
        }}
      />
    </details>
  );
}

function Questions() {
  if (conflict.value)
    return (
      <p class="question" role="alert">
        {conflict.value.path} holds another text than the one that was opened. Nothing was overwritten.
        <button type="button" onClick={() => void settle("both")}>
          Merge both (can be undone)
        </button>
        <button type="button" onClick={() => void settle("theirs")}>
          Open the other text (can be undone)
        </button>
        <button type="button" onClick={() => void settle("mine")}>
          Overwrite it with mine
        </button>
      </p>
    );
  const [entry] = recovered.value;
  if (entry) {
    const isOlder = file.value !== null && entry.revision !== file.value.revision;
    const when = new Date(entry.time * 1000).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });
    return (
      <p class="question" role="alert">
        {file.value ? `There are changes of ${file.value.path} that were not saved` : "There is a case that was never saved"}
        {entry.time > 0 && ` (${when})`}.{isOlder && " The file has changed since then; both can be merged."}
        <button type="button" onClick={session.recoverText}>
          Recover them
        </button>
        <button type="button" onClick={session.discardRecovered}>
          Discard them
        </button>
      </p>
    );
  }
  return engineFault.value ? (
    <p class="question" role="alert">
      {engineFault.value}
    </p>
  ) : null;
}

export function Bar() {
  const changed = state.text.value !== savedText.value;
  const workspace = setting.value?.workspace;
  const name = file.value?.path ?? "New case";
  const canSave = changed && (!workspace || file.value !== null);
  return (
    <>
      <header class="top-bar studio-bar">
        <span class="brand">
          <svg viewBox="0 0 16 16" width="18" height="18" aria-hidden="true">
            <path d="M1 3h5l5 8h4v3H1z" fill="currentColor" />
          </svg>
          <span>Talus studio</span>
        </span>
        <FileMenu />
        <ExportMenu />
        <span class="file-name" title={name}>
          {name}
          {changed && <span class="changed"> · changed</span>}
        </span>
        <div class="tools">
          <StepButton kind="undo" />
          <StepButton kind="redo" />
          <button type="button" disabled={!canSave} onClick={() => void save()}>
            {workspace ? "Save" : "Download"}
          </button>
          <ThemeButton />
        </div>
      </header>
      <Questions />
    </>
  );
}
