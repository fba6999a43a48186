// SPDX-License-Identifier: MIT
/** How far a computed value is from the published one. */
import type { Comparison, Report } from "../../contract";

export interface Difference {
  /** computed − published [SI]. */
  absolute: number | null;
  /** Over the published value's magnitude; null for a published zero. */
  relative: number | null;
  /** Over the tolerance: within ±1 passes. Without a tolerance, 0 where both are equal, else infinite. */
  overTolerance: number | null;
}

/** Of the run and of its element tests; a report of tests alone has theirs as its own. */
export const listComparisons = ({ kind, result, point_tests: tests }: Report): Comparison[] => [
  ...result.comparisons,
  ...(kind === "tests" ? [] : (tests?.comparisons ?? [])),
];

export function isMissing(comparison: Pick<Comparison, "computed">): boolean {
  return comparison.computed === null;
}

export function measureDifference(c: Pick<Comparison, "computed" | "published" | "tolerance">): Difference {
  if (c.computed === null) return { absolute: null, relative: null, overTolerance: null };
  const absolute = c.computed - c.published;
  const relative = c.published === 0 ? null : absolute / Math.abs(c.published);
  const overTolerance = absolute === 0 ? 0 : c.tolerance > 0 ? absolute / c.tolerance : Math.sign(absolute) * Infinity;
  return { absolute, relative, overTolerance };
}
