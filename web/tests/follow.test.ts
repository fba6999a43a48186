// SPDX-License-Identifier: MIT
import { beforeEach, describe, expect, it } from "vitest";

import type { PackedArray, Report } from "../src/contract";
import { followReport, frameIndex, loadIntegers, report, sequenceIndex } from "../src/state";
import type { ReportData } from "../src/data";

/** Bytes as the program packs them. */
async function pack(bytes: number[]): Promise<string> {
  const stream = new Blob([Uint8Array.from(bytes)]).stream().pipeThrough(new CompressionStream("deflate"));
  return btoa(String.fromCharCode(...new Uint8Array(await new Response(stream).arrayBuffer())));
}

const array: PackedArray = { id: "numbers", type: "u8", shape: [2], delta: false } as unknown as PackedArray;

async function makeData(sequences: { id: string; frames: number }[], bytes: number[]): Promise<ReportData> {
  const list = sequences.map(({ id, frames }) => ({ id, frames: Array.from({ length: frames }, () => ({})) }));
  return { report: { sequences: list }, results: {}, arrays: { numbers: await pack(bytes) } } as unknown as ReportData;
}

describe("a page that follows a run", () => {
  // Test files share one process, and with it the state of the page.
  beforeEach(() => {
    report.value = null as unknown as Report;
    [sequenceIndex.value, frameIndex.value] = [0, 0];
  });
  it("reads an array anew only where it has changed", async () => {
    followReport(await makeData([], [1, 2]));
    const first = loadIntegers(array);
    expect([...(await first)]).toEqual([1, 2]);
    followReport(await makeData([], [1, 2]));
    expect(loadIntegers(array)).toBe(first);
    followReport(await makeData([], [3, 4]));
    expect([...(await loadIntegers(array))]).toEqual([3, 4]);
  });
  it("stays at the sequence and frame that are shown, and goes on where the last frame is", async () => {
    followReport(await makeData([{ id: "stages", frames: 3 }], []));
    expect((report.value as Report).sequences.length).toBe(1);
    [sequenceIndex.value, frameIndex.value] = [0, 1];
    followReport(await makeData([{ id: "trial", frames: 9 }, { id: "stages", frames: 5 }], []));
    expect([sequenceIndex.value, frameIndex.value]).toEqual([1, 1]);
    frameIndex.value = 4;
    followReport(await makeData([{ id: "trial", frames: 9 }, { id: "stages", frames: 7 }], []));
    expect([sequenceIndex.value, frameIndex.value]).toEqual([1, 6]);
  });
});
