// SPDX-License-Identifier: MIT
/** The arrays of the trials, once they are decoded. */
import { useEffect, useState } from "preact/hooks";

import type { Slices } from "../contract";
import { load, loadPlaces } from "../state";

export interface TrialArrays {
  circles: Float64Array;
  factors: Float32Array;
}

export function useTrials({ trials }: Slices): { arrays: TrialArrays | null; failure: string } {
  const [arrays, setArrays] = useState<TrialArrays | null>(null);
  const [failure, setFailure] = useState("");
  useEffect(() => {
    if (!trials) return;
    Promise.all([loadPlaces(trials.circles), load(trials.factors)]).then(
      ([circles, factors]) => setArrays({ circles, factors }),
      (error) => setFailure(String(error?.message ?? error)),
    );
  }, [trials]);
  return { arrays, failure };
}
