/** The uncertain numbers: as asked, as sampled, and how the factor follows them. */
import { formatNumber } from "../charts/base/numbers";
import type { Sampling } from "../contract";
import { formatUnit } from "../page/format";
import { Scroller } from "../page/Scroller";
import { showName } from "./names";

export function NumbersTable({ sampling }: { sampling: Sampling }) {
  const { numbers, correlations } = sampling;
  const ranks = sampling.ranks ?? [];
  const name = (key: string) => showName(numbers.find((n) => n.key === key)?.name ?? key);
  const rank = (key: string) => ranks.find((r) => r.key === key)?.coefficient ?? null;
  return (
    <figure class="chart-figure" aria-label="Uncertain numbers">
      <h4>Uncertain numbers</h4>
      <Scroller class="chart-scroll" label="Uncertain numbers">
        <table class="chart-table">
          <thead>
            <tr>
              <th scope="col">Number</th>
              <th scope="col">Distribution</th>
              <th scope="col" class="chart-number">
                Sampled mean
              </th>
              <th scope="col" class="chart-number">
                deviation
              </th>
              <th scope="col" class="chart-number">
                from
              </th>
              <th scope="col" class="chart-number">
                to
              </th>
              {ranks.length > 0 && (
                <th scope="col" class="chart-number chart-wrap">
                  Rank correlation with F
                </th>
              )}
            </tr>
          </thead>
          <tbody>
            {numbers.map((n) => (
              <tr key={n.key}>
                <th scope="row">
                  {showName(n.name)}
                  {n.unit && ` [${formatUnit(n.unit)}]`}
                  <div class="chart-missing">{n.key}</div>
                </th>
                <td>{n.text}</td>
                <td class="chart-number">{formatNumber(n.sampled.mean, 4)}</td>
                <td class="chart-number">{formatNumber(n.sampled.deviation, 3)}</td>
                <td class="chart-number">{formatNumber(n.sampled.smallest, 4)}</td>
                <td class="chart-number">{formatNumber(n.sampled.largest, 4)}</td>
                {ranks.length > 0 && <td class="chart-number">{formatNumber(rank(n.key), 2)}</td>}
              </tr>
            ))}
          </tbody>
        </table>
      </Scroller>
      {correlations.map((c) => (
        <p key={c.keys.join()} class="chart-note">
          Correlation of {c.keys.map(name).join(" and ")}: {formatNumber(c.asked, 3)} asked,{" "}
          {formatNumber(c.sampled, 3)} sampled.
        </p>
      ))}
    </figure>
  );
}
