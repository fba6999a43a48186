// SPDX-License-Identifier: MIT
/** The page: the answer first, then its basis; over material points it opens where slip surfaces of other methods can be compared. */
import { effect } from "@preact/signals";
import { useState } from "preact/hooks";

import { findRestLimits, judgeTrial } from "../charts/curve/curveData";
import { findMethods } from "../compared/methodTable";
import type { Report } from "../contract";
import { fieldName, frameIndex, report, sequenceIndex } from "../state";
import { limitMode } from "../viewer/settings";
import { Guard, Lazy, Part } from "./Part";
import { TitleBlock, TitleLine } from "./TitleLine";
import { TopBar } from "./TopBar";
import { listSections, type Section } from "./sections";

/**
 * The trial of the displacement curve that shows the mechanism: of those above the main factor of MPM
 * the first that does not come to rest, else the first. Null for MPM alone, and without such a trial.
 */
export function findMechanism(given: Report): { sequence: number; frame: number } | null {
  if (!findMethods(given)?.surfaces.some((s) => s.method !== "mpm")) return null;
  const main = given.answer.factors.find((f) => f.method === "mpm" && f.main)?.value;
  const sequence = given.sequences.findIndex((s) => s.kind === "curve");
  if (main === null || main === undefined || sequence < 0) return null;
  const limits = findRestLimits(given.result.input, given.model.slope_height);
  const moves = (factor: number) => {
    const point = given.result.curve?.points.find((p) => Math.abs(p.srf - factor) < 1e-9);
    return point !== undefined && judgeTrial(point, limits) !== "rest";
  };
  const above = given.sequences[sequence]!.frames
    .map(({ factor }, frame) => ({ factor: factor ?? 0, frame }))
    .filter(({ factor }) => factor > main)
    .sort((a, b) => a.factor - b.factor);
  const chosen = above.find(({ factor }) => moves(factor)) ?? above[0];
  return chosen ? { sequence, frame: chosen.frame } : null;
}

/** Before the viewer is drawn, which keeps what it finds chosen. */
function openAtMechanism(given: Report): void {
  const found = findMechanism(given);
  if (!found) return;
  sequenceIndex.value = found.sequence;
  frameIndex.value = found.frame;
  // Limits over all trials are the strains of the failed ones, next to which a slip band is pale. Another sequence has its
  // usual limits again.
  const usual = limitMode.value;
  limitMode.value = "frame";
  const stop = effect(() => {
    if (sequenceIndex.value === found.sequence) return;
    if (limitMode.peek() === "frame") limitMode.value = usual;
    queueMicrotask(() => stop());
  });
  const fields = given.sequences[found.sequence]!.fields.map((f) => f.name);
  if (!fields.includes(fieldName.value)) fieldName.value = fields[0] ?? "";
}

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
