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

void describe(Visitor& v, AnalysisBlock& a);

void describe(Visitor& v, DisplacementCurve& c);

void describe(Visitor& v, FrozenFactor& f);

void describe(Visitor& v, StrengthReduction& s);

}  // namespace talus::input
