// SPDX-License-Identifier: MIT
/** The paragraphs of the methods section: which there are, in which order, with equations and references numbered. */
import type { MethodParagraph, Report } from "../../contract";
import { elements } from "./elements";
import { factor } from "./factor";
import { points } from "./points";
import { references } from "./references";
import { slices } from "./slices";
import { soils } from "./soils";
import { readBlocks, type Block, type MethodTexts } from "./writer";

/** All of them, in the order of the page. */
const texts = { ...slices, ...elements, ...points, ...soils, ...factor } satisfies Required<MethodTexts>;

type Numbered<B> = B extends { tex: string } ? B & { number: number } : B;

export interface Paragraph {
  method: MethodParagraph;
  title: string;
  blocks: Numbered<Block>[];
}

/** The paragraphs that apply to this report, and the references in the order in which they are first named. */
export function writeMethods(report: Report): { paragraphs: Paragraph[]; cited: string[] } {
  const cited: string[] = [];
  const numberOf = (key: string) => {
    if (!cited.includes(key)) cited.push(key);
    return cited.indexOf(key) + 1;
  };
  let equations = 0;
  const paragraphs = (Object.keys(texts) as MethodParagraph[])
    .filter((method) => report.methods.includes(method))
    .map((method) => {
      const [title, write] = texts[method];
      const blocks = readBlocks(write(report), numberOf);
      return { method, title, blocks: blocks.map((b) => ("tex" in b ? { ...b, number: ++equations } : b)) };
    });
  return { paragraphs, cited: cited.map((key) => references.get(key)!) };
}
