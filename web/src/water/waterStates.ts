// SPDX-License-Identifier: MIT
/** Where the water stood, in time, with the titles and fields that the report adds. */
import { computed } from "@preact/signals";

import type { WaterMesh, WaterShown, WaterState } from "../contract";
import { report } from "../state";

export type ShownWater = WaterState & WaterShown;

/** States of the water and the mesh of their fields. */
export interface WaterStates {
  states: ShownWater[];
  water_mesh?: WaterMesh;
}

/** The last state is that which the methods began with; none in dry ground. */
export const startWater = computed<WaterStates>(() => {
  const { result, model } = report.value;
  const states = (result.water_states ?? []).map((state, i) => ({ ...state, ...model.water[i]! }));
  return { states, water_mesh: model.water_mesh };
});
