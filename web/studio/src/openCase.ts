// SPDX-License-Identifier: MIT
/** The case that is open: its file and revision, the journal of what is not saved, and what another window left in it. */
import { batch, effect, signal } from "@preact/signals";

import { mergeTexts, recoverBase } from "./document/merge";
import { emptyCase } from "./document/operations";
import type { FileText, JournalEntry, Workspace } from "./engine/http";
import * as state from "./state";

/** The open file; null for a text that was never saved. */
export const file = signal<{ path: string; revision: string } | null>(null);
/** Text of the file at its revision; the empty case for a text that was never saved. */
export const savedText = signal(emptyCase);
/** The text of the file where it has changed meanwhile. */
export const conflict = signal<(FileText & { path: string }) | null>(null);
/** Texts of this file, or of cases never saved, that windows left unsaved. The first one is offered. */
export const recovered = signal<JournalEntry[]>([]);

/** Between a change and its entry in the journal [ms]. */
const journalDelay = 1000;

export const isChanged = (): boolean => state.text.value !== savedText.value;
const getPath = () => file.peek()?.path ?? "";
const makeName = () => Array.from(crypto.getRandomValues(new Uint8Array(12)), (byte) => byte.toString(16).padStart(2, "0")).join("");

let workspace: Workspace | null = null;
let report: (error: unknown) => void = () => undefined;
/** Name of the entry of the present text: a new one for every text that is opened, so that no entry replaces another. */
let entryName = makeName();
/** The entry of the present text in the journal, as far as it has one. */
let own: { path: string; entryName: string } | null = null;
let timer: ReturnType<typeof setTimeout> | null = null;
/** Requests to the journal follow one another. */
let queue: Promise<void> = Promise.resolve();

function enqueue(act: (to: Workspace) => Promise<void>): void {
  const to = workspace;
  if (to) queue = queue.then(() => act(to)).catch((error) => report(error));
}

/** Resolves when every entry is stored. */
export const settleJournal = (): Promise<void> => queue;

function stopTimer(): void {
  if (timer) clearTimeout(timer);
  timer = null;
}

/** Removes the entry of the present text: it is saved, undone or discarded. */
export function forgetText(): void {
  stopTimer();
  if (!own) return;
  const { path, entryName: name } = own;
  own = null;
  enqueue((to) => to.removeJournal(path, name));
}

function storeText(): void {
  stopTimer();
  const path = getPath();
  if (own && own.path !== path) forgetText();
  const text = state.text.peek();
  if (text === savedText.peek()) return forgetText();
  const entry = { window: entryName, text, base: savedText.peek(), revision: file.peek()?.revision ?? "" };
  own = { path, entryName };
  enqueue((to) => to.writeJournal(path, entry));
}

/** The next text has an entry of its own; that of an unsaved text stays, and is offered when its file is opened again. */
function startEntry(): void {
  if (timer) storeText();
  entryName = makeName();
  own = null;
}

/** Stores the text a second after it changes. */
export function keepJournal(to: Workspace, reportFault: (error: unknown) => void): () => void {
  workspace = to;
  report = reportFault;
  const stop = effect(() => {
    const isSaved = state.text.value === savedText.value;
    void file.value;
    if (isSaved) forgetText();
    else timer ??= setTimeout(storeText, journalDelay);
  });
  return () => {
    stop();
    stopTimer();
    workspace = null;
    own = null;
  };
}

/** Shows another text: questions about the previous one end. */
export function showCase(text: string, of: { path: string; revision: string } | null, saved = text): void {
  startEntry();
  batch(() => {
    file.value = of;
    savedText.value = saved;
    conflict.value = null;
    recovered.value = [];
    state.openText(text);
  });
}

/** Offers what windows left unsaved in the open file, or of cases never saved. */
export async function offerJournal(): Promise<void> {
  const path = getPath();
  const shown = state.opened.peek();
  if (!workspace) return;
  await queue;
  const entries = await workspace.readJournal(path);
  if (path !== getPath() || shown !== state.opened.peek()) return;
  const isKnown = ({ text }: JournalEntry) => text === savedText.peek();
  for (const { window: name } of entries.filter(isKnown)) enqueue((to) => to.removeJournal(path, name));
  recovered.value = entries.filter((entry) => !isKnown(entry) && entry.window !== entryName);
}

export async function showNewCase(): Promise<void> {
  showCase(emptyCase, null);
  await offerJournal();
}

/**
 * Takes the offered text as a step that can be undone. It keeps the revision that it grew from: where the file has another one
 * now, the merge is offered at once, and the server refuses to overwrite the file.
 */
export function recoverText(): void {
  const [entry, ...rest] = recovered.value;
  if (!entry) return;
  const path = getPath();
  startEntry();
  batch(() => {
    const now = file.value;
    if (now && entry.revision !== now.revision) {
      conflict.value = { path, text: savedText.value, revision: now.revision };
      file.value = { path, revision: entry.revision };
      savedText.value = entry.base || recoverBase(entry.text, savedText.value);
    }
    state.change("Recover unsaved changes", entry.text);
    recovered.value = rest;
  });
  storeText();
  enqueue((to) => to.removeJournal(path, entry.window));
}

/** Removes the offered text from the journal. */
export function discardRecovered(): void {
  const [entry, ...rest] = recovered.value;
  if (!entry) return;
  const path = getPath();
  recovered.value = rest;
  enqueue((to) => to.removeJournal(path, entry.window));
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

/** Ends a conflict without mine being written: theirs is opened or merged as a step that can be undone. */
export function takeTheirs(choice: "theirs" | "both"): void {
  const theirs = conflict.value;
  if (!theirs) return;
  file.value = { path: theirs.path, revision: theirs.revision };
  conflict.value = null;
  if (choice === "both") return mergeConflict(theirs);
  savedText.value = theirs.text;
  state.change("Open the text of the file", theirs.text);
}
