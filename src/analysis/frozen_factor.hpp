#pragma once
// The factor of safety of Talus: at frozen geometry a trial either comes to rest or runs away, and bisection finds the
// factor between. Evidence and definitions: docs/theory/factor-of-safety.md.

#include <map>
#include <optional>
#include <vector>

#include "analysis/trial.hpp"

namespace talus::analysis {

/// The factor on one mesh.
struct MeshFactor {
  double size = 0;  ///< element size h [m]
  int points = 0;
  double lower = 0, upper = 0;      ///< largest stable and smallest failed factor
  bool undecided = false;           ///< some trial neither rested nor ran away; it counts as failed
  std::vector<TrialResult> trials;  ///< in the order of their factors
  double factor() const { return 0.5 * (lower + upper); }
};

struct FrozenResult {
  std::vector<MeshFactor> meshes;      ///< coarse to fine
  std::optional<double> extrapolated;  ///< linear in h to h = 0, from two meshes
  double factor() const { return extrapolated ? *extrapolated : meshes.back().factor(); }
  /// Half the width of the final brackets as the extrapolation passes them on.
  double uncertainty() const;
};

/// What a search tells while it goes on. May be empty; called from several threads, one at a time.
using TrialReport = std::function<void(const TrialResult&)>;

/// Trials that were calculated before, by factor.
using KnownTrials = std::map<double, TrialResult>;

/// Bisects on the body `state` (at rest under real strength, geometry frozen all along). The factors that are tried do
/// not depend on `threads`: every round tries two factors that cut the bracket into three.
template <int D>
MeshFactor find_frozen_factor(const mpm::Body<D>& state, const model::Case& data, const model::FrozenFactor& settings,
                              double soil_height, int threads, const KnownTrials& known = {},
                              const TrialReport& report = {}, const StageHooks<D>& hooks = {});

/// Linear extrapolation of two factors at sizes `coarse` > `fine` to size 0.
double extrapolate_to_zero(double coarse, double factor_coarse, double fine, double factor_fine);

}  // namespace talus::analysis
