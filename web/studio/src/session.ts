// SPDX-License-Identifier: MIT
/** The engine at work: checks and quick searches behind every change, files with revisions, the journal of typing. */
import { effect, signal, untracked } from "@preact/signals";

import type { JsonSchema, Message } from "./engine/engine";
import { makeLatest } from "./engine/latest";
import type { Setting } from "./engine/select";
import { conflict, file, keepJournal, offerJournal, recovered, savedText, showCase, takeTheirs } from "./openCase";
import * as state from "./state";

export { conflict, discardRecovered, file, forgetText, isChanged, recovered, recoverText, savedText, showNewCase } from "./openCase";

export const setting = signal<Setting | null>(null);
export const schema = signal<JsonSchema | null>(null);
export const files = signal<{ path: string; revision: string }[]>([]);
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
    keepJournal(workspace, (error) => (engineFault.value = sentence(error)));
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
      else await offerJournal();
    }
  } catch (error) {
    engineFault.value = sentence(error);
  }
}

export async function openFile(path: string): Promise<void> {
  const workspace = setting.value?.workspace;
  if (!workspace) return;
  try {
    const found = await workspace.readFile(path);
    workspace.path = path;
    showCase(found.text, { path, revision: found.revision });
    await offerJournal();
  } catch (error) {
    state.notice.value = { text: sentence(error), bad: true };
  }
}

/** A file from the disk of the user, where no server is. */
export function openLocal(name: string, text: string): void {
  showCase(text, { path: name, revision: "" });
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
    // Texts recovered from another file are not offered for this one.
    if (file.value?.path !== path) recovered.value = [];
    file.value = { path, revision: result.revision };
    savedText.value = text;
    state.notice.value = { text: `Saved ${path}`, bad: false };
    files.value = (await workspace.listFiles()).files;
  } catch (error) {
    state.notice.value = { text: sentence(error), bad: true };
  }
}

/** Ends a conflict: mine is written over theirs, or theirs is opened or merged as a step that can be undone. */
export async function settle(choice: "mine" | "theirs" | "both"): Promise<void> {
  const theirs = conflict.value;
  if (!theirs) return;
  if (choice !== "mine") return takeTheirs(choice);
  file.value = { path: theirs.path, revision: theirs.revision };
  conflict.value = null;
  return save();
}
