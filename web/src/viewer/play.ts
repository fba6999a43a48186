// SPDX-License-Identifier: MIT
/** Stepping and playing through the frames. */
import { effect } from "@preact/signals";

import { frameIndex, sequence, sequenceIndex } from "../state";
import { playing, speed } from "./settings";

/** Frames per second at speed 1. */
const rate = 12;

export function countFrames(): number {
  return sequence.value?.frames.length ?? 0;
}

export function goTo(index: number): void {
  frameIndex.value = Math.min(Math.max(0, index), Math.max(0, countFrames() - 1));
}

/** Steps by hand; that ends playing. */
export function step(by: number): void {
  playing.value = false;
  goTo(frameIndex.value + by);
}

export function togglePlaying(): void {
  if (!playing.value && frameIndex.value >= countFrames() - 1) frameIndex.value = 0;
  playing.value = !playing.value && countFrames() > 1;
}

/** Shows another sequence; its last frame, where most has happened. */
export function showSequence(index: number): void {
  playing.value = false;
  sequenceIndex.value = index;
  frameIndex.value = Math.max(0, countFrames() - 1);
}

/** Moves the frames on while playing; returns what ends that. */
export function startClock(): () => void {
  let request = 0;
  const end = effect(() => {
    cancelAnimationFrame(request);
    if (!playing.value) return;
    let due = performance.now() + 1000 / (rate * speed.value);
    const tick = (now: number) => {
      if (now >= due) {
        // A slow machine skips frames rather than stretching the time.
        const passed = 1 + Math.floor(((now - due) * rate * speed.peek()) / 1000);
        due += (passed * 1000) / (rate * speed.peek());
        goTo(frameIndex.peek() + passed);
        if (frameIndex.peek() >= countFrames() - 1) return void (playing.value = false);
      }
      request = requestAnimationFrame(tick);
    };
    request = requestAnimationFrame(tick);
  });
  return () => {
    cancelAnimationFrame(request);
    end();
  };
}
