// SPDX-License-Identifier: MIT
/** Index of the nearest of sorted abscissas, for the crosshair. */

/** Index of the number of ascending `sorted` nearest to `x`, the lower of two equally near; -1 when there is none. */
export function findNearest(sorted: ArrayLike<number>, x: number): number {
  let low = 0;
  let high = sorted.length - 1;
  if (high < 0 || Number.isNaN(x)) return -1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (sorted[middle]! < x) low = middle;
    else high = middle;
  }
  return Math.abs(sorted[high]! - x) < Math.abs(sorted[low]! - x) ? high : low;
}

/** Index of the frame whose `key` is nearest to `x`; frames without one are passed over; -1 when none has one. */
export function findNearestFrame<T>(frames: readonly T[], key: (frame: T) => number | null, x: number): number {
  let best = -1;
  let distance = Infinity;
  frames.forEach((frame, i) => {
    const k = key(frame);
    if (k !== null && Math.abs(k - x) < distance) {
      best = i;
      distance = Math.abs(k - x);
    }
  });
  return best;
}
