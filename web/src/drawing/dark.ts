// SPDX-License-Identifier: MIT
/** Whether the page is dark, for what is not drawn on a canvas alone. */
import { useEffect, useState } from "preact/hooks";

import { isDark, watchTheme } from "../viewer/theme";

export function useDark(): boolean {
  const [dark, setDark] = useState(isDark);
  useEffect(() => watchTheme(() => setDark(isDark())), []);
  return dark;
}
