// SPDX-License-Identifier: MIT
/** The methods section as text for an engineer's own report: plain characters, or LaTeX. */
import type { Paragraph } from "./paragraphs";
import type { Piece } from "./writer";

const signs: { [command: string]: string } = {
  alpha: "α",
  chi: "χ",
  theta: "θ",
  gamma: "γ",
  zeta: "ζ",
  cdot: " · ",
  beta: "β",
  varepsilon: "ε",
  lambda: "λ",
  mu: "μ",
  nu: "ν",
  rho: "ρ",
  sigma: "σ",
  varphi: "φ",
  psi: "ψ",
  Delta: "Δ",
  nabla: "∇",
  sum: "Σ",
  ge: " ≥ ",
  le: " ≤ ",
  times: " × ",
  otimes: " ⊗ ",
  propto: " ∝ ",
  tan: "tan ",
  ln: "ln ",
  sqrt: "√",
};
const powers: { [character: string]: string } = {
  "-": "⁻",
  r: "ʳ",
  "0": "⁰",
  "1": "¹",
  "2": "²",
  "3": "³",
  "4": "⁴",
  "5": "⁵",
  "6": "⁶",
};

/** A short formula within a sentence in plain characters: "\sigma_1\ge\sigma_2" → "σ_1 ≥ σ_2". */
export function writePlainFormula(tex: string): string {
  return tex
    .replace(/\\(mathbf|boldsymbol|mathsf|operatorname|text)\s*\{?([A-Za-z]|\\[A-Za-z]+)\}?/g, "$2")
    .replace(/\^\{([^}]*)\}/g, (_, inner: string) =>
      [...inner].map((character) => powers[character] ?? character).join(""),
    )
    .replace(/\^(.)/g, (_, character: string) => powers[character] ?? character)
    .replace(/\\[,;]/g, " ")
    .replace(/\\([A-Za-z]+)\s?/g, (_, command: string) => signs[command] ?? command)
    .replace(/[{}]/g, "")
    .replace(/ {2,}/g, " ")
    .trim();
}

function writePieces(pieces: Piece[]): string {
  return pieces
    .map(({ kind, text }) => (kind === "math" ? writePlainFormula(text) : kind === "cite" ? `[${text}]` : text))
    .join("");
}

export function writePlainMethods(paragraphs: Paragraph[], cited: string[]): string {
  const parts = paragraphs.map(({ title, blocks }) =>
    [
      title,
      ...blocks.map((block) =>
        "pieces" in block ? writePieces(block.pieces) : `    ${block.plain}    (${block.number})`,
      ),
    ].join("\n"),
  );
  return `${parts.join("\n\n")}\n\nReferences\n${cited.map((text, i) => `[${i + 1}] ${text}`).join("\n")}\n`;
}

const escapeTex = (text: string) =>
  text
    .replace(/([%&#_])/g, "\\$1")
    .replace(/“/g, "``")
    .replace(/”/g, "''");

export function writeTexMethods(paragraphs: Paragraph[], cited: string[]): string {
  const pieces = (list: Piece[]) =>
    list
      .map(({ kind, text }) => (kind === "math" ? `$${text}$` : kind === "cite" ? `[${text}]` : escapeTex(text)))
      .join("");
  const parts = paragraphs.map(({ title, blocks }) =>
    [
      `\\paragraph{${escapeTex(title)}}`,
      ...blocks.map((block) =>
        "pieces" in block ? pieces(block.pieces) : `\\begin{equation}\n${block.tex}\n\\end{equation}`,
      ),
    ].join("\n"),
  );
  const list = cited.map((text, i) => `[${i + 1}] ${escapeTex(text)}\\\\`).join("\n");
  return `${parts.join("\n\n")}\n\n\\paragraph{References}\n${list}\n`;
}
