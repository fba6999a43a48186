// SPDX-License-Identifier: MIT
/** The button that changes between light and dark colours. */
import { useState } from "preact/hooks";

export function ThemeButton() {
  const [theme, setTheme] = useState(document.documentElement.dataset.theme ?? "light");
  const other = theme === "dark" ? "light" : "dark";
  const change = () => {
    document.documentElement.dataset.theme = other;
    setTheme(other);
    try {
      localStorage.setItem("talus-theme", other);
    } catch {
      // A page from a disk may have no storage; the choice then lasts as long as the page.
    }
  };
  return (
    <button
      type="button"
      onClick={change}
      aria-label={`Change to ${other} colours`}
      title={`Change to ${other} colours`}
    >
      <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
        <circle cx="8" cy="8" r="6" fill="none" stroke="currentColor" stroke-width="1.5" />
        <path d="M8 2a6 6 0 0 1 0 12z" fill="currentColor" />
      </svg>
    </button>
  );
}
