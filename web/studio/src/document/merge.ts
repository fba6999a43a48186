// SPDX-License-Identifier: MIT
/** Merges two texts of one case that grew from the same text, line by line (diff3). */
import { diff3Merge, diffComm } from "node-diff3";

export interface Merged {
  text: string;
  /** Number of places that both have changed in different ways. */
  conflicts: number;
}

/** Precedes lines of the other text where both have changed the same lines: comments of TOML, so that nothing is lost. */
export const otherMark = "# other text: ";

const split = (text: string) => text.split("\n");

/**
 * Returns both changes of `base` in one text. Where both changed the same lines, those of `mine` stay and those of `theirs` follow as
 * comments.
 */
export function mergeTexts(mine: string, base: string, theirs: string): Merged {
  let conflicts = 0;
  const lines = diff3Merge(split(mine), split(base), split(theirs), { excludeFalseConflicts: true }).flatMap((part) => {
    if (part.ok) return part.ok;
    ++conflicts;
    const { a, b } = part.conflict!;
    return [...a, ...b.map((line) => otherMark + line)];
  });
  return { text: lines.join("\n"), conflicts };
}

/** The lines that two texts have in common, as their base where it is not known: a merge then keeps the lines of both. */
export const recoverBase = (mine: string, theirs: string): string =>
  diffComm(split(mine), split(theirs)).flatMap((part) => ("common" in part ? part.common : [])).join("\n");
