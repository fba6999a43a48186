// SPDX-License-Identifier: MIT
#include "run/timeline/moment.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "lem/surface/surface.hpp"
#include "results/governing.hpp"
#include "run/lem/run_lem.hpp"
#include "run/lem/slice_run.hpp"
#include "site/initial_water.hpp"

namespace talus::run {

namespace {

void shift(input::TimeTable& table, double time) {
  for (double& t : table.time) t -= time;
}

}  // namespace

input::Case begin_later(input::Case data, double time, std::shared_ptr<const input::KnownWater> water) {
  // Water, pools and weather are those before a jump of a series at this time.
  const double before = time + site::find_first_time(data);
  for (input::Hydraulic& h : data.hydraulics)
    for (input::TimeTable* table : {&h.head, &h.pressure, &h.rate}) shift(*table, before);
  for (input::Roots& roots : data.roots)
    if (roots.transpiration) shift(roots.transpiration->rate, before);
  data.timeline.reset();
  if (!water) return data;
  // A given pressure stays in soil without pore water of its own.
  if (data.initial.water.pressure == input::InitialPressure::seepage)
    data.initial.water.pressure = input::InitialPressure::zero;
  data.initial.water.season = 0;
  data.initial.water.known = std::move(water);
  return data;
}

namespace {

/// A surface replaces that of another time only if its factor is lower by more than this fraction.
constexpr double same_factor = 1e-6;
/// Largest number of rounds in which surfaces are exchanged between times.
constexpr int most_rounds = 4;

/// Returns the best surface of `list` by `method`; nullptr if there is none.
lem::Critical* find_by(std::vector<lem::Critical>& list, lem::Method method) {
  const auto at = std::find_if(list.begin(), list.end(), [&](const lem::Critical& c) { return c.method == method; });
  return at == list.end() ? nullptr : &*at;
}

/// Converts a surface of the results, a polyline with a point at each side of a slice, and drops the points on
/// straight lines.
lem::Surface take_surface(const results::SlipSurface& result, const lem::SearchOptions& options) {
  lem::Surface surface;
  surface.name = result.name.value_or("");
  surface.from = result.points.front()[0];
  surface.to = result.points.back()[0];
  if (result.circle)
    surface.circle = lem::Circle{result.circle->centre, result.circle->radius};
  else if (options.kind == lem::SearchKind::block)
    surface.line = lem::drop_straight_points({result.points.begin(), result.points.end()});
  else
    surface.line = lem::thin_points({result.points.begin(), result.points.end()}, options.vertices);
  return surface;
}

bool is_better(const lem::Critical& one, const lem::Critical* other) {
  if (one.solution.refusal != lem::Refusal::none || !(one.solution.factor > 0)) return false;
  return other == nullptr || one.solution.factor < other->solution.factor * (1 - same_factor);
}

/// Evaluates the surfaces of other times at this one, and optimises the best of them if its factor is lower. Returns
/// true if a surface was replaced.
bool take_over(const std::vector<Moment>& others, const lem::SearchOptions& options, bool circular, Moment& moment) {
  bool any = false;
  auto& own = circular ? moment.circular : moment.noncircular;
  for (const lem::Method method : options.methods) {
    lem::Critical* mine = find_by(own, method);
    const lem::Surface* best = nullptr;
    double least = mine != nullptr ? mine->solution.factor * (1 - same_factor) : 1e9;
    for (const Moment& other : others)
      for (const lem::Critical& c : circular ? other.circular : other.noncircular) {
        if (c.method != method) continue;
        const lem::Critical here = solve_surface(*moment.slope, c.surface, method, options);
        if (!(here.solution.factor > 0)) continue;
        if (here.solution.refusal != lem::Refusal::none) {
          if (here.solution.factor < moment.refused_factor)
            moment.refused_factor = here.solution.factor, moment.refusal = here.solution.refusal;
          continue;
        }
        if (here.solution.factor < least) least = here.solution.factor, best = &c.surface;
      }
    if (best == nullptr) continue;
    lem::Critical found = lem::optimise(*moment.slope, *best, method, options);
    if (!is_better(found, mine)) found = solve_surface(*moment.slope, *best, method, options);
    if (!is_better(found, mine)) continue;
    any = true;
    if (mine != nullptr)
      *mine = std::move(found);
    else
      own.push_back(std::move(found));
  }
  return any;
}

}  // namespace

void take_known(const results::SliceResult& found, const lem::SearchOptions& options, Moment& moment) {
  results::SearchedMoment kept;
  const auto keep = [](const std::vector<results::CriticalSurface>& from, std::vector<results::SlipSurface>& to) {
    for (const results::CriticalSurface& c : from) to.push_back(c.surface);
  };
  keep(found.critical, kept.circular);
  keep(found.noncircular, kept.noncircular);
  keep(found.given, kept.given);
  take_kept(kept, options, moment);
}

void take_kept(const results::SearchedMoment& kept, const lem::SearchOptions& options, Moment& moment) {
  const auto take = [&](const std::vector<results::SlipSurface>& from, std::vector<lem::Critical>& to) {
    for (const results::SlipSurface& s : from)
      to.push_back(solve_surface(*moment.slope, take_surface(s, options), s.method, options));
  };
  take(kept.circular, moment.circular);
  take(kept.noncircular, moment.noncircular);
  take(kept.given, moment.given);
  moment.error = kept.error;
}

results::SearchedMoment keep_moment(const Moment& moment) {
  results::SearchedMoment kept;
  kept.time = moment.time;
  kept.error = moment.error;
  const auto keep = [&](const std::vector<lem::Critical>& from, std::vector<results::SlipSurface>& to) {
    for (const lem::Critical& c : from) to.push_back(make_critical_result(*moment.slope, c).surface);
  };
  keep(moment.circular, kept.circular);
  keep(moment.noncircular, kept.noncircular);
  keep(moment.given, kept.given);
  return kept;
}

void search_moment(const input::Case& data, lem::SearchOptions options, const std::vector<Moment>& others,
                   Moment& moment) {
  for (const Moment& other : others)
    for (const lem::Critical& c : other.noncircular) options.known.push_back(c.surface);
  for (const input::SlipSurface& given : data.lem.surfaces)
    for (const lem::Method method : options.methods)
      moment.given.push_back(solve_surface(*moment.slope, make_surface(*moment.slope, given), method, options));
  if (data.lem.search == input::SurfaceSearch::none) return;
  try {
    lem::SearchResult found = lem::search(*moment.slope, options);
    moment.circular = std::move(found.circular);
    moment.noncircular = std::move(found.noncircular);
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    moment.error = error.what();
  }
}

void share_surfaces(const lem::SearchOptions& options, int threads, std::vector<Moment>& moments) {
  for (const bool circular : {true, false}) {
    for (int round = 0; round < most_rounds; ++round) {
      // A round uses the surfaces of the previous one, so results do not depend on the number of threads.
      std::vector<Moment> before(moments.size());
      for (std::size_t i = 0; i < moments.size(); ++i)
        (circular ? before[i].circular : before[i].noncircular) =
            circular ? moments[i].circular : moments[i].noncircular;
      std::vector<char> changed(moments.size(), 0);
      parallel_tasks(static_cast<int>(moments.size()), threads, [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        changed[k] = take_over(before, options, circular, moments[k]) ? 1 : 0;
      });
      if (std::none_of(changed.begin(), changed.end(), [](char c) { return c != 0; })) break;
    }
  }
}

std::optional<double> try_surfaces(const std::vector<results::TimedFactor>& known, const lem::SearchOptions& options,
                                   const lem::Slope& slope) {
  std::optional<double> least;
  for (const results::TimedFactor& k : known) {
    if (!k.factor) continue;
    const lem::Solution solution =
        solve_surface(slope, take_surface(k.surface, options), k.surface.method, options).solution;
    if (solution.refusal == lem::Refusal::none && solution.factor > 0 && !(least && *least <= solution.factor))
      least = solution.factor;
  }
  return least;
}

results::TimedFactor make_moment_result(const lem::SearchOptions& options, const Moment& moment) {
  results::SliceResult slices;
  slices.methods = options.methods;
  const auto tell = [&](const std::vector<lem::Critical>& from, std::vector<results::CriticalSurface>& to) {
    for (const lem::Critical& c : from) to.push_back(make_critical_result(*moment.slope, c));
  };
  tell(moment.circular, slices.critical);
  tell(moment.noncircular, slices.noncircular);
  tell(moment.given, slices.given);
  if (moment.referee) results::take_referee(*moment.referee, slices);
  results::TimedFactor result;
  result.time = moment.time;
  result.referee = moment.referee;
  if (const auto governing = results::find_governing_surface(slices, nullptr)) {
    result.factor = governing->found->surface.factor;
    result.surface = governing->found->surface;
    result.source = results::name_surface(*governing, moment.slope->section().units);
    result.refusal = governing->found->checks.refusal;
  } else if (const auto proven = results::find_slices_factor(slices, nullptr)) {
    result.factor = proven;
    result.surface.title = "Limit analysis";
    result.source = proven == moment.referee->upper ? "upper bound" : "lower bound";
  }
  return result;
}

}  // namespace talus::run
