#pragma once
// The factor of safety of Talus: at frozen geometry a trial either comes to rest or runs away, and bisection finds the
// factor between. Evidence and definitions: docs/theory/factor-of-safety.md.

#include <map>
#include <optional>
#include <vector>

#include "run/mpm/reduction/trial.hpp"

namespace talus::run {

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

/// Trials that were calculated before, by factor.
using KnownTrials = std::map<double, TrialResult>;

/// Bisects between rest and run-away. `run_trial` calculates the trial with a factor; up to `side_by_side` calls run at
/// the same time. The factors that are tried do not depend on that: every round tries two that cut the bracket into
/// three.
MeshFactor search_frozen_factor(const input::FrozenFactor& settings, int side_by_side,
                                const std::function<TrialResult(double)>& run_trial);

/// The trial at frozen geometry. `slope_height` is H of the criteria [m].
template <int D>
StagePlan<D> make_frozen_plan(const input::Case& data, const input::FrozenFactor& settings, double slope_height,
                              int threads);

/// The factor of the body `state` (at rest under real strength, geometry frozen all along), with nothing kept on disk.
template <int D>
MeshFactor find_frozen_factor(const mpm::Body<D>& state, const input::Case& data, const input::FrozenFactor& settings,
                              double slope_height, int threads);

/// Linear extrapolation of two factors at sizes `coarse` > `fine` to size 0.
double extrapolate_to_zero(double coarse, double factor_coarse, double fine, double factor_fine);

}  // namespace talus::run
