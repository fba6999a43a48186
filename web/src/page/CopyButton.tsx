// SPDX-License-Identifier: MIT
/** A button that copies a text, also in a page that was opened from a disk, and confirms it. */
import { useState } from "preact/hooks";

async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // Older browsers give no clipboard to pages from a disk; selecting and copying still works there.
    const area = document.createElement("textarea");
    area.value = text;
    area.style.position = "fixed";
    area.style.opacity = "0";
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

export function CopyButton({ label, text }: { label: string; text: () => string }) {
  const [said, setSaid] = useState("");
  const copy = async () => {
    setSaid((await copyText(text())) ? "Copied" : "Copying is not allowed here");
    setTimeout(() => setSaid(""), 2500);
  };
  return (
    <span class="copy">
      <span class="said" role="status">
        {said}
      </span>
      <button type="button" onClick={copy}>
        {label}
      </button>
    </span>
  );
}
