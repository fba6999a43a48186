// SPDX-License-Identifier: MIT
/** True while the page is dark, for parts outside a canvas. */
import { useEffect, useState } from "preact/hooks";

import { isDark, watchTheme } from "../viewer/theme";

export function useDark(): boolean {
  const [dark, setDark] = useState(isDark);
  useEffect(() => watchTheme(() => setDark(isDark())), []);
  return dark;
}
