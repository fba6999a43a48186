// SPDX-License-Identifier: MIT
/** Colour, dashes and symbol of the nth series, which are distinct without colour too. Colours are variables of charts.css. */

export interface SeriesStyle {
  colour: string;
  dash: string;
  symbol: "circle" | "square" | "triangle" | "diamond" | "times" | "plus" | "star";
}

const dashes = ["", "7 3", "2 2.5", "9 3 2 3", "12 4", "5 2 1.5 2 1.5 2", "1.5 4"];
const symbols = ["circle", "square", "triangle", "diamond", "times", "plus", "star"] as const;
const count = 7;

export function styleOf(index: number): SeriesStyle {
  // After seven the colours come again, each with the dashes of another.
  const round = Math.floor(index / count);
  return {
    colour: `var(--series-${(index % count) + 1})`,
    dash: dashes[(index + round * 3) % count]!,
    symbol: symbols[(index + round * 2) % count]!,
  };
}

/** The nth dashes alone, where they mean something else than the colour. */
export function dashOf(index: number): string {
  return dashes[index % count]!;
}
