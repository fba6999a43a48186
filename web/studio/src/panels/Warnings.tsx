// SPDX-License-Identifier: MIT
/** Warnings and notes of a search, under its factors. */
import type { Message } from "../engine/engine";

export function Warnings({ messages = [] }: { messages?: Message[] }) {
  return messages.map(({ severity, text }) => (
    <p key={text} class={severity === "note" ? "muted" : "bad"}>
      {text}
    </p>
  ));
}
