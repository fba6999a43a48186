// SPDX-License-Identifier: MIT
/** Factors of safety by method and criterion, each with its bracket, drawn on one common axis. */
import { FactorMark, makeFactorScale, markFactor } from "../compared/FactorMark";
import { findMethods } from "../compared/methodTable";
import type { Factor, Method } from "../contract";
import { report } from "../state";
import { formatFactor, formatInterval } from "./format";

/** The title of a method, as the program names it. */
export const getMethodTitle = (method: Method) => report.value.method_titles[method];

/** The pore water in the trials of a factor. */
export function describeDrainage(water: NonNullable<Factor["water"]>): string {
  return water === "held" ? "drained, pressures held" : "coupled, water moves";
}

interface Props {
  factors: Factor[];
  /** Factors on the same axis. */
  among: Factor[];
  caption: string;
}

export function FactorTable({ factors, among, caption }: Props) {
  const methods = new Set(among.map((factor) => factor.method));
  const scale = makeFactorScale(among.map(markFactor), !findMethods(report.value)?.unjudged);
  return (
    <table class="factors">
      <caption class="unseen">{caption}</caption>
      <thead>
        <tr>
          <th scope="col">Criterion</th>
          <th scope="col" class="number">
            F
          </th>
          <th scope="col" class="number">
            Range
          </th>
          <th scope="col" class="strip-cell">
            <span class="unseen">
              {scale && `Drawn from ${scale.low.toFixed(2)} to ${scale.high.toFixed(2)}; the line is at 1`}
            </span>
          </th>
        </tr>
      </thead>
      <tbody>
        {factors.map((factor) => (
          <tr key={`${factor.method} ${factor.name} ${factor.title}`} class={factor.main ? "main" : undefined}>
            <th scope="row" title={factor.note || undefined}>
              {methods.size > 1 && <span class="method">{getMethodTitle(factor.method)}: </span>}
              {factor.title}
              {factor.water && <span class="note">; {describeDrainage(factor.water)}</span>}
              {factor.value === null && factor.lower === null && factor.note && <span class="note"> – {factor.note}</span>}
            </th>
            <td class="number">{formatFactor(factor.value, factor.method === "bounds" ? "–" : "none")}</td>
            <td class="number muted">{formatInterval(factor)}</td>
            <td class="strip-cell">
              {scale && <FactorMark scale={scale} row={markFactor(factor)} />}
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
