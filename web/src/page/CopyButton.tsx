// SPDX-License-Identifier: MIT
/** A button that copies a text and confirms it. */
import { useState } from "preact/hooks";

import { copyText } from "./copy";

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
