// SPDX-License-Identifier: MIT
/** The uncertain numbers: as specified, as sampled, and their effect on the factor. */
import { formatNumber } from "../charts/base/numbers";
import type { Sampling } from "../contract";
import { formatUnit } from "../page/format";
import { ChartTable } from "../page/DataTable";
import { showName } from "./names";

export function NumbersTable({ sampling }: { sampling: Sampling }) {
  const { correlations } = sampling;
  const ranks = sampling.ranks ?? [];
  const name = (key: string) => showName(sampling.numbers.find((n) => n.key === key)?.name ?? key);
  const rank = (key: string) => ranks.find((r) => r.key === key)?.coefficient ?? null;
  return (
    <figure class="chart-figure" aria-label="Uncertain numbers">
      <h4>Uncertain numbers</h4>
      <ChartTable
        label="Uncertain numbers"
        rows={sampling.numbers}
        columns={[
          [
            "Number",
            (n) => (
              <>
                {showName(n.name)}
                {n.unit && ` [${formatUnit(n.unit)}]`}
                <div class="chart-missing">{n.key}</div>
              </>
            ),
            "name",
          ],
          ["Distribution", (n) => n.text],
          ["Sampled mean", (n) => formatNumber(n.sampled.mean, 4), "number"],
          ["deviation", (n) => formatNumber(n.sampled.deviation, 3), "number"],
          ["from", (n) => formatNumber(n.sampled.smallest, 4), "number"],
          ["to", (n) => formatNumber(n.sampled.largest, 4), "number"],
          ranks.length > 0 && ["Rank correlation with F", (n) => formatNumber(rank(n.key), 2), "wrap"],
        ]}
      />
      {correlations.map((c) => (
        <p key={c.keys.join()} class="chart-note">
          Correlation of {c.keys.map(name).join(" and ")}: {formatNumber(c.asked, 3)} asked,{" "}
          {formatNumber(c.sampled, 3)} sampled.
        </p>
      ))}
    </figure>
  );
}
