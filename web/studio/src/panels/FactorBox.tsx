// SPDX-License-Identifier: MIT
/** The factor of safety of the section as it is: it follows the mouse. */
import { formatFactor } from "../../../src/page/format";
import { liveMethod } from "../session";
import * as state from "../state";
import { writeLengthShown } from "../units";
import { Warnings } from "./Warnings";

const methods: Record<string, string> = {
  bishop: "Bishop",
  spencer: "Spencer",
  morgenstern_price: "Morgenstern–Price",
  janbu_corrected: "Janbu, corrected",
};

function describe(): string {
  const found = state.solved.value;
  const errors = state.messages.value.filter(({ severity }) => severity === "error").length;
  if (state.chains.value.length === 0) return "Draw a region to begin.";
  if (errors) return `${errors} ${errors === 1 ? "error" : "errors"}: see the messages below.`;
  if (!found) return state.solveFault.value || "Searching …";
  if (found.factor === null) return state.solveFault.value || "No surface has a factor.";
  const circle = found.circle ? `, R = ${writeLengthShown(found.circle.radius)}` : "";
  return `Quick search: ${found.searched.toLocaleString("en").replaceAll(",", "\u202f")} circles${circle}`;
}

export function FactorBox() {
  const found = state.solved.value;
  const errors = state.messages.value.some(({ severity }) => severity === "error");
  const factor = found && !errors ? found.factor : null;
  const text = describe();
  const low = factor !== null && factor < 1;
  return (
    <div class={`factor-box${state.isSolving.value ? " stale" : ""}`}>
      <label>
        <span class="unseen">Method of the quick search</span>
        <select value={liveMethod.value} onChange={(e) => (liveMethod.value = e.currentTarget.value)}>
          {Object.entries(methods).map(([key, name]) => (
            <option key={key} value={key}>
              {name}
            </option>
          ))}
        </select>
      </label>
      <output class={low ? "factor low" : "factor"} aria-label="Factor of safety" aria-live="off">
        {formatFactor(factor)}
      </output>
      <p aria-live="polite" title={`${text}. Circles alone, not held against limit analysis: a run does both.`}>
        {text.replace(/^./, (c) => c.toUpperCase())}
      </p>
      {factor !== null && <Warnings messages={found?.messages} />}
    </div>
  );
}
