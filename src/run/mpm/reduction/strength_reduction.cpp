// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/strength_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "base/atomic_file.hpp"
#include "output/files/history.hpp"
#include "run/mpm/reduction/criteria.hpp"
#include "run/mpm/reduction/displacement_curve.hpp"
#include "run/mpm/reduction/frozen_run.hpp"

namespace talus::run {
namespace {

/// Below this share of the slope's height a displacement is elastic and no jump.
constexpr double elastic_share = 1e-3;

/// Least and greatest angle of dilatancy [deg]; zero where no soil has one.
std::pair<double, double> find_dilatancy_range(const input::Case& data) {
  double low = 1e9, high = -1e9;
  for (const auto& [name, m] : data.materials) {
    if (!m.traits().has_friction) continue;
    low = std::min(low, m.dilatancy_angle * 180 / std::numbers::pi);
    high = std::max(high, m.dilatancy_angle * 180 / std::numbers::pi);
  }
  return low <= high ? std::pair{low, high} : std::pair{0.0, 0.0};
}

std::vector<results::Criterion> find_criteria(const std::vector<CurvePoint>& points,
                                              const std::optional<Bilinear>& bilinear,
                                              const input::DisplacementCurve& settings, double slope_height) {
  std::vector<results::Criterion> criteria;
  if (bilinear)
    criteria.push_back(bilinear->criterion);
  else
    criteria.push_back({results::CriterionKind::bilinear, {}, {}, {}, "too few factors in the branches"});
  criteria.push_back(find_displacement_criterion(points, settings.displacement_ratio * slope_height));
  if (criteria.back().factor)
    criteria.back().note =
        fmt::format("largest displacement reaches {:g} H, H = {:g} m", settings.displacement_ratio, slope_height);
  criteria.push_back(find_jump_criterion(points, elastic_share * slope_height));
  return criteria;
}

void write_curve_table(const std::vector<results::Trial>& trials, const std::filesystem::path& path) {
  std::string table = "srf,largest displacement [m],end,force ratio,nodal speed [m/s]\n";
  for (const results::Trial& t : trials)
    table += fmt::format("{},{},{},{},{}\n", output::to_shortest(t.factor), output::to_shortest(t.displacement),
                         results::to_word(t.end), output::to_shortest(t.force_ratio), output::to_shortest(t.speed));
  write_atomically(path, table);
}

}  // namespace

template <int D>
void reduce_strength(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads,
                     results::RunResult& run, std::vector<std::string>& warnings) {
  const input::Case& data = *context.data;
  const input::StrengthReduction& settings = data.strength_reduction;
  results::PointFactors& factors = run.factor_of_safety.emplace();
  if (settings.curve.enabled) {
    CurveResult found = compute_curve(state, context, slope_height, threads);
    const std::vector<CurvePoint> points = found.points();
    const auto bilinear = construct_bilinear(points, settings.curve.initial_branch, settings.curve.final_branch);
    results::DisplacementCurve& curve = run.curve.emplace();
    curve.criteria = find_criteria(points, bilinear, settings.curve, slope_height);
    factors.criteria = curve.criteria;
    if (bilinear && bilinear->criterion.factor)
      curve.bilinear = results::BilinearLines{*bilinear->criterion.factor, bilinear->first, bilinear->last};
    curve.points = std::move(found.trials);
    write_curve_table(curve.points, context.folder / "curve.csv");
    for (const results::RunoutTrial& r : found.runouts) {
      if (r.trial.end != results::StageEnd::rest)
        warnings.push_back(fmt::format("the runout at SRF {:g} was still moving after {:g} s; raise runout_time",
                                       r.trial.factor, r.trial.time));
      if (const std::string limits = describe_limits(r.runout); !limits.empty())
        warnings.push_back(fmt::format("the runout at SRF {:g}: {}", r.trial.factor, limits));
    }
    if (!found.runouts.empty()) run.runouts = std::move(found.runouts);
  }
  if (settings.frozen.enabled) {
    results::FrozenFactor frozen = compute_frozen_factor<D>(state.mesh(), context, threads, warnings);
    std::tie(frozen.dilatancy_angle_min, frozen.dilatancy_angle_max) = find_dilatancy_range(data);
    factors.value = frozen.factor;
    if (run.curve)
      run.curve->criteria.push_back({results::CriterionKind::frozen, frozen.factor, frozen.lower(), frozen.upper(),
                                     frozen.factor ? "rest or run-away at frozen geometry" : frozen.note});
    factors.frozen = std::move(frozen);
  }
}

template void reduce_strength<2>(const mpm::Body<2>&, const TrialContext&, double, int, results::RunResult&,
                                 std::vector<std::string>&);
template void reduce_strength<3>(const mpm::Body<3>&, const TrialContext&, double, int, results::RunResult&,
                                 std::vector<std::string>&);

}  // namespace talus::run
