// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/frozen_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/extrapolate.hpp"
#include "mesh/planar.hpp"
#include "run/mpm/reduction/leg.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {
namespace {

/// Distance from a re-entrant corner over which elements grow to the general size, in general sizes.
constexpr double corner_reach = 8;

/// Smallest factor whose trial failed; infinite if none did.
double find_smallest_failed(const results::MeshFactor& mesh) {
  double failed = std::numeric_limits<double>::infinity();
  for (const results::Trial& t : mesh.trials)
    if (t.end == results::StageEnd::failed) failed = std::min(failed, t.factor);
  return failed;
}

/// Returns the distance from the factor of a mesh to the ends of its bracket. Undecided trials count as failed but may
/// have been stable, so the upper end is the next factor that failed.
double find_half_bracket(const results::MeshFactor& mesh) {
  const double half = 0.5 * (*mesh.upper - *mesh.lower), failed = find_smallest_failed(mesh);
  return mesh.undecided && std::isfinite(failed) ? std::max(half, failed - *mesh.factor()) : half;
}

/// Largest number of times that a bracket is widened in one direction.
constexpr int most_widenings = 6;

/// Returns the reason why a mesh has no factor; empty if it has one.
std::string explain(const results::MeshFactor& mesh) {
  if (mesh.factor()) return "";
  const double first = mesh.trials.front().factor, last = mesh.trials.back().factor;
  if (!mesh.upper)
    return fmt::format("above {:.3g}: every trial came to rest, up to a strength divided by {:.3g}", last, last);
  return fmt::format(
      "no factor found: no trial came to rest, down to {:.3g}, so the motion does not depend on the strength. It may "
      "be "
      "settlement or flowing water: look at the state that the trials start from",
      first);
}

/// Scatter of the factor between meshes of practically equal size; a lower limit of the mesh effect [-].
constexpr double known_scatter = 0.006;
/// Undecided trials between a stable factor and a failed one this much above it give a warning [-].
constexpr double doubtful = 0.02;
/// Largest number of meshes in the extrapolation; the finest are used.
constexpr std::size_t most_in_line = 3;

/// Weight of the difference between the two finest meshes, such that the limit is included for orders of convergence
/// of at least 0.6 in plane strain, and 0.5 for tetrahedra, which converge more slowly.
double find_spread(int dimension) {
  return dimension == 3 ? 1.5 : 1;
}

/// Mesh effect (T11.5): the largest of the difference between the two finest meshes times `spread`, the extrapolation
/// beyond the finest mesh, the difference between two meshers, and the scatter of meshes, amplified by the
/// extrapolation (`passed_on` = Σ|c_i|).
double find_mesh_effect(double coarse, double fine, const std::optional<results::MeshFactor>& other, double factor,
                        double passed_on, double spread) {
  const double scatter = other && other->factor() ? std::abs(coarse - *other->factor()) : 0;
  return std::max(
      {spread * std::abs(coarse - fine), std::abs(fine - factor), scatter, known_scatter * passed_on * factor});
}

/// Extrapolates to element size zero, with the interval (T11.3, T11.5).
void extrapolate(results::FrozenFactor& frozen, int dimension) {
  std::vector<const results::MeshFactor*> line = frozen.list_found();
  if (line.size() > most_in_line) line.erase(line.begin(), line.end() - most_in_line);
  std::vector<double> sizes;
  for (const results::MeshFactor* mesh : line) sizes.push_back(mesh->size);
  const std::vector<double> shares = find_line_shares(sizes);
  double factor = 0, bracket = 0, passed_on = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    factor += shares[i] * *line[i]->factor();
    bracket += std::abs(shares[i]) * find_half_bracket(*line[i]);
    passed_on += std::abs(shares[i]);
  }
  frozen.factor = frozen.extrapolated = factor;
  frozen.bracket = bracket;
  frozen.mesh_effect = find_mesh_effect(*line[line.size() - 2]->factor(), *line.back()->factor(), frozen.other, factor,
                                        passed_on, find_spread(dimension));
  frozen.uncertainty = bracket + *frozen.mesh_effect;
}

}  // namespace

mesh::Plan plan_frozen_mesh(mesh::Plan plan, const input::FrozenFactor& settings, int halvings) {
  const double size = std::pow(0.5, halvings) * plan.size;
  return mesh::refine_corners(mesh::resize(std::move(plan), size), settings.corner_refinement, corner_reach);
}

std::string describe_undecided(const results::MeshFactor& mesh, const input::FrozenFactor& settings,
                               const ShownUnit& length) {
  if (!mesh.undecided || !mesh.lower) return "";
  const double failed = find_smallest_failed(mesh);
  if (failed < (1 + doubtful) * *mesh.lower) return "";
  return fmt::format(
      "at h = {} trials neither rested nor ran away within {:g} s and count as failed: the factor lies between "
      "{:.3f} and {}. A longer 'window' under [strength_reduction.frozen] decides them",
      format_value(mesh.size, length), settings.window, *mesh.lower,
      std::isfinite(failed) ? fmt::format("{:.3f}", failed) : std::string("a factor that was not found"));
}

