// SPDX-License-Identifier: MIT
/** True while the page is printed: charts take the width of paper, and deferred parts are drawn. */
import { signal } from "@preact/signals";

export const printing = signal(false);

if (typeof window !== "undefined") {
  window.addEventListener("beforeprint", () => (printing.value = true));
  window.addEventListener("afterprint", () => (printing.value = false));
}
