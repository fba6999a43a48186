// SPDX-License-Identifier: MIT
/** The paragraphs of the methods section: which there are, in which order, with equations and references numbered. */
import { writeLimitAnalysis } from "./bounds";
import { writeElementReduction, writeFiniteElements } from "./elements";
import { writeDisplacementCurve, writeFrozenFactor, writeStrengthReduction } from "./factor";
import { writeDamping, writeMassScaling, writeMaterialPoints, writeRunout, writeTimeStep } from "./motion";
import { writeExternalModel, writeModifiedCamClay, writeRootCohesion, writeRootedCamClay } from "./roots";
import { references, type ReferenceKey } from "./references";
import { writeSampling } from "./sampling";
import {
  writeLinearElastic,
  writeMixedIntegration,
  writeMohrCoulomb,
  writePointIntegration,
  writeStableSmoothing,
  writeStrainSmoothing,
} from "./soil";
import {
  writeBishop,
  writeFellenius,
  writeForceEquilibrium,
  writeJanbu,
  writeLimitEquilibrium,
  writeMorgensternPrice,
  writePartialFactors,
  writeSlipSearch,
  writeSpencer,
  writeYieldAcceleration,
} from "./slices";
import { writeRapidDrawdown } from "./drawdown";
import {
  writeHeldPressures,
  writeHydraulicConditions,
  writePressureSmoothing,
  writeSeeping,
  writeSoilWater,
  writeSteadySeepage,
  writeTwoPhase,
  writeWaterStorage,
} from "./water";
import type { Writer } from "./writer";
import type { MethodParagraph, Report } from "../../contract";

const writers: { method: MethodParagraph; title: string; write: Writer }[] = [
  { method: "limit_equilibrium", title: "Limit equilibrium (methods of slices)", write: writeLimitEquilibrium },
  { method: "fellenius", title: "Fellenius", write: writeFellenius },
  { method: "bishop", title: "Bishop", write: writeBishop },
  { method: "janbu", title: "Janbu", write: writeJanbu },
  { method: "spencer", title: "Spencer", write: writeSpencer },
  { method: "morgenstern_price", title: "Morgenstern–Price", write: writeMorgensternPrice },
  { method: "force_equilibrium", title: "Equilibrium of forces", write: writeForceEquilibrium },
  { method: "slip_search", title: "Search for the critical surface", write: writeSlipSearch },
  { method: "rapid_drawdown", title: "Rapid drawdown", write: writeRapidDrawdown },
  { method: "yield_acceleration", title: "Yield acceleration", write: writeYieldAcceleration },
  { method: "finite_elements", title: "Finite elements (FEM)", write: writeFiniteElements },
  { method: "finite_element_reduction", title: "Strength reduction by FEM", write: writeElementReduction },
  { method: "limit_analysis", title: "Limit analysis", write: writeLimitAnalysis },
  { method: "sampling", title: "Uncertain numbers", write: writeSampling },
  { method: "partial_factors", title: "Partial factors", write: writePartialFactors },
  { method: "material_point_method", title: "Material point method", write: writeMaterialPoints },
  { method: "two_phase", title: "Soil and pore water", write: writeTwoPhase },
  { method: "water_storage", title: "Storage of water and pore pressure", write: writeWaterStorage },
  { method: "seeping", title: "Soil that water seeps through", write: writeSeeping },
  { method: "time_step", title: "Time step", write: writeTimeStep },
  { method: "mixed_integration", title: "Mixed integration", write: writeMixedIntegration },
  { method: "point_integration", title: "Integration over points", write: writePointIntegration },
  { method: "strain_smoothing", title: "Smoothing of volumetric strain", write: writeStrainSmoothing },
  { method: "stable_smoothing", title: "Stable smoothing", write: writeStableSmoothing },
  { method: "pressure_smoothing", title: "Smoothing of pore pressures", write: writePressureSmoothing },
  { method: "local_damping", title: "Local damping", write: writeDamping },
  { method: "mass_scaling", title: "Mass scaling", write: writeMassScaling },
  { method: "mohr_coulomb", title: "Mohr–Coulomb model", write: writeMohrCoulomb },
  { method: "root_cohesion", title: "Cohesion of roots", write: writeRootCohesion },
  { method: "modified_cam_clay", title: "Modified Cam-clay", write: writeModifiedCamClay },
  { method: "rooted_cam_clay", title: "Rooted Cam-clay", write: writeRootedCamClay },
  { method: "external_model", title: "External model", write: writeExternalModel },
  { method: "linear_elastic", title: "Linear elastic model", write: writeLinearElastic },
  { method: "soil_water", title: "Effective stress, retention and conductivity", write: writeSoilWater },
  { method: "steady_seepage", title: "Steady seepage at the start", write: writeSteadySeepage },
  { method: "hydraulic_conditions", title: "Hydraulic conditions", write: writeHydraulicConditions },
  { method: "held_pressures", title: "Held pore pressures", write: writeHeldPressures },
  { method: "strength_reduction", title: "Strength reduction", write: writeStrengthReduction },
  { method: "frozen_factor", title: "Rest or run-away at frozen geometry", write: writeFrozenFactor },
  { method: "displacement_curve", title: "Criteria on the displacement curve", write: writeDisplacementCurve },
  { method: "runout", title: "Runout", write: writeRunout },
];

/** A piece of running text. */
export type Piece = { kind: "text" | "math" | "cite"; text: string };
export type NumberedBlock = { pieces: Piece[] } | { tex: string; plain: string; number: number };

export interface Paragraph {
  method: MethodParagraph;
  title: string;
  blocks: NumberedBlock[];
}

/** Cuts a text at its formulas and references; references become their numbers, "[1, 2]". */
export function cutText(text: string, numberOf: (key: ReferenceKey) => number): Piece[] {
  return text
    .split(/(\$[^$]+\$|\[@[^\]]+\])/)
    .filter(Boolean)
    .map((piece): Piece => {
      if (piece.startsWith("$")) return { kind: "math", text: piece.slice(1, -1) };
      if (!piece.startsWith("[@")) return { kind: "text", text: piece };
      const keys = piece
        .slice(1, -1)
        .split(";")
        .map((key) => key.trim().slice(1) as ReferenceKey);
      return { kind: "cite", text: keys.map(numberOf).join(", ") };
    });
}

/** The paragraphs that apply to this report, and the references in the order in which they are first named. */
export function writeMethods(report: Report): { paragraphs: Paragraph[]; cited: string[] } {
  const cited: ReferenceKey[] = [];
  const numberOf = (key: ReferenceKey) => {
    if (!cited.includes(key)) cited.push(key);
    return cited.indexOf(key) + 1;
  };
  let equations = 0;
  const paragraphs = writers
    .filter(({ method }) => report.methods.includes(method))
    .map(({ method, title, write }) => ({
      method,
      title,
      blocks: write(report).map((block): NumberedBlock =>
        "text" in block ? { pieces: cutText(block.text, numberOf) } : { ...block, number: ++equations },
      ),
    }));
  return { paragraphs, cited: cited.map((key) => references[key]) };
}
