// SPDX-License-Identifier: MIT
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import type { RunReport } from "../src/engine/http";
import { makeFollower } from "../src/runs/follow";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** A follower with these answers, what it sent, what it told, and what it asked with. */
function follow(answers: (RunReport | Error)[]) {
  const [sent, told, asked]: [unknown[], [string, boolean][], string[]] = [[], [], []];
  const follower = makeFollower(
    (known) => {
      asked.push(known);
      const answer = answers[Math.min(asked.length, answers.length) - 1]!;
      return answer instanceof Error ? Promise.reject(answer) : Promise.resolve(answer);
    },
    { send: (data) => sent.push(data), tell: (text, active) => told.push([text, active]) },
  );
  return { follower, sent, told, asked };
}

describe("the report of a run", () => {
  it("is asked for until the run has ended, and sent where it has changed", async () => {
    const { follower, sent, asked } = follow([
      { active: true, why: "run 0001 has no results yet" },
      { active: true, stamp: "a", data: 1 },
      { active: true, stamp: "a" },
      { active: false, stamp: "b", data: 2 },
    ]);
    follower.start();
    await vi.advanceTimersByTimeAsync(60_000);
    expect(asked).toEqual(["", "", "a", "a"]);
    expect(sent).toEqual([1, 2]);
  });
  it("tells why there is none, and asks again after a fault", async () => {
    const { follower, told } = follow([{ active: true, why: "no results yet" }, new Error("no answer"), { active: false, stamp: "a", data: 1 }]);
    follower.start();
    await vi.advanceTimersByTimeAsync(60_000);
    expect(told).toEqual([["no results yet", true], ["no answer", false], ["", false]]);
  });
  it("is sent again to a page that was loaded anew, and no more after the end", async () => {
    const { follower, sent, asked } = follow([{ active: true, stamp: "a", data: 1 }]);
    follower.start();
    await vi.advanceTimersByTimeAsync(100);
    follower.start();
    await vi.advanceTimersByTimeAsync(100);
    expect(sent).toEqual([1, 1]);
    follower.stop();
    const before = asked.length;
    await vi.advanceTimersByTimeAsync(60_000);
    expect(asked.length).toBe(before);
  });
});
