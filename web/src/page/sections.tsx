// SPDX-License-Identifier: MIT
/** The sections of the page in their order: what each is called, when a report has it, and what draws it. */
import type { ComponentChildren } from "preact";

import { BarsSection } from "../bars/BarsSection";
import { listBarTables } from "../bars/barData";
import { BoundsSection } from "../bounds/BoundsSection";
import "../charts/charts.css";
import { CurveSection } from "../charts/curve/CurveSection";
import { HistorySection } from "../charts/history/HistorySection";
import { CalibrationSection } from "../charts/laboratory/CalibrationSection";
import { PointSection } from "../charts/laboratory/PointSection";
import { ProfileSection } from "../charts/profile/ProfileSection";
import { StrengthSection } from "../charts/strength/StrengthSection";
import { StudySection } from "../charts/study/StudySection";
import { SoilWaterSection } from "../charts/water/SoilWaterSection";
import { CompareSection, listComparisons } from "../charts/compare/CompareSection";
import { MethodsSection } from "../compared/MethodsSection";
import { findMethods } from "../compared/methodTable";
import { Overview } from "../compared/Overview";
import { ConstructionSection } from "../construction/ConstructionSection";
import type { Report } from "../contract";
import { ElementsSection } from "../elements/ElementsSection";
import { SamplingSection } from "../sampling/SamplingSection";
import { SlicesSection } from "../slices/SlicesSection";
import { report } from "../state";
import { TimelinePane } from "../timeline/TimelinePane";
import { TimelineSection } from "../timeline/TimelineSection";
import { Viewer } from "../viewer/Viewer";
import { FlowSection } from "../water/FlowSection";
import { WaterSection } from "../water/WaterSection";
import { Answer } from "./Answer";
import { InputPart } from "./InputPart";
import { MethodsPart } from "./methods/MethodsPart";
import { ProvenancePart } from "./ProvenancePart";
import { Statement } from "./statement/Statement";
import { Variants } from "./Variants";

export interface Section {
  id: string;
  /** In the contents, short. */
  label: string;
  has: (given: Report) => boolean;
  draw: () => ComponentChildren;
  /** Of a chart, which is drawn when it comes into sight: its heading, and about what it takes [px]. */
  chart?: { title: string; height: number };
}

/** The first figure: the history of a timeline, the motion by MPM, or the section. */
function drawFirstFigure() {
  if (report.value.timeline) return <TimelinePane />;
  return report.value.sequences.length > 0 ? <Viewer /> : <Overview />;
}

/** Of a study the section of its case, without surfaces. */
function hasSection(given: Report): boolean {
  const { dimension, polygons } = given.model;
  const hasSurfaces = (findMethods(given)?.surfaces.length ?? 0) > 0;
  const hasFields = given.reduction?.fields !== undefined;
  const hasSoil = given.kind === "study" && polygons.length > 0;
  return given.sequences.length > 0 || (dimension === 2 && (hasSurfaces || hasFields || hasSoil));
}

const hasTableOf = (given: Report, ...kinds: string[]) => given.tables.some(({ kind }) => kinds.includes(kind));
const hasVariants = ({ study_result: study }: Report) => (study?.variants.length ?? 0) > 0;
const always = () => true;

