/** The answer: the factor of safety large, in words, beside other criteria; runout; warnings. */
import { report } from "../state";
import { FactorTable } from "./FactorTable";
import { formatFactor, formatQuantity, formatSentence } from "./format";
import { WarningLink, Warnings } from "./Warnings";
import type { Factor, NamedResult } from "../contract";

function MainFactor({ factor }: { factor: Factor }) {
  const fails = factor.value !== null && factor.value < 1;
  return (
    <div class="main-factor">
      <p class="number">
        <span class={fails ? "value bad" : "value"}>{formatFactor(factor.value)}</span>
        {factor.lower !== null && factor.upper !== null && (
          <span class="bracket">
            {formatFactor(factor.lower)} – {formatFactor(factor.upper)}
          </span>
        )}
      </p>
      <WarningLink />
      <p class="label">
        Factor of safety{fails && <strong class="bad">, below 1: the slope fails as it stands</strong>}
        <span class="criterion">{factor.title}</span>
      </p>
    </div>
  );
}

/** What an engineer asks for first, where there is no room for everything. */
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

/** The results that are not factors, those named above first. */
function pickResults(results: NamedResult[], most: number): NamedResult[] {
  const rank = (result: NamedResult) => {
    const last = result.name.split(".").at(-1) ?? "";
    const found = wanted.indexOf(last);
    return found < 0 ? wanted.length : found;
  };
  return results
    .filter((result) => !result.name.startsWith("factor_of_safety"))
    .sort((a, b) => rank(a) - rank(b))
    .slice(0, most);
}

function Results({ results, large }: { results: NamedResult[]; large: boolean }) {
  // "(runout at SRF 1.75)" behind every title: said once, above.
  const endings = results.map((result) => /\s*\(([^()]*)\)$/.exec(result.title)?.[1] ?? "");
  const shared = endings.length > 1 && endings.every((ending) => ending && ending === endings[0]) ? endings[0]! : "";
  return (
    <>
      {shared && <p class="small-head">{formatSentence(shared).slice(0, -1)}</p>}
      <dl class={large ? "results large" : "results"}>
        {results.map((result) => (
          <div key={result.name}>
            <dt>{shared ? result.title.replace(/\s*\([^()]*\)$/, "") : result.title}</dt>
            <dd>{formatQuantity(result.value, result.unit, 3, true)}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}

export function Answer() {
  const { answer } = report.value;
  const main = answer.factors.find((factor) => factor.main && factor.value !== null);
  const results = pickResults(answer.results, main ? 4 : 6);
  const [first, ...others] = answer.sentences;
  return (
    <section id="answer" class="answer" aria-labelledby="answer-title" tabIndex={-1}>
      <h2 id="answer-title" class="unseen">
        Answer
      </h2>
      {main && <MainFactor factor={main} />}
      {first && <p class={main ? "in-words" : "in-words only"}>{formatSentence(first)}</p>}
      {others.length > 0 && <p class="more-words">{others.map(formatSentence).join(" ")}</p>}
      {answer.factors.length > 0 && <FactorTable factors={answer.factors} />}
      {results.length > 0 && <Results results={results} large={!main} />}
      <Warnings />
    </section>
  );
}
