// SPDX-License-Identifier: MIT
#include "input/case/case.hpp"

#include "input/case/compare.hpp"
#include "input/case/support.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, Case& c) {
  v.key("format", c.format, plain().at_least(1),
        "Which form of the case file this is. Programs for earlier forms only stop with a message. Without it the "
        "file has form 1.");
  v.key("title", c.title, plain().example(R"("Dry homogeneous slope")"), "Title of the case in reports and plots.");
  v.key("unusual", c.unusual, plain().example(R"(["materials.peat.unit_weight"])"),
        "Keys or blocks that are unusual on purpose: their warnings are not repeated. The paths are those of "
        "the warnings.");
  v.table("project", c.project, "The title block of the report.");
  v.table("geometry", GeometryBlock{c.mesh, c.layering}, "The section: regions of soil in a background box.");
  v.table("mesh", MeshBlock{c.mesh, c.points_per_element, c.softening_length},
          "The background mesh and the material points in it.");
  v.named("materials", c.materials, "sand", 1, "A material, under a name of your choice.");
  v.entries("regions", c.regions, "soil", 1, plain().required().example(R"("sand")"), "Material of a region.");
  v.named(
      "support", c.supports, "nails", 0,
      "Bars in the soil under a name of your choice: nails, anchors, bolts, geosynthetics and piles. Resistances are "
      "those of one bar, of geosynthetics per metre of width; results are per metre of slope.");
  v.tables("boundary", c.boundaries, 3, "What holds or moves a side or a line. Sides without one are free.");
  v.tables("traction", c.tractions, 0, "A load on a side or a line.");
  v.table("water", c.water, "The pore water, for soils that have any.");
  v.tables("hydraulic", c.hydraulics, 0,
           "The hydraulic condition on a side or a line. Without one no water passes sides that a [[boundary]] holds, "
           "and, in seepage, the base and the outer sides of the model; the rest of the surface is a seepage face.");
  v.tables("roots", c.roots, 0,
           "Roots under a named line of the ground, as a function of depth. Several blocks add up. Where none reaches, "
           "the content or cohesion of the material counts.");
  v.table("gravity", c.gravity, "Gravity.");
  v.table("initial", c.initial, "The state at the start.");
  v.table("seepage", c.seepage,
          "Flow of water alone, with [analysis] methods = [\"seepage\"]: discharges, exit gradients, and the safety "
          "against uplift and heave.");
  v.optional_table("timeline", c.timeline,
                   "The factor of safety through time: transient seepage from time 0 on, and a search for the critical "
                   "slip surface at many times.");
  v.tables("construction", c.construction, 0,
           "A stage of construction, computed by FEM with the consolidation of the soil: regions, loads and supports "
           "come and go. Stages follow one another from time 0 on; the factor of safety is found at their ends.");
  v.table("consolidation", c.consolidation, "Time steps of the stages of construction.");
  v.tables("vertical_drains", c.drains, 0,
           "Vertical drains in the soil of the stages, as sinks of equal strain after Hansbo (1981), without well "
           "resistance.");
  v.tables("stage", c.stages, 1, "A period of time. Stages follow one another; at least one is needed.");
  v.table("rest", c.rest, "When the soil counts as being at rest, for stages with until = \"rest\".");
  v.table("analysis", AnalysisBlock{c.analysis, c.methods}, "What is calculated.");
  v.table("strength_reduction", c.strength_reduction, "Factor of safety by MPM.");
  v.table("lem", c.lem, "Limit equilibrium (LEM): methods of slices, and the search for the critical slip surface.");
  v.table("fem", c.fem,
          "FEM: strength reduction on quadratic elements at small strain. Where there is no [[boundary]] (and no "
          "\"mpm\" among the methods), the bottom of the section is fixed, and its other sides are on rollers.");
  v.table(
      "bounds", c.bounds,
      "Limit analysis: lower and upper bound of the factor of safety of a plane section for ψ = φ. Where there is no "
      "[[boundary]], the section is fixed as for FEM.");
  v.tables("surcharge", c.surcharges, 0,
           "A vertical load on the ground. A vertical [[traction]] on a line of the ground does the same.");
  v.tables(
      "slurry", c.slurries, 0,
      "A liquid of its own density on the ground, such as bentonite in a trench: it presses on the ground that it "
      "covers, vertical faces too, and does not enter the soil. Ponds of water follow from water tables and heads.");
  v.table("earthquake", c.earthquake, "A pseudo-static acceleration.");
  v.table("partial_factors", c.partial_factors,
          "Partial factors of Eurocode 7: the factor of safety becomes the degree of over-design, which is to be at "
          "least 1.");
  v.table("output", c.output, "What is stored, and the units of tables and plots.");
  v.tables("compare", c.compare, 0, "A published or measured value with which the report compares a result.");
  v.tables("test", c.tests, 0, "An element test: one point of soil without a mesh, for `talus point`.");
  v.optional_table("calibration", c.calibration,
                   "What `talus calibrate` fits: numbers of the materials, and the measured curves that the element "
                   "tests are to meet.");
  v.table("study", c.study, "What `talus study` varies.");
}

}  // namespace talus::input
