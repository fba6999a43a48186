// SPDX-License-Identifier: MIT
/** The answer: a strong disagreement of the methods; the factor of safety large, in words, beside other criteria; runout; warnings. */
import { formatNumber } from "../charts/base/numbers";
import { findMethods } from "../compared/methodTable";
import { keepFurthestOfStages } from "../construction/construction";
import type { DesignStatement, Factor, ShownResult } from "../contract";
import { report } from "../state";
import { FactorTable, getMethodTitle } from "./FactorTable";
import { WarningLink, Warnings } from "./Warnings";
import { formatCount, formatFactor, formatInterval, formatQuantity, splitSentences } from "./format";

/** γ_R of the design values, which divides the factor of safety; 1 without. */
export const getResistance = (partial: DesignStatement | null) =>
  partial?.values.find(({ key }) => key === "resistance")?.value ?? 1;

/** A fold for fewer rows saves nothing. */
const worthFolding = 3;

/** With MPM alone all factors; with several methods the main ones and those that explain the differences. */
export function splitFactors(factors: Factor[]): { shown: Factor[]; folded: Factor[] } {
  if (factors.every((factor) => factor.method === "mpm")) return { shown: factors, folded: [] };
  const main = factors.find((factor) => factor.method === "lem" && factor.main);
  const isShown = (factor: Factor) =>
    factor.main ||
    factor.method === "bounds" ||
    ((factor.source === "noncircular" || factor.source === "critical") && factor.by === main?.by) ||
    factor.measure === "equilibrium" ||
    factor.by === "frozen" ||
    factor.by === "bilinear";
  const folded = factors.filter((factor) => !isShown(factor));
  return folded.length < worthFolding ? { shown: factors, folded: [] } : { shown: factors.filter(isShown), folded };
}

/** Partial factors make it one of design values, and failure a matter of verification. */
const findPartialFactors = () => findMethods(report.value)?.partial_factors ?? null;
const hasDesignValues = () => findPartialFactors() !== null;
const resistance = () => getResistance(findPartialFactors());
/** Value to be compared with 1: the factor of safety over γ_R. */
const check = (factor: number | null) => (factor === null ? null : factor / resistance());
const checkInterval = ({ lower, upper }: Factor) => ({ lower: check(lower), upper: check(upper) });
const nameFactor = () =>
  hasDesignValues() ?
    resistance() === 1 ? "Factor of safety with design values"
    : `Factor of safety with design values over the resistance factor ${formatNumber(resistance(), 4)}`
  : report.value.result.lem?.drawdown ? "Factor of safety after drawdown"
  : "Factor of safety";
const describeFailure = () =>
  hasDesignValues() ? "the slope is not verified"
  : report.value.timeline ? "the slope fails in this time"
  : "the slope fails in its present state";

/** Interval of limit analysis. */
function Interval({ factor }: { factor: Factor }) {
  const { lower, upper } = checkInterval(factor);
  return (
    <span class={(lower ?? upper)! < 1 ? "value interval bad" : "value interval"}>
      {formatInterval({ lower, upper })}
    </span>
  );
}

/** Returns whether a factor, or the proven upper bound, is below what is asked for. */
const isBelow = ({ value, upper, method }: Factor) => (check(method === "bounds" ? upper : value) ?? 1) < 1;

/** The name of the factor, with what follows where it is too low. */
function Label({ fails, factor }: { fails: boolean; factor?: Factor }) {
  return (
    <>
      <WarningLink />
      <p class="label">
        {nameFactor()}
        {fails && <strong class="bad">, below 1: {describeFailure()}</strong>}
        {factor && <span class="criterion">{factor.title}</span>}
      </p>
    </>
  );
}

function MethodValue({ factor }: { factor: Factor }) {
  return (
    <div>
      <dt>{getMethodTitle(factor.method)}</dt>
      <dd>
        {factor.value === null ? (
          <Interval factor={factor} />
        ) : (
          <span class={check(factor.value)! < 1 ? "value bad" : "value"}>{formatFactor(check(factor.value))}</span>
        )}
        <span class="criterion">{factor.title}</span>
        <Referee factor={factor} />
      </dd>
    </div>
  );
}

/** The interval that limit analysis proves for the soil of limit equilibrium. */
function Referee({ factor }: { factor: Factor }) {
  const { method, lower, upper } = factor;
  if (method !== "lem" || (lower ?? upper) === null) return null;
  return <span class="criterion">limit analysis: {formatInterval(checkInterval(factor))}</span>;
}

/** Factors side by side with several methods. The interval of limit analysis comes last, unless it governs. */
function MainFactors({ factors, proven }: { factors: Factor[]; proven: Factor | undefined }) {
  const governs = proven?.main === true;
  const shown = [...(proven && governs ? [proven] : []), ...factors, ...(proven && !governs ? [proven] : [])];
  const fails = governs ? isBelow(proven) : factors.some(isBelow);
  return (
    <div class={governs ? "main-factor several by-proof" : "main-factor several"}>
      <dl>
        {shown.map((factor) => (
          <MethodValue key={factor.name} factor={factor} />
        ))}
      </dl>
      <Label fails={fails} />
    </div>
  );
}

