// SPDX-License-Identifier: MIT
#pragma once
// [analysis] and [strength_reduction]: methods of the case and the strength reduction by MPM.

#include <array>
#include <vector>

#include "base/methods.hpp"
#include "input/case/geometry.hpp"
#include "input/case/stage.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

enum class AnalysisKind { run, strength_reduction };
using talus::Method;

/// The displacement–SRF curve with moving geometry and the constructions on it (chapter 3 of the source).
struct DisplacementCurve {
  bool enabled = true;
  double from = 1.0, to = 1.75, step = 0.05;  ///< strength reduction factors [-]
  bool refine = true;                         ///< halve the intervals where the curvature is large
  double refine_step = 0.01;                  ///< smallest interval [-]
  double window = 5;                          ///< duration of a trial [s]
  StepSettings step_settings{.damping = 0.05, .courant = 0.98};
  std::vector<double> initial_branch;  ///< [lo, hi] SRF of the first line; empty: chosen from the data
  std::vector<double> final_branch;    ///< [lo, hi] SRF of the second line; empty: chosen from the data
  double displacement_ratio = 0.03;    ///< u/H that counts as failure in the second criterion [-]
  std::vector<double> runout;          ///< factors whose trials are continued to rest [-]
  double runout_time = 60;             ///< longest duration of such a trial [s]
};

/// Factor of safety from trials on frozen geometry: rest or accelerating displacement
/// (docs/theory/factor-of-safety.md).
struct FrozenFactor {
  bool enabled = true;
  double from = 1.0, to = 2.0;  ///< initial bracket [-]; widened if it does not contain the factor
  double resolution = 0.01;     ///< width of the final bracket [-]
  int meshes =
      2;  ///< 1: size of the case; 2: also half and twice that size, extrapolated; 3: a quarter instead of twice
  bool mesh_scatter = true;  ///< mesh the coarse size with a second algorithm as well, for the interval of the factor
  mesh::Algorithm algorithm = mesh::Algorithm::meshadapt;  ///< of these meshes
  double corner_refinement =
      4;               ///< ratio of general to local element size at re-entrant corners of the ground [-]; 1: none
  double window = 60;  ///< a trial without decision by then is undecided [s]
  double failed_displacement = 0.1;  ///< u/H at which a trial has failed [-]
  StepSettings step_settings{
      .damping = 0.2, .smoothing = Smoothing::stable, .geometry = Geometry::frozen, .water = WaterMotion::held};
  RestCriterion rest;
};

struct StrengthReduction {
  DisplacementCurve curve;
  FrozenFactor frozen;
};

template <>
inline constexpr auto choices<AnalysisKind> = std::array{
    Choice{AnalysisKind::run, "run", "the stages, one after the other"},
    Choice{AnalysisKind::strength_reduction, "strength_reduction", "the stages, then trials with reduced strength"},
};

template <>
inline constexpr auto choices<Method> = std::array{
    Choice{Method::lem, "lem", "limit equilibrium (methods of slices), see [lem]"},
    Choice{Method::fem, "fem", "strength reduction by finite elements, see [fem]"},
    Choice{Method::bounds, "bounds", "lower and upper bound by limit analysis, see [bounds]"},
    Choice{Method::mpm, "mpm", "material point method, for the `kind` of analysis"},
    Choice{Method::seepage, "seepage", "flow of water alone, steady or in time, see [seepage]"},
};

struct AnalysisBlock {
  AnalysisKind& kind;
  std::vector<Method>& methods;
};

void describe(auto& v, AnalysisBlock& a) {
  v.key("methods", a.methods, plain(),
        "The methods of the calculation, in one report. Without \"mpm\" a case needs no box, no stage, no boundary "
        "and, with \"lem\" alone, no mesh and no stiffness; with \"seepage\" alone, no weight and no strength either. "
        "Where "
        "such keys are given, they are not used.");
  v.key("kind", a.kind, plain(), "Analysis by MPM.");
}

void describe(auto& v, DisplacementCurve& c) {
  v.key("enabled", c.enabled, plain(), "Calculate the curve.");
  v.key("from", c.from, plain().above(0), "First strength reduction factor.");
  v.key("to", c.to, plain().above(0), "Last strength reduction factor.");
  v.key("step", c.step, plain().above(0), "Distance of the factors.");
  v.key("refine", c.refine, plain(), "Halve the intervals where the curve bends.");
  v.key("refine_step", c.refine_step, plain().above(0), "Smallest interval.");
  v.key("window", c.window, quantity("s").above(0), "Observation time of a trial.");
  describe(v, c.step_settings);
  v.key("initial_branch", c.initial_branch, plain().above(0).example("[1.0, 1.2]"),
        "From and to which factor the first line is fitted; empty: chosen from the data.");
  v.key("final_branch", c.final_branch, plain().above(0).example("[1.5, 1.7]"),
        "From and to which factor the second line is fitted; empty: chosen from the data.");
  v.key("displacement_ratio", c.displacement_ratio, plain().above(0),
        "Displacement over the relief of the ground that counts as failure in the second criterion.");
  v.key("runout", c.runout, plain().above(0).example("[1.6, 1.7]"), "Factors whose trials continue until rest.");
  v.key("runout_time", c.runout_time, quantity("s").above(0), "Longest time of such a trial.");
}

void describe(auto& v, FrozenFactor& f) {
  v.key("enabled", f.enabled, plain(), "Calculate this factor of safety.");
  v.key("from", f.from, plain().above(0), "Lower end of the first bracket; widened when the factor is not in it.");
  v.key("to", f.to, plain().above(0), "Upper end of the first bracket.");
  v.key("resolution", f.resolution, plain().above(0), "Width of the last bracket.");
  v.key(
      "meshes", f.meshes, plain().at_least(1).at_most(3),
      "1: one mesh of the case's element size. 2: also one of half that size and one of twice it, which costs little; "
      "the factor is extrapolated to size zero by a line through the three. 3: instead of twice it, a quarter.");
  v.key("mesh_scatter", f.mesh_scatter, plain(),
        "With two meshes, calculate the coarse one by another mesher too. The interval that is printed is no narrower "
        "than the distance of the two factors.");
  v.key("algorithm", f.algorithm, plain(),
        "Gmsh's algorithm for these meshes (a ready mesh file is used as it is). Irregular ones lock least.");
  v.key("corner_refinement", f.corner_refinement, plain().at_least(1).at_most(16),
        "How many times smaller the elements of these meshes are at corners of the ground that point into the soil, "
        "such as a slope's toe. They reach the general size 8 sizes away. 1: no smaller. A ready mesh file, or a "
        "result's, is used as it is.");
  v.key("window", f.window, quantity("s").above(0), "A trial that has not decided by then is reported as undecided.");
  v.key("failed_displacement", f.failed_displacement, plain().above(0),
        "Displacement over the relief of the ground that decides \"failed\".");
  describe(v, f.step_settings);
  v.table("rest", f.rest, "What decides \"at rest\" in a trial.");
}

void describe(auto& v, StrengthReduction& s) {
  v.table("curve", s.curve,
          "Displacement over strength reduction factor on moving geometry, and the constructions on that curve.");
  v.table("frozen", s.frozen, "The factor of safety from rest or run-away at frozen geometry, by bisection.");
}

}  // namespace talus::input
