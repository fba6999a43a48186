// SPDX-License-Identifier: MIT
/** Whether the page is being printed: charts take the width of paper, and what was put off is drawn. */
import { signal } from "@preact/signals";

export const printing = signal(false);

if (typeof window !== "undefined") {
  window.addEventListener("beforeprint", () => (printing.value = true));
  window.addEventListener("afterprint", () => (printing.value = false));
}
