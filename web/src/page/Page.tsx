// SPDX-License-Identifier: MIT
/** The page: the answer first, then its basis. */
import { useState } from "preact/hooks";

import { report } from "../state";
import { Guard, Lazy, Part } from "./Part";
import { openAtMechanism } from "./opening";
import { listSections, type Section } from "./sections";
import { TitleBlock, TitleLine } from "./TitleLine";
import { TopBar } from "./TopBar";

/** Beside the answer. */
function SectionPane({ section }: { section: Section }) {
  const { model, timeline } = report.value;
  return (
    <section id={section.id} class="section-pane" aria-labelledby="section-title" tabIndex={-1}>
      <h2 id="section-title" class="unseen">
        {model.dimension === 3 ? "The slope in three dimensions" : "Section through the slope"}
      </h2>
      <Guard what="The section">
        <Lazy height={timeline ? 900 : 520}>{section.draw}</Lazy>
      </Guard>
    </section>
  );
}

function SectionPart({ id, label, chart, draw }: Section) {
  const what = `The part “${chart?.title ?? label}”`;
  if (!chart) return <Guard what={what}>{draw()}</Guard>;
  return (
    <Part id={id} title={chart.title} chart>
      <Guard what={what}>
        <Lazy height={chart.height}>{draw}</Lazy>
      </Guard>
    </Part>
  );
}

export function Page() {
  useState(() => openAtMechanism(report.value));
  const all = listSections(report.value);
  const pane = all.find(({ id }) => id === "section");
  const [answer, ...others] = all.filter((section) => section !== pane);
  const { folder, model, result } = report.value;
  const entries = all.map(({ id, label }) => ({ id, label: id === "section" && model.dimension === 3 ? "View" : label }));
  return (
    <>
      <a class="skip-link" href="#main">
        Skip the contents
      </a>
      <TopBar entries={entries} />
      <main id="main" tabIndex={-1}>
        <TitleLine />
        <div class="print-only">
          <TitleBlock />
        </div>
        <div class={pane ? "first-screen" : "first-screen alone"}>
          {answer?.draw()}
          {pane && <SectionPane section={pane} />}
        </div>
        {others.map((section) => (
          <SectionPart key={section.id} {...section} />
        ))}
      </main>
      <footer class="foot">
        <p>
          Made from results of Talus{` ${result.provenance.version}`.trimEnd()}. Everything shown is in this file; it
          needs no network. The results files in the folder “{folder}” are in SI units, its tables in the units that
          their headers name.
        </p>
      </footer>
    </>
  );
}
