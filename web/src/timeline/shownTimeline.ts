// SPDX-License-Identifier: MIT
/** The timeline of the results with the words and fields that the report adds; undefined without one. */
import { computed } from "@preact/signals";

import { report } from "../state";

export const shownTimeline = computed(() => {
  const { result, timeline: shown } = report.value;
  const { timeline } = result;
  if (!timeline || !shown) return undefined;
  return {
    ...timeline,
    unit: shown.unit,
    sentence: shown.sentence,
    water_mesh: shown.water_mesh,
    factors: timeline.factors.map((factor, i) => ({ ...factor, title: shown.factors[i]! })),
    elements: timeline.elements.map((reduction, i) => ({ ...reduction, title: shown.elements[i]! })),
    states: timeline.states.map((state, i) => ({ ...state, ...shown.states[i]! })),
    releases: timeline.releases.map((release, i) => ({ ...release, ...shown.releases[i]! })),
  };
});

export type ShownTimeline = NonNullable<typeof shownTimeline.value>;
export type ShownRelease = ShownTimeline["releases"][number];
