// SPDX-License-Identifier: MIT
/** Settings of drawings: whether the page is dark, and how much of the soils is seen through a field that is painted over them. */
import { useEffect, useState } from "preact/hooks";

import { isDark, watchTheme } from "../viewer/theme";

export function useDark(): boolean {
  const [dark, setDark] = useState(isDark);
  useEffect(() => watchTheme(() => setDark(isDark())), []);
  return dark;
}

const usual = 0.72;

export function useOpacity(): { opacity: number; slider: preact.ComponentChildren } {
  const [opacity, setOpacity] = useState(usual);
  const slider = (
    <label>
      Field over soils
      <input
        type="range"
        min="0"
        max="1"
        step="0.04"
        value={opacity}
        onInput={(e) => setOpacity(e.currentTarget.valueAsNumber)}
      />
    </label>
  );
  return { opacity, slider };
}
