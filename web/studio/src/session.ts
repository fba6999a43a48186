// SPDX-License-Identifier: MIT
/** The engine at work: checks and quick searches behind every change, files with revisions, the journal of typing. */
import { batch, effect, signal, untracked } from "@preact/signals";

import type { JsonSchema, Message } from "./engine/engine";
import type { FileText, Workspace } from "./engine/http";
import { makeLatest } from "./engine/latest";
import type { Setting } from "./engine/select";
import { mergeTexts } from "./document/merge";
import * as state from "./state";

export const setting = signal<Setting | null>(null);
export const schema = signal<JsonSchema | null>(null);
export const files = signal<{ path: string; revision: string }[]>([]);
/** The open file; null for a text that was never saved. */
export const file = signal<{ path: string; revision: string } | null>(null);
export const savedText = signal("");
/** The text of the file where it has changed meanwhile. */
export const conflict = signal<(FileText & { path: string }) | null>(null);
/** A journal that is newer than the file. */
export const recovered = signal<string | null>(null);
export const engineFault = signal("");
/** Factors by all methods of the case, from the last calculation that was asked for. */
export const liveMethod = signal("bishop");
export const liveCircles = 1000;
/** Between the last change and the checks that need meshes [ms]. */
const restBeforeCheck = 1200;
/** Between checks during a drag [ms]. */
const checkInterval = 300;

const sentence = (error: unknown) => (error instanceof Error ? error.message : String(error));

function startChecks({ engine }: Setting): void {
  const check = makeLatest(
    (text: string) => engine.check(text),
    (answer) => {
      engineFault.value = "";
      state.textMessages.value = answer.messages;
      state.section.value = answer.section;
      state.isReady.value = answer.ready ?? !answer.messages.some(({ severity }) => severity === "error");
    },
    (error) => (engineFault.value = sentence(error)),
  );
  let last = 0;
  effect(() => {
    const text = state.text.value;
    // During a drag the search comes first. Regions that the engine builds from layers are needed for every place.
    const waits = state.live.value !== null && untracked(() => state.chains.value.some(({ kind }) => kind === "region"));
    if (waits && performance.now() - last < checkInterval) return;
    last = performance.now();
    check.ask(text);
  });
}

/** Messages of the methods, which need meshes: asked for once the text has rested and has no other error. */
function startMethodChecks({ engine }: Setting): void {
  if (!engine.checkMethods) return;
  const check = makeLatest(
    (text: string) => engine.checkMethods!(text),
    (answer, text) => {
      if (text === state.text.value) state.methodMessages.value = { text, messages: answer };
    },
    (error, text) => {
      const note: Message = { severity: "note", key: "", text: `Meshes and methods were not checked: ${sentence(error)}`, span: null };
      state.methodMessages.value = { text, messages: [note] };
    },
  );
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const text = state.text.value;
    clearTimeout(timer);
    if (state.isReady.value) timer = setTimeout(() => check.ask(text), restBeforeCheck);
  });
}

function startSearches({ engine }: Setting): void {
  const solve = makeLatest(
    async ({ text, method }: { text: string; method: string }) => {
      const from = performance.now();
      const answer = await engine.solve(text, { methods: [method], circles: liveCircles });
      state.solveTime.value = performance.now() - from;
      return answer;
    },
    (answer, { text }) => {
      state.solved.value = answer;
      state.solveFault.value = "";
      state.isSolving.value = text !== state.text.value;
    },
    (error, { text }) => {
      state.solveFault.value = sentence(error);
      state.isSolving.value = text !== state.text.value;
      if (!state.isSolving.value) state.solved.value = null;
    },
  );
  effect(() => {
    const [text, method] = [state.text.value, liveMethod.value];
    if (untracked(() => state.chains.value.length === 0)) {
      state.solved.value = null;
      return;
    }
    state.isSolving.value = true;
    solve.ask({ text, method });
  });
}

