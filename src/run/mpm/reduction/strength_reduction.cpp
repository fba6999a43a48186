// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/strength_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <tuple>

#include "base/atomic_file.hpp"
#include "base/numbers.hpp"
#include "mesh/quality.hpp"
#include "mpm/solver/observe.hpp"
#include "output/files/history.hpp"
#include "results/json.hpp"
#include "run/mpm/record/motion.hpp"
#include "run/mpm/reduction/criteria.hpp"
#include "run/mpm/reduction/frozen_run.hpp"
#include "run/mpm/reduction/leg.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {

namespace {

/// Largest number of refinements of the curve; each adds factors on both sides of every bend.
constexpr int most_refinements = 4;
/// Points that moved by less than this fraction of the slope height are not part of the slide.
constexpr double moved_fraction = 0.01;
/// Frames of a runout within the window of the curve, in which most of the slide happens, if the case names no
/// interval.
constexpr int frames_per_window = 25;

std::vector<double> list_factors(const input::DisplacementCurve& curve) {
  std::vector<double> factors;
  const int count = static_cast<int>(std::floor((curve.to - curve.from) / curve.step + 1e-9));
  // Rounded to a millionth (1.15, not 1.1500000000000001) for legible folders and tables.
  for (int i = 0; i <= count; ++i) factors.push_back(std::round((curve.from + i * curve.step) * 1e6) / 1e6);
  for (const double f : curve.runout) factors.push_back(f);
  std::sort(factors.begin(), factors.end());
  factors.erase(std::unique(factors.begin(), factors.end(), [](double a, double b) { return std::abs(a - b) < 1e-9; }),
                factors.end());
  return factors;
}

/// Combines the legs of a trial: end of the last one, total time and steps, largest speed.
results::Trial add_up(const std::vector<results::Trial>& legs) {
  results::Trial sum = legs.back();
  for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
    sum.time += legs[i].time;
    sum.steps += legs[i].steps;
    sum.largest_speed = std::max(sum.largest_speed, legs[i].largest_speed);
  }
  return sum;
}

}  // namespace

std::vector<CurvePoint> CurveResult::points() const {
  std::vector<CurvePoint> points;
  for (const results::Trial& t : trials) points.push_back({t.factor, t.displacement});
  return points;
}