const sections: Section[] = [
  { id: "answer", label: "Answer", has: always, draw: () => <Answer /> },
  { id: "section", label: "Section", has: hasSection, draw: drawFirstFigure },
  {
    id: "sampling",
    label: "Sampling",
    has: ({ study_result: study }) => study?.sampling !== undefined,
    draw: () => <SamplingSection />,
    chart: { title: "Uncertain numbers", height: 1200 },
  },
  {
    id: "study",
    label: "Study",
    has: hasVariants,
    draw: () => <StudySection />,
    chart: { title: "Study", height: 600 },
  },
  { id: "variants", label: "Variants", has: hasVariants, draw: () => <Variants /> },
  {
    id: "timeline",
    label: "Timeline",
    has: ({ timeline }) => timeline !== undefined,
    draw: () => <TimelineSection />,
    chart: { title: "Factor of safety in time", height: 500 },
  },
  {
    id: "construction",
    label: "Construction",
    has: ({ result }) => result.construction !== undefined,
    draw: () => <ConstructionSection />,
    chart: { title: "Stages of construction", height: 1100 },
  },
  {
    id: "compared",
    label: "Methods compared",
    has: (given) => findMethods(given) !== undefined,
    draw: () => <MethodsSection />,
    chart: { title: "Methods compared", height: 500 },
  },
  {
    id: "slices",
    label: "LEM",
    has: ({ result }) => result.lem !== undefined,
    draw: () => <SlicesSection />,
    chart: { title: "Limit equilibrium (LEM)", height: 1600 },
  },
  {
    id: "elements",
    label: "FEM",
    has: ({ result, reduction }) => result.fem !== undefined || reduction !== undefined,
    draw: () => <ElementsSection />,
    chart: { title: "Finite elements (FEM)", height: 1400 },
  },
  {
    id: "bounds",
    label: "Limit analysis",
    has: ({ result }) => result.bounds !== undefined,
    draw: () => <BoundsSection />,
    chart: { title: "Limit analysis: lower and upper bound", height: 900 },
  },
  {
    id: "supports",
    label: "Supports",
    has: (given) => listBarTables(given).length > 0,
    draw: () => <BarsSection />,
    chart: { title: "Supports in FEM and MPM", height: 700 },
  },
  {
    id: "curve",
    label: "Curve",
    has: ({ result }) => result.curve !== undefined,
    draw: () => <CurveSection />,
    chart: { title: "Displacement over strength reduction factor", height: 560 },
  },
  {
    id: "histories",
    label: "Histories",
    has: (given) => hasTableOf(given, "history", "monitors"),
    draw: () => <HistorySection />,
    chart: { title: "Histories", height: 1000 },
  },
  {
    id: "profiles",
    label: "Profiles",
    has: (given) =>
      given.kind !== "study" &&
      (given.sequences.length > 0 || hasTableOf(given, "ground") || (given.sections ?? []).length > 0),
    draw: () => <ProfileSection />,
    chart: { title: "Profiles", height: 900 },
  },
  {
    id: "pore-water",
    label: "Pore water",
    // Without MPM the section itself shows it.
    has: ({ model, sequences, result }) =>
      model.water_mesh !== undefined && (sequences.length > 0 || result.flow !== undefined),
    draw: () => <WaterSection />,
    chart: { title: "Pore water", height: 620 },
  },
  {
    id: "flow",
    label: "Seepage",
    has: ({ result }) => (result.flow?.states.length ?? 0) > 0,
    draw: () => <FlowSection />,
    chart: { title: "Seepage: discharge, exit gradients, uplift and heave", height: 700 },
  },
  {
    id: "strength",
    label: "Strength",
    has: ({ kind, model }) => kind !== "study" && model.materials.some((m) => m.strength),
    draw: () => <StrengthSection />,
    chart: { title: "Strength of the soils", height: 330 },
  },
  {
    id: "water",
    label: "Water",
    has: ({ water, model }) => water !== undefined && model.materials.some((m) => m.water),
    draw: () => <SoilWaterSection />,
    chart: { title: "Soil water: retention and conductivity", height: 380 },
  },
  {
    id: "calibration",
    label: "Calibration",
    has: ({ calibration }) => calibration !== undefined,
    draw: () => <CalibrationSection />,
    chart: { title: "Calibration of the soils", height: 900 },
  },
  {
    id: "tests",
    label: "Tests",
    has: ({ point_tests: tests }) => tests !== undefined,
    draw: () => <PointSection />,
    chart: { title: "Element tests of the soils", height: 900 },
  },
  {
    id: "comparison",
    label: "Comparison",
    has: (given) => listComparisons(given).length > 0,
    draw: () => <CompareSection />,
    chart: { title: "Comparison with published values", height: 320 },
  },
  { id: "statement", label: "Report", has: always, draw: () => <Statement /> },
  { id: "methods", label: "Methods", has: ({ methods }) => methods.length > 0, draw: () => <MethodsPart /> },
  { id: "input", label: "Input", has: always, draw: () => <InputPart /> },
  { id: "provenance", label: "Provenance", has: always, draw: () => <ProvenancePart /> },
];

/** The sections that this report has. */
export const listSections = (given: Report): Section[] => sections.filter(({ has }) => has(given));