results::FrozenFactor join_meshes(std::vector<results::MeshFactor> meshes, std::optional<results::MeshFactor> coarser,
                                  std::optional<results::MeshFactor> other, int dimension) {
  results::FrozenFactor frozen;
  frozen.meshes = std::move(meshes);
  frozen.coarser = std::move(coarser);
  frozen.other = std::move(other);
  for (const results::MeshFactor& mesh : frozen.meshes)
    if (frozen.note.empty()) frozen.note = explain(mesh);
  if (!frozen.note.empty()) return frozen;
  const results::MeshFactor& finest = frozen.meshes.back();
  frozen.factor = finest.factor();
  frozen.bracket = find_half_bracket(finest);
  if (frozen.meshes.size() > 1) extrapolate(frozen, dimension);
  return frozen;
}

template <int D>
StagePlan<D> make_frozen_plan(const input::Case& data, const input::FrozenFactor& settings, double slope_height,
                              int threads) {
  StagePlan<D> plan =
      make_plan<D>(data, "frozen trial", settings.window, settings.step_settings, slope_height, threads);
  plan.until_rest = true;
  plan.rest = settings.rest;
  plan.failed_displacement = settings.failed_displacement * slope_height;
  plan.equalises_mass = true;
  return plan;
}

results::MeshFactor search_frozen_factor(const input::FrozenFactor& settings, const RunTrials& run_trials) {
  results::MeshFactor result;
  const auto is_stable = [&](const std::vector<double>& factors) {
    std::vector<bool> stable;
    for (const results::Trial& t : run_trials(factors)) {
      result.trials.push_back(t);
      result.undecided = result.undecided || t.end == results::StageEnd::time;
      stable.push_back(t.end == results::StageEnd::rest);
    }
    return stable;
  };

  double low = settings.from, high = settings.to;
  bool low_holds = false, high_fails = false;  // not tried yet
  int widenings = 0;
  for (;;) {
    while (high - low > settings.resolution * (1 + 1e-9)) {
      const double third = (high - low) / 3;
      const std::vector<double> tries{low + third, high - third};
      const std::vector<bool> stable = is_stable(tries);
      if (!stable[0]) {
        high = tries[0];
        high_fails = true;
      } else if (!stable[1]) {
        low = tries[0];
        high = tries[1];
        low_holds = high_fails = true;
      } else {
        low = tries[1];
        low_holds = true;
      }
    }
    // If the search ends at an end of the initial bracket, that end is tried and the bracket widened beyond it. A
    // factor needs both a stable and a failed trial; without one of them there is none.
    if (!low_holds && widenings < most_widenings) {
      if (is_stable({low})[0]) {
        low_holds = true;
      } else {
        high = low;
        high_fails = true;
        low *= 0.7;
        ++widenings;
      }
    } else if (!high_fails && widenings < most_widenings) {
      if (!is_stable({high})[0]) {
        high_fails = true;
      } else {
        low = high;
        low_holds = true;
        high *= 1.4;
        ++widenings;
      }
    } else {
      break;
    }
  }
  if (low_holds) result.lower = low;
  if (high_fails) result.upper = high;
  std::sort(result.trials.begin(), result.trials.end(),
            [](const results::Trial& a, const results::Trial& b) { return a.factor < b.factor; });
  return result;
}

template <int D>
results::MeshFactor find_frozen_factor(const mpm::Body<D>& state, const input::Case& data,
                                       const input::FrozenFactor& settings, double slope_height, int threads) {
  const int side_by_side = count_parallel_trials(state.points.size(), threads);
  const StagePlan<D> plan = make_frozen_plan<D>(data, settings, slope_height, side_by_side > 1 ? 1 : threads);
  results::MeshFactor factor = search_frozen_factor(settings, [&](const std::vector<double>& factors) {
    std::vector<results::Trial> trials;
    const auto run_one = [&](int i) {
      mpm::Body<D> body = start_trial(state, data, factors[i]);
      StageState stage;
      return results::TrialOutcome{run_trial(body, factors[i], plan, stage), {}, {}};
    };
    for (results::TrialOutcome& o : run_side_by_side(static_cast<int>(factors.size()), side_by_side, run_one))
      trials.push_back(std::move(o.trial));
    return trials;
  });
  factor.points = state.points.size();
  return factor;
}

#define TALUS_INSTANTIATE(D)                                                                              \
  template StagePlan<D> make_frozen_plan<D>(const input::Case&, const input::FrozenFactor&, double, int); \
  template results::MeshFactor find_frozen_factor<D>(const mpm::Body<D>&, const input::Case&,             \
                                                     const input::FrozenFactor&, double, int);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
