// SPDX-License-Identifier: MIT
/** Factors of safety by method and criterion, each with its bracket, drawn on one common axis. */
import { formatFactor } from "./format";
import type { Factor, MethodName } from "../contract";

export const methodNames: Record<MethodName, string> = {
  mpm: "Material points",
  lem: "Slices",
  fem: "Finite elements",
  bounds: "Proven bounds",
};

/** The pore water in the trials of a factor. */
export function describeDrainage(water: NonNullable<Factor["water"]>): string {
  return water === "held" ? "drained, pressures held" : "coupled, water moves";
}

/** The common axis: all brackets and the value 1, with a little room. */
function findRange(factors: Factor[]): [number, number] {
  const all = factors.flatMap((factor) => [factor.value, factor.lower, factor.upper]).filter((x) => x !== null);
  const low = Math.min(1, ...all);
  const high = Math.max(1, ...all);
  const room = Math.max(0.02, 0.05 * (high - low));
  return [low - room, high + room];
}

interface StripProps {
  factor: Factor;
  range: [number, number];
  /** What is proven, behind the marks of all methods. */
  proven: Factor | undefined;
}

function Strip({ factor, range: [low, high], proven }: StripProps) {
  const share = (x: number) => ((x - low) / (high - low)) * 100;
  const at = (x: number) => `${share(x)}%`;
  const from = factor.lower ?? factor.value;
  const to = factor.upper ?? factor.value;
  return (
    <svg class="strip" width="100%" height="14" aria-hidden="true">
      {proven && (
        <rect
          class="proven"
          x={at(proven.lower!)}
          width={`${share(proven.upper!) - share(proven.lower!)}%`}
          y="0"
          height="14"
        />
      )}
      <line class="axis" x1="0" x2="100%" y1="7" y2="7" />
      <line class="one" x1={at(1)} x2={at(1)} y1="0" y2="14" />
      {from !== null && to !== null && <line class="span" x1={at(from)} x2={at(to)} y1="7" y2="7" />}
      {factor.value !== null && <circle class={factor.main ? "dot main" : "dot"} cx={at(factor.value)} cy="7" r="4" />}
    </svg>
  );
}

interface Props {
  factors: Factor[];
  /** Those that share the axis. */
  among: Factor[];
  caption: string;
}

export function FactorTable({ factors, among, caption }: Props) {
  const range = findRange(among);
  const methods = new Set(among.map((factor) => factor.method));
  const proven = among.find((factor) => factor.method === "bounds" && factor.lower !== null && factor.upper !== null);
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
              Drawn from {range[0].toFixed(2)} to {range[1].toFixed(2)}; the line is at 1
            </span>
          </th>
        </tr>
      </thead>
      <tbody>
        {factors.map((factor) => (
          <tr key={`${factor.method} ${factor.name} ${factor.title}`} class={factor.main ? "main" : undefined}>
            <th scope="row" title={factor.note || undefined}>
              {methods.size > 1 && <span class="method">{methodNames[factor.method]}: </span>}
              {factor.title}
              {factor.water && <span class="note">; {describeDrainage(factor.water)}</span>}
              {factor.value === null && factor.lower === null && factor.note && <span class="note"> – {factor.note}</span>}
            </th>
            <td class="number">{formatFactor(factor.value, factor.method === "bounds" ? "–" : "none")}</td>
            <td class="number muted">
              {factor.lower !== null && factor.upper !== null
                ? `${formatFactor(factor.lower)}–${formatFactor(factor.upper)}`
                : "–"}
            </td>
            <td class="strip-cell">
              <Strip factor={factor} range={range} proven={proven} />
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
