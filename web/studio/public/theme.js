// SPDX-License-Identifier: MIT
// The colours are chosen before anything is drawn, so that a dark screen does not flash white.
(() => {
  let theme = null;
  try {
    theme = localStorage.getItem("talus-theme");
  } catch {
    // Without storage the colours of the system are used.
  }
  if (theme !== "light" && theme !== "dark") theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  document.documentElement.dataset.theme = theme;
})();
