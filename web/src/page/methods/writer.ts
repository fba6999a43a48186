// SPDX-License-Identifier: MIT
/** Language of the paragraphs of the methods section: running text with formulas and references, and equations. */
import type { MethodParagraph, Report } from "../../contract";

/** Writes the text of a paragraph; empty for one that does not apply. */
type Writer = (report: Report) => string;

/** Paragraphs by name, each with its title. */
export type MethodTexts = Partial<Record<MethodParagraph, [title: string, write: Writer]>>;

/**
 * Text of a paragraph as it is written: `$x$` is a formula, `[@key]` a reference, and `$$tex$$ plain $$` an equation in
 * TeX and in plain characters. A blank line ends a block, a line break is a space.
 */
export const prose = String.raw;

/** A piece of running text. */
export type Piece = { kind: "text" | "math" | "cite"; text: string };
export type Block = { pieces: Piece[] } | { tex: string; plain: string };

/** Cuts a text at its formulas and references; references become their numbers, "[1, 2]". */
function cutText(text: string, numberOf: (key: string) => number): Piece[] {
  return text
    .split(/(\$[^$]+\$|\[@[^\]]+\])/)
    .filter(Boolean)
    .map((piece): Piece => {
      if (piece.startsWith("$")) return { kind: "math", text: piece.slice(1, -1) };
      if (!piece.startsWith("[@")) return { kind: "text", text: piece };
      const keys = piece.slice(1, -1).split(";");
      return { kind: "cite", text: keys.map((key) => numberOf(key.trim().slice(1))).join(", ") };
    });
}

export function readBlocks(written: string, numberOf: (key: string) => number): Block[] {
  return written.split(/\n *\n/).flatMap((part) => {
    const pieces = part.split("$$").map((piece) => piece.trim().replace(/\n */g, " "));
    return pieces.flatMap((text, i): Block[] => {
      if (i % 3 === 1) return [{ tex: text, plain: pieces[i + 1]! }];
      return i % 3 === 0 && text ? [{ pieces: cutText(text, numberOf) }] : [];
    });
  });
}
