// SPDX-License-Identifier: MIT
/** Selects the factors of safety that the answer shows at once; the others are folded. */
import type { DesignStatement, Factor } from "../contract";

/** γ_R of the design values, which divides the factor of safety; 1 without. */
export const getResistance = (partial: DesignStatement | null) =>
  partial?.values.find(({ key }) => key === "resistance")?.value ?? 1;

/** A fold for fewer rows saves nothing. */
const worthFolding = 3;

/** With MPM alone all factors; with several methods the main ones and those that explain the differences. */
export function splitFactors(factors: Factor[]): { shown: Factor[]; folded: Factor[] } {
  if (factors.every((factor) => factor.method === "mpm")) return { shown: factors, folded: [] };
  const main = factors.find((factor) => factor.method === "lem" && factor.main);
  const isShown = (factor: Factor) =>
    factor.main ||
    factor.method === "bounds" ||
    ((factor.source === "noncircular" || factor.source === "critical") && factor.by === main?.by) ||
    factor.measure === "equilibrium" ||
    factor.by === "frozen" ||
    factor.by === "bilinear";
  const folded = factors.filter((factor) => !isShown(factor));
  return folded.length < worthFolding ? { shown: factors, folded: [] } : { shown: factors.filter(isShown), folded };
}
