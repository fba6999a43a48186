// SPDX-License-Identifier: MIT
/** Texts that are not saved, and files that change meanwhile: nothing is overwritten without a question, in any number of windows. */
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { emptyCase } from "../src/document/operations";
import type { FileText, JournalEntry, Workspace } from "../src/engine/http";
import type { Setting } from "../src/engine/select";

const base = 'title = "Slope"\n\n[materials.clay]\ncohesion = 10\nunit_weight = 18\n\n[lem]\nmethods = ["bishop"]\n';
const first = base.replace("cohesion = 10", "cohesion = 11");
const second = base.replace("bishop", "spencer");

/** Files and journal with the rules of `talus studio`: a file is written at the revision that was read, else answered by 409. */
class Disk {
  texts = new Map<string, string>([["a.toml", base], ["b.toml", base]]);
  journal = new Map<string, JournalEntry>();
  private clock = 0;
  readonly revise = (text: string) => (text === "" ? "" : `r${text.length}:${text}`);
  readonly entries = (path: string) => [...this.journal.entries()].filter(([key]) => key.startsWith(`${path}|`)).map(([, entry]) => entry).toSorted((a, b) => b.time - a.time);

  readonly workspace = {
    path: "",
    listFiles: async () => ({ files: [...this.texts].map(([path, text]) => ({ path, revision: this.revise(text) })) }),
    readFile: async (path: string): Promise<FileText> => ({ text: this.texts.get(path)!, revision: this.revise(this.texts.get(path)!) }),
    saveFile: async (path: string, given: FileText) => {
      const now = this.texts.get(path) ?? "";
      if (given.revision !== this.revise(now)) return { saved: false as const, theirs: { text: now, revision: this.revise(now) } };
      this.texts.set(path, given.text);
      return { saved: true as const, revision: this.revise(given.text) };
    },
    readJournal: async (path: string) => this.entries(path),
    writeJournal: async (path: string, entry: Omit<JournalEntry, "time">) => void this.journal.set(`${path}|${entry.window}`, { ...entry, time: ++this.clock }),
    removeJournal: async (path: string, name: string) => void this.journal.delete(`${path}|${name}`),
  } as unknown as Workspace;
}

/** A window: the modules of the page, loaded anew. */
async function openWindow(disk: Disk) {
  vi.resetModules();
  const session = await import("../src/session");
  const openCase = await import("../src/openCase");
  const state = await import("../src/state");
  session.setting.value = { engine: {}, workspace: disk.workspace } as Setting;
  const close = openCase.keepJournal(disk.workspace, (error) => {
    throw error;
  });
  const rest = async () => {
    await vi.advanceTimersByTimeAsync(1500);
    await openCase.settleJournal();
  };
  const type = async (text: string) => {
    state.change("Type", text);
    await rest();
  };
  return { ...session, ...openCase, state, close, rest, type };
}

let disk: Disk;
beforeEach(() => {
  vi.useFakeTimers();
  disk = new Disk();
});
afterEach(() => void vi.useRealTimers());

