// SPDX-License-Identifier: MIT
/** Messages of the checker: a click selects the key in the text and shows its place. */
import { computed, useSignal } from "@preact/signals";

import { view } from "../canvas/camera";
import type { Message } from "../engine/engine";
import * as state from "../state";
import { findOffset } from "./offsets";
import { openTab, shownSpan } from "./tabs";

const sorted = computed(() => {
  const rank = { error: 0, warning: 1, note: 2 };
  return state.messages.value.toSorted((a, b) => rank[a.severity] - rank[b.severity]);
});

function show(message: Message): void {
  if (message.place) view.value = { ...view.value, centre: message.place };
  if (message.span) {
    shownSpan.value = [findOffset(state.text.value, message.span[0]), findOffset(state.text.value, message.span[1])];
    openTab("text");
  }
}

export function Messages() {
  const open = useSignal(true);
  const all = sorted.value;
  const errors = all.filter(({ severity }) => severity === "error").length;
  const warnings = all.filter(({ severity }) => severity === "warning").length;
  const count = (n: number, word: string) => (n ? `${n} ${word}${n === 1 ? "" : "s"}` : "");
  const summary = [count(errors, "error"), count(warnings, "warning")].filter(Boolean).join(", ") || "No errors and no warnings";
  const fault = state.fault.value;
  return (
    <section class="messages" aria-label="Messages">
      <h2>
        <button type="button" aria-expanded={open.value} onClick={() => (open.value = !open.value)}>
          <span class={fault || errors ? "dot bad-dot" : warnings ? "dot warn-dot" : "dot good-dot"} />
          {fault ? "The text is not TOML" : summary}
        </button>
      </h2>
      {open.value && (fault || all.length > 0) && (
        <ul>
          {fault && (
            <li class="error">
              {fault.text} The canvas shows the last text that could be read.
            </li>
          )}
          {all.map((message, i) => (
            <li key={i} class={message.severity}>
              {message.span || message.place ? (
                <button type="button" onClick={() => show(message)}>
                  {message.text}
                </button>
              ) : (
                message.text
              )}
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}
