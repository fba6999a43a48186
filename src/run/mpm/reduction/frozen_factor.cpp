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

/// Elements at re-entrant corners reach the general size so many general sizes away.
constexpr double corner_reach = 8;

/// Smallest factor at which a trial ran away; infinite where none did.
double find_smallest_failed(const results::MeshFactor& mesh) {
  double failed = std::numeric_limits<double>::infinity();
  for (const results::Trial& t : mesh.trials)
    if (t.end == results::StageEnd::failed) failed = std::min(failed, t.factor);
  return failed;
}

/// Distance from the factor of a mesh to the ends of its bracket. Trials that were counted as failed may have held, so
/// that the upper end is the next factor that ran away.
double find_half_bracket(const results::MeshFactor& mesh) {
  const double half = 0.5 * (*mesh.upper - *mesh.lower), failed = find_smallest_failed(mesh);
  return mesh.undecided && std::isfinite(failed) ? std::max(half, failed - *mesh.factor()) : half;
}

/// A bracket is widened at most this often in one direction.
constexpr int most_widenings = 6;

/// Why a mesh has no factor; empty where it has one.
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

/// Factors of meshes whose sizes differ by a rounding are this far apart, whatever two meshes happen to say [-].
constexpr double known_scatter = 0.006;
/// Trials without a decision between a factor that holds and one that fails this much above it are worth a warning [-].
constexpr double doubtful = 0.02;
/// The line goes through no more than so many meshes, the finest.
constexpr std::size_t most_in_line = 3;

/// Of what lies between the two finest meshes: holds the limit for orders of 0.6 and more in plane strain, of 0.5 and
/// more for tetrahedra, which converge more slowly.
double find_spread(int dimension) {
  return dimension == 3 ? 1.5 : 1;
}

/// What the mesh does to the extrapolated factor: no less than what lies between its two finest meshes, times `spread`,
/// nor than what the extrapolation takes from the finest; nor than what two meshers of one size say; nor than what the
/// extrapolation, by `passed_on`, makes of the scatter.
double find_mesh_effect(double coarse, double fine, const std::optional<results::MeshFactor>& other, double factor,
                        double passed_on, double spread) {
  const double scatter = other && other->factor() ? std::abs(coarse - *other->factor()) : 0;
  return std::max(
      {spread * std::abs(coarse - fine), std::abs(fine - factor), scatter, known_scatter * passed_on * factor});
}

/// Extrapolates to elements of no size, with the interval.
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

std::string describe_undecided(const results::MeshFactor& mesh, const input::FrozenFactor& settings) {
  if (!mesh.undecided || !mesh.lower) return "";
  const double failed = find_smallest_failed(mesh);
  if (failed < (1 + doubtful) * *mesh.lower) return "";
  return fmt::format(
      "at h = {:g} m trials neither rested nor ran away within {:g} s and count as failed: the factor lies between "
      "{:.3f} and {}. A longer 'window' under [strength_reduction.frozen] decides them",
      mesh.size, settings.window, *mesh.lower,
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
  StagePlan<D> plan;
  plan.name = "frozen trial";
  plan.duration = settings.window;
  plan.until_rest = true;
  plan.step = settings.step_settings;
  plan.rest = settings.rest;
  plan.gravity = find_acceleration<D>(data);
  plan.soil_height = slope_height;
  plan.failed_displacement = settings.failed_displacement * slope_height;
  plan.equalises_mass = true;
  plan.threads = threads;
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
    // If the search runs into an end of the first bracket, that end must be tried and the bracket widened beyond it. A
    // factor needs both ends: where the last one was not tried, there is none.
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