template <int D>
CurveResult compute_curve(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads) {
  const input::DisplacementCurve& curve = context.data->strength_reduction.curve;
  const int side_by_side = count_parallel_trials(state.points.size(), threads);
  const int inner = side_by_side > 1 ? 1 : threads;
  const double bin = mesh::measure_quality(state.mesh()).mean_size;
  CurveResult result;

  const auto wants_runout = [&](double f) {
    return std::any_of(curve.runout.begin(), curve.runout.end(), [&](double r) { return std::abs(r - f) < 1e-9; });
  };
  const auto name_folder = [&](double factor) { return context.folder / "trials" / fmt::format("srf_{:.4f}", factor); };
  const auto run_one = [&](double factor, const std::string& label) -> results::TrialOutcome {
    TrialFiles files;
    files.folder = name_folder(factor);
    files.keeps_frames = true;
    files.label = label;
    const bool runs_out = wants_runout(factor);
    const auto outcome_file = files.folder / "outcome.json";  // includes the runout, which trial.json does not
    if (context.resume && runs_out) {
      if (auto known = results::read_file<results::TrialOutcome>(outcome_file)) return std::move(*known);
    } else if (context.resume) {
      if (const auto known = load_trial(files.folder)) return {*known, {}, {}};
    }
    std::vector<StagePlan<D>> legs{make_plan<D>(*context.data, fmt::format("trial SRF {:g}", factor), curve.window,
                                                curve.step_settings, slope_height, inner)};
    RunoutStart runout_start;
    if (runs_out) {
      mpm::Body<D> start = state;
      mpm::reset_displacements(start);
      runout_start = {find_profile(start, bin), moved_fraction * slope_height, find_specific_volumes(start)};
      files.runout_start = &runout_start;
      legs.push_back(legs[0]);
      legs[1].name = fmt::format("runout SRF {:g}", factor);
      legs[1].duration = curve.runout_time;
      legs[1].until_rest = true;
      files.keeps_history = true;
      const double interval = context.data->output.frame_interval;
      files.frame_interval = interval > 0 ? interval : curve.window / frames_per_window;
    }
    mpm::Body<D> body;
    const auto legs_done = run_trial_legs(state, factor, legs, context, files, body);
    results::TrialOutcome outcome{legs_done.front(), {}, {}};
    save_trial(files.folder, outcome.trial);
    if (runs_out) {
      auto& runout = outcome.runout.emplace(results::RunoutTrial{
          add_up(legs_done), find_runout(body, runout_start), find_profile(body, bin),
          find_failure_time(files.folder / "history.csv", curve.displacement_ratio * slope_height)});
      if (runout.failure_time) *runout.failure_time -= state.time;
      write_profiles(files.folder / "profile.csv", runout_start.initial, runout.profile);
      results::write_file(outcome_file, outcome);
    }
    return outcome;
  };
  const auto sort_results = [&] {
    std::sort(result.trials.begin(), result.trials.end(),
              [](const auto& a, const auto& b) { return a.factor < b.factor; });
    std::sort(result.runouts.begin(), result.runouts.end(),
              [](const auto& a, const auto& b) { return a.trial.factor < b.trial.factor; });
  };

  std::vector<double> factors = list_factors(curve);
  for (int round = 0; round <= most_refinements && !factors.empty(); ++round) {
    const int count = static_cast<int>(factors.size());
    // The weakest trial, which is the last one, takes longest with runouts, so it starts first and the others run
    // beside it.
    std::reverse(factors.begin(), factors.end());
    for (results::TrialOutcome& o : run_side_by_side(
             count, side_by_side, [&](int i) { return run_one(factors[i], fmt::format("[{} of {}] ", i + 1, count)); },
             [&](int i) { return name_folder(factors[i]); })) {
      result.trials.push_back(std::move(o.trial));
      if (o.runout) result.runouts.push_back(std::move(*o.runout));
    }
    sort_results();
    factors.clear();
    if (!curve.refine) break;
    for (const double f : choose_refinement(result.points(), curve.refine_step))
      factors.push_back(std::round(f * 1e6) / 1e6);
  }
  return result;
}

template CurveResult compute_curve<2>(const mpm::Body<2>&, const TrialContext&, double, int);
template CurveResult compute_curve<3>(const mpm::Body<3>&, const TrialContext&, double, int);

namespace {

/// Smallest and largest angle of dilatancy [deg]; zero if no soil has one.
std::pair<double, double> find_dilatancy_range(const input::Case& data) {
  double low = 1e9, high = -1e9;
  for (const auto& [name, m] : data.materials) {
    if (!m.traits().has_friction) continue;
    low = std::min(low, m.dilatancy_angle * 180 / std::numbers::pi);
    high = std::max(high, m.dilatancy_angle * 180 / std::numbers::pi);
  }
  return low <= high ? std::pair{low, high} : std::pair{0.0, 0.0};
}

void write_curve_table(const std::vector<results::Trial>& trials, const std::filesystem::path& path) {
  std::string table = "srf,largest displacement [m],end,force ratio,nodal speed [m/s]\n";
  for (const results::Trial& t : trials)
    table += fmt::format("{},{},{},{},{}\n", write_shortest(t.factor), write_shortest(t.displacement),
                         results::to_word(t.end), write_shortest(t.force_ratio), write_shortest(t.speed));
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
    curve.criteria =
        find_criteria(points, bilinear, settings.curve.displacement_ratio, slope_height, data.units().length);
    factors.criteria = curve.criteria;
    if (bilinear && curve.criteria.front().factor)
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
