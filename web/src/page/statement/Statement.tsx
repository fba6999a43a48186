// SPDX-License-Identifier: MIT
/** The part to be signed: what was calculated, with what, how it came out, and how far to trust it. */
import type { ComponentChildren } from "preact";

import { report } from "../../state";
import { selectsMethod } from "../methods/settings";
import { formatSentence } from "../format";
import { Part } from "../Part";
import { WarningList } from "../Warnings";
import { GeometryTables, MaterialTable } from "./ModelTables";
import { ResultTables, StageTable, SupportTables } from "./RunTables";
import { TitleBlock } from "../TitleLine";
import { WaterResults, WaterTables } from "./WaterTables";

/** Two are side by side where they fit, unless one needs the whole width. */
function Block({ title, wide, children }: { title: string; wide?: boolean; children: ComponentChildren }) {
  return (
    <div class={wide ? "block wide" : "block"}>
      <h3>{title}</h3>
      {children}
    </div>
  );
}

export function Statement() {
  const { assumptions, kind, result, study_result: study, warnings, water } = report.value;
  const first = study?.variants[0]?.name;
  // LEM is sampled without a run that has its section.
  const isBare = study?.sampling !== undefined && Object.keys(result.input).length === 0;
  const hasSlope = kind !== "tests" && !isBare;
  const hasPoints = selectsMethod(report.value, "mpm");
  const lead =
    kind === "study" && first
      ? `The tables describe the variant “${first}”; the others differ from it in what the study varies.`
      : "The calculation in tables, to be checked, printed and signed.";
  return (
    <Part id="statement" title="Report" lead={lead} newPage>
      <div class="no-print">
        <TitleBlock />
      </div>
      <div class="blocks">
        {hasSlope && (
          <Block title="Geometry and water">
            <GeometryTables />
          </Block>
        )}
        {!isBare && (
          <Block title="Materials">
            <MaterialTable />
          </Block>
        )}
        {hasSlope && (
          <Block title={hasPoints ? "Supports, loads and monitors" : "Supports and loads"}>
            <SupportTables />
          </Block>
        )}
        {hasSlope && hasPoints && (
          <Block title="Stages">
            <StageTable />
          </Block>
        )}
        {water && (
          <Block title="Pore water">
            <WaterTables water={water} />
          </Block>
        )}
        {water && (
          <Block title={kind === "study" ? "Flow of water in the first variant" : "Flow of water"}>
            <WaterResults />
          </Block>
        )}
        {(hasSlope || isBare) && (
          <Block title="Results by method" wide>
            <ResultTables />
          </Block>
        )}
        <Block title="Assumptions and limits of validity">
          {assumptions.length === 0 ? (
            <p>None are stated.</p>
          ) : (
            <ol class="sentences">
              {assumptions.map((text, i) => (
                <li key={i}>{formatSentence(text)}</li>
              ))}
            </ol>
          )}
        </Block>
        <Block title="Warnings">
          {warnings.length === 0 ? <p>{result.status === "finished" ? "The calculation gave no warnings." : "No warnings so far."}</p> : <WarningList warnings={warnings} />}
        </Block>
      </div>
    </Part>
  );
}
