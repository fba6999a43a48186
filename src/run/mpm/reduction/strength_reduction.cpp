#include "run/mpm/reduction/strength_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/atomic_file.hpp"
#include "output/files/history.hpp"
#include "run/mpm/reduction/frozen_run.hpp"

namespace talus::run {
namespace {

using nlohmann::json;

/// Below this share of the slope's height a displacement is elastic and no jump.
constexpr double elastic_share = 1e-3;

/// Least and greatest angle of dilatancy [deg]; zero where no soil has one.
std::pair<double, double> find_dilatancy_range(const input::Case& data) {
  double low = 1e9, high = -1e9;
  for (const auto& [name, m] : data.materials) {
    if (m.model != input::MaterialModel::mohr_coulomb && m.model != input::MaterialModel::rooted_mohr_coulomb) continue;
    low = std::min(low, m.dilatancy_angle * 180 / std::numbers::pi);
    high = std::max(high, m.dilatancy_angle * 180 / std::numbers::pi);
  }
  return low <= high ? std::pair{low, high} : std::pair{0.0, 0.0};
}

}  // namespace

template <int D>
void reduce_strength(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads,
                     json& summary, std::vector<std::string>& warnings) {
  const input::Case& data = *context.data;
  const input::StrengthReduction& settings = data.strength_reduction;
  json& factors = summary["factor_of_safety"] = json::object();
  if (settings.curve.enabled) {
    const CurveResult curve = compute_curve(state, context, slope_height, threads);
    const std::vector<CurvePoint> points = curve.points();
    const auto bilinear = construct_bilinear(points, settings.curve.initial_branch, settings.curve.final_branch);
    std::vector<Criterion> criteria;
    if (bilinear)
      criteria.push_back(bilinear->criterion);
    else
      criteria.push_back({"bilinear", std::nullopt, 0, 0, "too few factors in the branches"});
    criteria.push_back(find_displacement_criterion(points, settings.curve.displacement_ratio * slope_height));
    if (criteria.back().factor)
      criteria.back().note = fmt::format("largest displacement reaches {:g} H, H = {:g} m",
                                         settings.curve.displacement_ratio, slope_height);
    criteria.push_back(find_jump_criterion(points, elastic_share * slope_height));
    summary["curve"] = describe_curve(curve, bilinear, criteria);
    factors["criteria"] = summary["curve"]["criteria"];
    std::string table = "srf,largest displacement [m],end,force ratio,nodal speed [m/s]\n";
    for (const TrialResult& t : curve.trials) {
      table += fmt::format("{},{},{},{},{}\n", output::to_shortest(t.factor), output::to_shortest(t.displacement),
                           to_json(t).at("end").get<std::string>(), output::to_shortest(t.force_ratio),
                           output::to_shortest(t.speed));
    }
    write_atomically(context.folder / "curve.csv", table);
    json runouts = json::array();
    for (const RunoutTrial& r : curve.runouts) {
      json j = to_json(r.trial);
      j["runout"] = to_json(r.runout);
      j["profile"] = to_json(r.final);
      if (r.failure_time) j["failure_time"] = *r.failure_time;
      runouts.push_back(std::move(j));
      if (r.trial.end != StageEnd::rest) {
        warnings.push_back(fmt::format("the runout at SRF {:g} was still moving after {:g} s; raise runout_time",
                                       r.factor, r.trial.time));
      }
    }
    if (!runouts.empty()) summary["runouts"] = runouts;
  }
  if (settings.frozen.enabled) {
    const FrozenResult frozen = compute_frozen_factor<D>(state.mesh(), context, threads, warnings);
    const auto [low, high] = find_dilatancy_range(data);
    factors["frozen"] = to_json(frozen, low, high);
    factors["value"] = frozen.factor();
    if (summary.contains("curve")) {
      Criterion c{"frozen", frozen.factor(), frozen.factor() - frozen.uncertainty(),
                  frozen.factor() + frozen.uncertainty(), "rest or run-away at frozen geometry"};
      summary["curve"]["criteria"].push_back(to_json(c));
    }
  }
}

template void reduce_strength<2>(const mpm::Body<2>&, const TrialContext&, double, int, json&,
                                 std::vector<std::string>&);
template void reduce_strength<3>(const mpm::Body<3>&, const TrialContext&, double, int, json&,
                                 std::vector<std::string>&);

}  // namespace talus::run