describe("a text that was not saved", () => {
  it("is offered, and is no longer stored once it is saved", async () => {
    const a = await openWindow(disk);
    await a.openFile("a.toml");
    await a.type(first);
    a.close();
    const b = await openWindow(disk);
    await b.openFile("a.toml");
    expect(b.recovered.value).toMatchObject([{ text: first, base }]);
    b.recoverText();
    expect(b.state.text.value).toBe(first);
    expect(b.conflict.value).toBeNull();
    await b.save();
    await b.rest();
    expect(disk.texts.get("a.toml")).toBe(first);
    expect(disk.journal.size).toBe(0);
  });

  it("does not overwrite a newer file: three windows", async () => {
    const a = await openWindow(disk);
    await a.openFile("a.toml");
    await a.type(first);
    a.close();
    const b = await openWindow(disk);
    await b.openFile("a.toml");
    await b.type(second);
    await b.save();
    await b.rest();
    b.close();
    expect(disk.texts.get("a.toml")).toBe(second);
    const c = await openWindow(disk);
    await c.openFile("a.toml");
    c.recoverText();
    expect(c.conflict.value, "the merge is offered at once").toMatchObject({ path: "a.toml", text: second });
    await c.save();
    expect(disk.texts.get("a.toml"), "nothing is overwritten").toBe(second);
    await c.settle("both");
    await c.save();
    await c.rest();
    expect(disk.texts.get("a.toml")).toBe(first.replace("bishop", "spencer"));
    expect(disk.journal.size).toBe(0);
  });

  it("is not overwritten by the newer file either", async () => {
    const a = await openWindow(disk);
    await a.openFile("a.toml");
    await a.type(first);
    a.close();
    disk.texts.set("a.toml", second);
    const c = await openWindow(disk);
    await c.openFile("a.toml");
    c.recoverText();
    await c.settle("theirs");
    expect(c.state.text.value).toBe(second);
    c.state.undo();
    expect(c.state.text.value).toBe(first);
    await c.rest();
    expect(disk.entries("a.toml")).toMatchObject([{ text: first }]);
    // An entry of an earlier version of the program has no base: lines of both texts stay.
    disk.journal.clear();
    disk.journal.set("a.toml|", { window: "", text: first, base: "", revision: "r0", time: 0 });
    await c.openFile("a.toml");
    c.recoverText();
    await c.settle("both");
    for (const line of [...first.split("\n"), ...second.split("\n")]) expect(c.state.text.value).toContain(line);
  });

  it("outlives what is typed while it is offered, and both are offered next time", async () => {
    const a = await openWindow(disk);
    await a.openFile("a.toml");
    await a.type(first);
    a.close();
    const b = await openWindow(disk);
    await b.openFile("a.toml");
    await b.type(second);
    expect(disk.entries("a.toml").map(({ text }) => text)).toEqual([second, first]);
    b.close();
    const c = await openWindow(disk);
    await c.openFile("a.toml");
    c.discardRecovered();
    await c.rest();
    expect(c.recovered.value.map(({ text }) => text)).toEqual([first]);
    expect(disk.entries("a.toml").map(({ text }) => text), "a discarded text is not offered again").toEqual([first]);
    // A text that was typed before the recovery stays in the journal.
    await c.type(second);
    c.recoverText();
    await c.rest();
    expect(disk.entries("a.toml").map(({ text }) => text)).toEqual([first, second]);
  });

  it("is kept for a case that was never saved", async () => {
    const a = await openWindow(disk);
    await a.offerJournal();
    await a.rest();
    expect(disk.journal.size, "the empty case is not stored").toBe(0);
    await a.type(`${emptyCase}# drawn\n`);
    a.close();
    const b = await openWindow(disk);
    await b.openFile("a.toml");
    expect(b.recovered.value).toEqual([]);
    await b.showNewCase();
    b.recoverText();
    expect(b.state.text.value).toBe(`${emptyCase}# drawn\n`);
    await b.save("new.toml");
    await b.rest();
    expect(disk.texts.get("new.toml")).toBe(`${emptyCase}# drawn\n`);
    expect(disk.journal.size).toBe(0);
  });

  it("is asked about in its own file only", async () => {
    const a = await openWindow(disk);
    await a.openFile("a.toml");
    await a.type(first);
    a.close();
    const b = await openWindow(disk);
    await b.openFile("a.toml");
    await b.showNewCase();
    expect([b.recovered.value, b.conflict.value]).toEqual([[], null]);
    await b.openFile("a.toml");
    expect(b.recovered.value).toHaveLength(1);
    await b.type(second);
    await b.save("c.toml");
    expect(b.recovered.value).toEqual([]);
    await b.rest();
    expect(disk.entries("a.toml"), "what was saved elsewhere is not stored").toMatchObject([{ text: first }]);
  });

  it("is forgotten by undo, but not where another file is opened", async () => {
    const a = await openWindow(disk);
    await a.openFile("a.toml");
    await a.type(first);
    a.state.undo();
    await a.rest();
    expect(disk.journal.size).toBe(0);
    await a.type(second);
    a.forgetText();
    await a.openFile("a.toml");
    expect(a.recovered.value, "changes that were discarded are not offered").toEqual([]);
    await a.type(second);
    a.state.undo();
    a.state.change("Type", first);
    await a.openFile("b.toml");
    await a.rest();
    expect(disk.entries("a.toml"), "within a second").toMatchObject([{ text: first }]);
    expect(disk.entries("b.toml")).toEqual([]);
  });
});
