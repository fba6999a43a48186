// SPDX-License-Identifier: MIT
/** The strength reductions by FEM, with what their figures and tables add to the results. */
import { computed } from "@preact/signals";

import { report } from "../state";

export const flowRuns = computed(() => {
  const { result, finite_elements: drawn } = report.value;
  return (result.fem?.runs ?? []).map((run, i) => ({
    ...run,
    title: run.flow === "associated" ? "associated flow, ψ = φ" : "ψ as given",
    trials: [...run.trials].sort((a, b) => a.factor - b.factor),
    /** One, or one of each side where the soil moves to both [m]. */
    slip_lines: run.sides?.map((side) => side.points) ?? (run.slip_line.length > 0 ? [run.slip_line] : []),
    fields: drawn?.fields[i] ?? undefined,
  }));
});

/** One strength reduction: with the flow rule as given, or associated. */
export type FlowRun = (typeof flowRuns.value)[number];