/** The one factor, or the interval of a run with limit analysis only. */
function MainFactor({ factor }: { factor: Factor }) {
  const fails = isBelow(factor);
  const isProven = factor.method === "bounds";
  return (
    <div class="main-factor">
      <p class="number">
        {isProven ? (
          <Interval factor={factor} />
        ) : (
          <span class={fails ? "value bad" : "value"}>{formatFactor(check(factor.value))}</span>
        )}
        {!isProven && (factor.lower ?? factor.upper) !== null && (
          <span class="bracket">
            {factor.method === "lem" && "limit analysis: "}
            {formatInterval(checkInterval(factor))}
          </span>
        )}
      </p>
      <Label fails={fails} factor={factor} />
    </div>
  );
}

/** The table of the answer: all criteria of MPM alone, a selection with several methods. */
function Factors({ factors }: { factors: Factor[] }) {
  const { shown, folded } = splitFactors(factors);
  return (
    <>
      <FactorTable
        factors={shown}
        among={factors}
        caption="Factor of safety by each criterion, with its interval, or the bracket that its search ended with"
      />
      {folded.length > 0 && (
        <details class="more-factors no-print">
          <summary>{formatCount(folded.length, "more factor", "more factors")} of safety</summary>
          <FactorTable factors={folded} among={factors} caption="The other factors of safety" />
          <p>
            With computing times and notes: <a href="#compared">Methods beside each other</a>.
          </p>
        </details>
      )}
    </>
  );
}

/** Results that are shown first on small screens. */
const wanted = [
  "moved_volume",
  "largest_displacement",
  "failure_time",
  "toe_distance",
  "front_advance",
  "crest_retreat",
  "rest_time",
  "largest_suction",
  "largest_pressure",
];

/** One yield acceleration is enough here: that of the surface that governs, which no method is named with. */
const isOtherAcceleration = ({ kind, by }: ShownResult) => kind === "yield_acceleration" && by !== "";

/** The results that are not factors, those named above first. */
function pickResults(results: ShownResult[], most: number): ShownResult[] {
  const rank = ({ quantity }: ShownResult) => {
    const found = wanted.indexOf(quantity);
    return found < 0 ? wanted.length : found;
  };
  // With other methods the stages only prepare the strength reduction, and the mesh is stated below.
  const beside = (findMethods(report.value)?.asked.length ?? 1) > 1;
  const isAside = ({ kind }: ShownResult) => beside && (kind === "stage" || kind === "mesh");
  return keepFurthestOfStages(
    results.filter((result) => result.kind !== "factor" && !isOtherAcceleration(result) && !isAside(result)),
  )
    .sort((a, b) => rank(a) - rank(b))
    .slice(0, most);
}

function Results({ results, large }: { results: ShownResult[]; large: boolean }) {
  return (
    <dl class={large ? "results large" : "results"}>
      {results.map((result) => (
        <div key={result.name}>
          <dt>{result.title}</dt>
          <dd>
            {result.text ??
              (result.value === null ? "not determined" : formatQuantity(result.value, result.unit, 3, true))}
          </dd>
        </div>
      ))}
    </dl>
  );
}

/** Sentences before the table; the others are folded, and are listed in the report for signature. */
const mostWords = 3;

function MoreWords({ sentences }: { sentences: string[] }) {
  const shown = sentences.slice(0, mostWords - 1);
  const folded = sentences.slice(mostWords - 1);
  return (
    <>
      {shown.length > 0 && <p class="more-words">{shown.join(" ")}</p>}
      {folded.length > 0 && (
        <details class="more-factors no-print">
          <summary>{formatCount(folded.length, "more sentence", "more sentences")}</summary>
          <ul class="more-words listed">
            {folded.map((text) => (
              <li key={text}>{text}</li>
            ))}
          </ul>
        </details>
      )}
    </>
  );
}

export function Answer() {
  const { answer, result } = report.value;
  // The governing one comes first.
  const mains = answer.factors
    .filter((factor) => factor.main && factor.value !== null)
    .sort((a, b) => a.value! - b.value!);
  const main = mains[0];
  const proven = answer.factors.find(
    ({ method, lower, upper }) => method === "bounds" && (lower !== null || upper !== null),
  );
  const results = pickResults(answer.results, main ? 4 : 6);
  const disagreement = result.disagreement?.text;
  const [first, ...others] = answer.sentences.filter((text) => text !== disagreement).flatMap(splitSentences);
  return (
    <section id="answer" class="answer" aria-labelledby="answer-title" tabIndex={-1}>
      <h2 id="answer-title" class="unseen">
        Answer
      </h2>
      {disagreement && <p class="disagreement">{disagreement}</p>}
      {mains.length > 1 || (main && proven) ? (
        <MainFactors factors={mains} proven={proven} />
      ) : (
        (main ?? proven) && <MainFactor factor={(main ?? proven)!} />
      )}
      {first && <p class={main || proven ? "in-words" : "in-words only"}>{first}</p>}
      <MoreWords sentences={others} />
      {answer.factors.length > 0 && <Factors factors={answer.factors} />}
      {results.length > 0 && <Results results={results} large={!main && !proven} />}
      <Warnings />
    </section>
  );
}
