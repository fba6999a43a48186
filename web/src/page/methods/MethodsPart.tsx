// SPDX-License-Identifier: MIT
/** The methods section: paragraphs for an engineer's own report, with equations and references. */
import katex from "katex";
import { useMemo } from "preact/hooks";

import { report } from "../../state";
import { CopyButton, Lazy, Part } from "../Part";
import { Scroller } from "../DataTable";
import { writeMethods, type Paragraph } from "./paragraphs";
import { writePlainMethods, writeTexMethods } from "./plainText";
import type { Piece } from "./writer";

/** MathML only: browsers draw it with the fonts that are there. */
function Formula({ tex, display }: { tex: string; display?: boolean }) {
  const html = useMemo(
    () => katex.renderToString(tex, { output: "mathml", displayMode: display ?? false, throwOnError: false }),
    [tex, display],
  );
  return <span class={display ? "formula display" : "formula"} dangerouslySetInnerHTML={{ __html: html }} />;
}

function PieceView({ piece }: { piece: Piece }) {
  if (piece.kind === "math") return <Formula tex={piece.text} />;
  if (piece.kind === "text") return <>{piece.text}</>;
  return (
    <span class="cite">
      [
      {piece.text.split(", ").map((number, i) => (
        <>
          {i > 0 && ", "}
          <a href={`#reference-${number}`} aria-label={`Reference ${number}`}>
            {number}
          </a>
        </>
      ))}
      ]
    </span>
  );
}

function ParagraphView({ paragraph }: { paragraph: Paragraph }) {
  return (
    <div class="method" id={`method-${paragraph.method}`}>
      <h3>{paragraph.title}</h3>
      {paragraph.blocks.map((block, i) =>
        "pieces" in block ? (
          <p key={i}>
            {block.pieces.map((piece, j) => (
              <PieceView key={j} piece={piece} />
            ))}
          </p>
        ) : (
          <Scroller key={i} class="equation" label={`Equation ${block.number}`}>
            <Formula tex={block.tex} display />
            <span class="equation-number">({block.number})</span>
          </Scroller>
        ),
      )}
    </div>
  );
}

function Text({ paragraphs, cited }: { paragraphs: Paragraph[]; cited: string[] }) {
  return (
    <div class="methods-text">
      <div>
        {paragraphs.map((paragraph) => (
          <ParagraphView key={paragraph.method} paragraph={paragraph} />
        ))}
      </div>
      <div class="references">
        <h3>References</h3>
        <ol>
          {cited.map((text, i) => (
            <li key={i} id={`reference-${i + 1}`}>
              {text}
            </li>
          ))}
        </ol>
      </div>
    </div>
  );
}

const lead = "How this was calculated, in paragraphs that may be copied into a report. Only what was used is named.";

export function MethodsPart() {
  const { paragraphs, cited } = useMemo(() => writeMethods(report.value), [report.value]);
  const tools = (
    <>
      <CopyButton label="Copy as text" text={() => writePlainMethods(paragraphs, cited)} />
      <CopyButton label="Copy as LaTeX" text={() => writeTexMethods(paragraphs, cited)} />
    </>
  );
  return (
    <Part id="methods" title="Methods" lead={lead} tools={tools} newPage>
      <Lazy height={1400}>{() => <Text paragraphs={paragraphs} cited={cited} />}</Lazy>
    </Part>
  );
}
