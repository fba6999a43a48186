// SPDX-License-Identifier: MIT
/** The page: the answer first, then its basis. */
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";

import { report } from "../state";
import {
  CalibrationSection,
  CompareSection,
  CurveSection,
  HistorySection,
  PointSection,
  ProfileSection,
  SoilWaterSection,
  StudySection,
} from "../charts/Charts";
import { MethodsSection } from "../compared/MethodsSection";
import { Overview } from "../compared/Overview";
import { BoundsSection } from "../bounds/BoundsSection";
import { ElementsSection } from "../elements/ElementsSection";
import { TimelinePane } from "../timeline/TimelinePane";
import { TimelineSection } from "../timeline/TimelineSection";
import { SamplingSection } from "../sampling/SamplingSection";
import { SlicesSection } from "../slices/SlicesSection";
import { Viewer } from "../viewer/Viewer";
import { WaterSection } from "../water/WaterSection";
import { Answer } from "./Answer";
import { listContents } from "./contents";
import { Guard } from "./Guard";
import { InputPart } from "./InputPart";
import { Lazy } from "./Lazy";
import { MethodsPart } from "./methods/MethodsPart";
import { openAtMechanism } from "./opening";
import { Part } from "./Part";
import { ProvenancePart } from "./ProvenancePart";
import { Statement } from "./statement/Statement";
import { TitleBlock } from "./statement/TitleBlock";
import { TitleLine } from "./TitleLine";
import { TopBar } from "./TopBar";
import { Variants } from "./Variants";

/** The first figure: the history of a timeline, the motion of material points, or the section. */
function drawFirstFigure() {
  if (report.value.timeline) return <TimelinePane />;
  return report.value.sequences.length > 0 ? <Viewer /> : <Overview />;
}

function SectionPane() {
  const is3d = report.value.model.dimension === 3;
  return (
    <section id="section" class="section-pane" aria-labelledby="section-title" tabIndex={-1}>
      <h2 id="section-title" class="unseen">
        {is3d ? "The slope in three dimensions" : "Section through the slope"}
      </h2>
      <Guard what="The section">
        <Lazy height={report.value.timeline ? 900 : 520}>{drawFirstFigure}</Lazy>
      </Guard>
    </section>
  );
}

interface ChartProps {
  id: string;
  title: string;
  /** As in "The curve cannot be shown". */
  what: string;
  /** About what it takes [px]. */
  height: number;
  draw: () => ComponentChildren;
}

function ChartPart({ id, title, what, height, draw }: ChartProps) {
  return (
    <Part id={id} title={title} chart>
      <Guard what={what}>
        <Lazy height={height}>{draw}</Lazy>
      </Guard>
    </Part>
  );
}

export function Page() {
  useState(() => openAtMechanism(report.value));
  const entries = listContents(report.value);
  const has = (id: string) => entries.some((entry) => entry.id === id);
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
        <div class={has("section") ? "first-screen" : "first-screen alone"}>
          <Answer />
          {has("section") && <SectionPane />}
        </div>
        {has("sampling") && (
          <ChartPart
            id="sampling"
            title="Uncertain numbers"
            what="The sampling"
            height={1200}
            draw={() => <SamplingSection />}
          />
        )}
        {has("study") && (
          <ChartPart id="study" title="Study" what="The study" height={600} draw={() => <StudySection />} />
        )}
        {has("variants") && <Variants />}
        {has("timeline") && (
          <ChartPart
            id="timeline"
            title="Factor of safety in time"
            what="The factor in time"
            height={500}
            draw={() => <TimelineSection />}
          />
        )}
        {has("compared") && (
          <ChartPart
            id="compared"
            title="Methods beside each other"
            what="The comparison of the methods"
            height={500}
            draw={() => <MethodsSection />}
          />
        )}
        {has("slices") && (
          <ChartPart id="slices" title="Slices" what="The part on slices" height={1600} draw={() => <SlicesSection />} />
        )}
        {has("elements") && (
          <ChartPart
            id="elements"
            title="Finite elements"
            what="The part on finite elements"
            height={1400}
            draw={() => <ElementsSection />}
          />
        )}
        {has("bounds") && (
          <ChartPart
            id="bounds"
            title="Proven bounds"
            what="The part on proven bounds"
            height={900}
            draw={() => <BoundsSection />}
          />
        )}
        {has("curve") && (
          <ChartPart
            id="curve"
            title="Displacement over strength reduction factor"
            what="The curve"
            height={560}
            draw={() => <CurveSection />}
          />
        )}
        {has("histories") && (
          <ChartPart
            id="histories"
            title="Histories"
            what="The histories"
            height={1000}
            draw={() => <HistorySection />}
          />
        )}
        {has("profiles") && (
          <ChartPart id="profiles" title="Profiles" what="The profiles" height={900} draw={() => <ProfileSection />} />
        )}
        {has("pore-water") && (
          <ChartPart
            id="pore-water"
            title="Pore water at the start"
            what="The pore water"
            height={620}
            draw={() => <WaterSection />}
          />
        )}
        {has("water") && (
          <ChartPart
            id="water"
            title="Soil water: retention and conductivity"
            what="The curves of the soil water"
            height={380}
            draw={() => <SoilWaterSection />}
          />
        )}
        {has("calibration") && (
          <ChartPart
            id="calibration"
            title="Calibration of the soils"
            what="The calibration"
            height={900}
            draw={() => <CalibrationSection />}
          />
        )}
        {has("tests") && (
          <ChartPart
            id="tests"
            title="Element tests of the soils"
            what="The element tests"
            height={900}
            draw={() => <PointSection />}
          />
        )}
        {has("comparison") && (
          <ChartPart
            id="comparison"
            title="Comparison with published values"
            what="The comparison"
            height={320}
            draw={() => <CompareSection />}
          />
        )}
        <Guard what="The report for signature">
          <Statement />
        </Guard>
        {has("methods") && (
          <Guard what="The methods">
            <MethodsPart />
          </Guard>
        )}
        <Guard what="The input">
          <InputPart />
        </Guard>
        <Guard what="The provenance">
          <ProvenancePart />
        </Guard>
      </main>
      <footer class="foot">
        <p>
          Made from results of Talus{` ${report.value.result.provenance.version}`.trimEnd()}. Everything shown is in this file;
          it needs no network. The results files in the folder “{report.value.folder}” are in SI units, its
          tables in the units that their headers name.
        </p>
      </footer>
    </>
  );
}
