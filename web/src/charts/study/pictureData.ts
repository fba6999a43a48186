// SPDX-License-Identifier: MIT
/** Frames of a study that are shown side by side, and their common scale. */
import type { Sequence, SequenceField } from "../../contract";
import type { Study, StudyRow } from "./shownStudy";

export interface PictureRow {
  row: StudyRow;
  sequence: Sequence;
  /** [frame] time on the clock [s]. */
  clock: number[];
  /** Frames shown side by side. */
  pictures: number[];
}

/** Rows with frames in the report. */
export function listPictures(study: Study, sequences: Sequence[]): PictureRow[] {
  return study.rows.flatMap((row) => {
    const sequence = sequences.find((s) => s.id === row.frames?.sequence);
    if (!row.frames || !sequence) return [];
    // A large run may show fewer frames than were chosen.
    const pictures = row.frames.pictures.filter((i) => i < sequence.frames.length);
    return [{ row, sequence, clock: row.frames.clock, pictures }];
  });
}

/** The widest of the scales, about zero when one of them is. */
export function joinScales(fields: SequenceField[]): [number, number] {
  const low = Math.min(...fields.map((f) => f.scale[0]));
  const high = Math.max(...fields.map((f) => f.scale[1]));
  if (!fields.some((f) => f.diverging)) return [low, high];
  const end = Math.max(-low, high);
  return [-end, end];
}
