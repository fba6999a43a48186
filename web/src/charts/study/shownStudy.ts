// SPDX-License-Identifier: MIT
/** A study as its charts need it: study.json with the table and the results of the variants that the report adds. */
import { computed } from "@preact/signals";

import type { ExtrapolatedFactor, StudyResult, StudyShown, StudyVariant, VariantShown } from "../../contract";
import { report } from "../../state";

export type StudyRow = StudyVariant & VariantShown;

export interface Study extends Pick<StudyResult, "vary" | "mode" | "reference" | "extrapolation"> {
  columns: StudyShown["columns"];
  rows: StudyRow[];
}

/** Factors of methods without a mesh do not vary with the size. */
const varies = ({ factors }: ExtrapolatedFactor) => factors.some((factor) => factor !== factors[0]);

/** Undefined for any other report. */
export const shownStudy = computed<Study | undefined>(() => {
  const { study_result: result, study: shown } = report.value;
  if (!result || !shown) return undefined;
  const { extrapolation, variants } = result;
  return {
    ...result,
    columns: shown.columns,
    rows: variants.map((variant, i) => ({ ...variant, ...shown.rows[i]! })),
    extrapolation: extrapolation && {
      ...extrapolation,
      // The symbol of the page.
      factors: extrapolation.factors
        .filter(varies)
        .map((factor) => ({ ...factor, criterion: factor.criterion.replace(/^FoS/, "F") })),
    },
  };
});