/** Each second of typing goes into the journal of the file. */
function startJournal(workspace: Workspace): void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  effect(() => {
    const now = state.text.value;
    if (!file.value || now === savedText.value || timer) return;
    timer = setTimeout(() => {
      timer = null;
      const open = file.value;
      const text = state.text.value;
      if (open && text !== savedText.value)
        workspace.writeJournal(open.path, { text, revision: open.revision }).catch((error) => (engineFault.value = sentence(error)));
    }, 1000);
  });
}

/** Called once the engine is selected: parts of the page that keep notes of their own. */
const beginnings: (() => void)[] = [];
export const whenStarted = (begin: () => void): void => void beginnings.push(begin);

export async function start(found: Setting): Promise<void> {
  setting.value = found;
  startChecks(found);
  startMethodChecks(found);
  startSearches(found);
  const { workspace } = found;
  if (workspace) {
    effect(() => {
      workspace.path = file.value?.path ?? "";
    });
    startJournal(workspace);
  }
  for (const begin of beginnings) begin();
  try {
    schema.value = await found.engine.schema();
    if (found.workspace) {
      const listed = await found.workspace.listFiles();
      files.value = listed.files;
      const asked = new URLSearchParams(location.search).get("file") || listed.open;
      const first = files.value.find(({ path }) => path === asked) ?? (files.value.length === 1 ? files.value[0] : undefined);
      if (first) await openFile(first.path);
    }
  } catch (error) {
    engineFault.value = sentence(error);
  }
}

export const isChanged = (): boolean => state.text.value !== savedText.value;

export async function openFile(path: string): Promise<void> {
  const workspace = setting.value?.workspace;
  if (!workspace) return;
  try {
    const found = await workspace.readFile(path);
    batch(() => {
      file.value = { path, revision: found.revision };
      savedText.value = found.text;
      workspace.path = path;
      state.openText(found.text);
    });
    conflict.value = null;
    const journal = await workspace.readJournal(path);
    recovered.value = journal && journal.text !== found.text ? journal.text : null;
  } catch (error) {
    state.notice.value = { text: sentence(error), bad: true };
  }
}

/** A file from the disk of the user, where no server is. */
export function openLocal(name: string, text: string): void {
  state.openText(text);
  file.value = { path: name, revision: "" };
  savedText.value = text;
}

function download(name: string, text: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "application/toml" }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

/** Saves with the revision that was read; a file that has changed meanwhile is not overwritten. */
export async function save(path = file.value?.path ?? ""): Promise<void> {
  const workspace = setting.value?.workspace;
  const text = state.text.value;
  if (!workspace) {
    download(path || "case.toml", text);
    savedText.value = text;
    return;
  }
  if (!path) return;
  try {
    const revision = file.value?.path === path ? file.value.revision : "";
    const result = await workspace.saveFile(path, { text, revision });
    if (!result.saved) {
      conflict.value = { ...result.theirs, path };
      return;
    }
    file.value = { path, revision: result.revision };
    savedText.value = text;
    state.notice.value = { text: `Saved ${path}`, bad: false };
    files.value = (await workspace.listFiles()).files;
  } catch (error) {
    state.notice.value = { text: sentence(error), bad: true };
  }
}

/** Both changes in one text, as a step that can be undone; the next save writes it. */
function mergeConflict(theirs: FileText): void {
  const { text, conflicts } = mergeTexts(state.text.value, savedText.value, theirs.text);
  savedText.value = theirs.text;
  state.change("Merge with the text of the file", text);
  state.notice.value = {
    text: conflicts
      ? `Merged. In ${conflicts} ${conflicts === 1 ? "place" : "places"} both changed the same lines: yours stay, the others are comments below them.`
      : "Merged: both changes are in the text. Save writes it.",
    bad: conflicts > 0,
  };
}

/** Ends a conflict: mine is written over theirs, or theirs is opened or merged as a step that can be undone. */
export async function settle(choice: "mine" | "theirs" | "both"): Promise<void> {
  const theirs = conflict.value;
  if (!theirs) return;
  file.value = { path: theirs.path, revision: theirs.revision };
  conflict.value = null;
  if (choice === "both") return mergeConflict(theirs);
  if (choice === "mine") return save();
  savedText.value = theirs.text;
  state.change("Open the text of the file", theirs.text);
}
