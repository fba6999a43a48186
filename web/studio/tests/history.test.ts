// SPDX-License-Identifier: MIT
/** Undo and redo over every kind of edit, and requests of which the latest wins. */
import { describe, expect, test } from "vitest";

import { makeLatest } from "../src/engine/latest";
import { History } from "../src/history/history";

describe("History", () => {
  test("undo and redo pass through every text", () => {
    const texts = ["", "a", "ab", "Xab", "Xb", "b"];
    const history = new History(texts[0]!);
    texts.slice(1).forEach((text, i) => history.change(`step ${i}`, text));
    expect(history.undoNames[0]).toBe("step 4");
    for (const text of texts.slice(0, -1).toReversed()) {
      history.undo();
      expect(history.text).toBe(text);
    }
    expect(history.undo()).toBeNull();
    for (const text of texts.slice(1)) {
      history.redo();
      expect(history.text).toBe(text);
    }
    expect(history.redo()).toBeNull();
  });
  test("the places of a drag are one step, and the next drag is another", () => {
    const history = new History("x = 1");
    for (const x of [2, 3, 45]) history.change("Move", `x = ${x}`, "drag 1");
    history.change("Move", "x = 7", "drag 2");
    expect(history.undoNames).toEqual(["Move", "Move"]);
    history.undo();
    expect(history.text).toBe("x = 45");
    history.undo();
    expect(history.text).toBe("x = 1");
  });
  test("a drag that returns leaves nothing to undo", () => {
    const history = new History("x = 1");
    history.change("Move", "x = 2", "drag 1");
    history.change("Move", "x = 1", "drag 1");
    expect(history.undoNames).toEqual([]);
  });
  test("a sealed group takes no more changes", () => {
    const history = new History("a");
    history.change("Type", "ab", "text");
    history.seal();
    history.change("Type", "abc", "text");
    expect(history.undoNames).toHaveLength(2);
  });
  test("a change after an undo ends what could be redone", () => {
    const history = new History("a");
    history.change("one", "b");
    history.undo();
    history.change("two", "c");
    expect(history.redoNames).toEqual([]);
    expect(history.change("none", "c")).toBe(false);
  });
});

describe("Requests", () => {
  test("one is in flight, and of those that wait the latest alone is sent", async () => {
    const sent: number[] = [];
    const delivered: number[] = [];
    const open: (() => void)[] = [];
    const latest = makeLatest(
      (input: number) => {
        sent.push(input);
        return new Promise<number>((resolve) => open.push(() => resolve(10 * input)));
      },
      (output) => delivered.push(output),
      () => undefined,
    );
    const settle = () => new Promise((resolve) => setImmediate(resolve));
    [1, 2, 3, 4].forEach((input) => latest.ask(input));
    expect(sent).toEqual([1]);
    open[0]!();
    await settle();
    expect(sent).toEqual([1, 4]);
    open[1]!();
    await settle();
    expect(delivered).toEqual([10, 40]);
    expect(latest.busy).toBe(false);
  });
  test("a failure is reported and the next request is sent", async () => {
    const faults: string[] = [];
    const delivered: number[] = [];
    const latest = makeLatest(
      (input: number) => (input === 1 ? Promise.reject(new Error("no")) : Promise.resolve(input)),
      (output) => delivered.push(output),
      (error) => faults.push((error as Error).message),
    );
    latest.ask(1);
    latest.ask(2);
    await new Promise((resolve) => setImmediate(resolve));
    expect(faults).toEqual(["no"]);
    expect(delivered).toEqual([2]);
  });
});
