// SPDX-License-Identifier: MIT
#include "run/timeline/timeline_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "ground/initial_water.hpp"
#include "ground/plane_water.hpp"
#include "ground/pore_water.hpp"
#include "ground/season.hpp"
#include "mesh/generate.hpp"
#include "results/governing.hpp"
#include "run/lem/run_lem.hpp"
#include "run/lem/section_of_case.hpp"
#include "run/lem/tell_slices.hpp"
#include "run/timeline/times.hpp"

namespace talus::run {
namespace timeline {

using Clock = std::chrono::steady_clock;

double count_seconds(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

/// A surface of one time is better than that of another only if its factor is lower by more than this share.
constexpr double same_factor = 1e-6;
/// Rounds in which surfaces pass from time to time.
constexpr int most_rounds = 4;

/// The slope at one time, and the surfaces that were found there.
struct Moment {
  double time = 0;  ///< [s]
  std::unique_ptr<lem::Slope> slope;
  std::vector<lem::Critical> circular, noncircular, given;
  std::string error;  ///< why there is no surface
  /// Of the surfaces of other times that the checks refuse here: the least factor, and why it is refused.
  double refused_factor = std::numeric_limits<double>::infinity();
  lem::Refusal refusal = lem::Refusal::none;
};

/// The best of `list` by `method`; nullptr: there is none.
lem::Critical* find_by(std::vector<lem::Critical>& list, lem::Method method) {
  const auto at = std::find_if(list.begin(), list.end(), [&](const lem::Critical& c) { return c.method == method; });
  return at == list.end() ? nullptr : &*at;
}

lem::Surface take_surface(const results::SlipSurface& told) {
  lem::Surface surface;
  surface.name = told.name.value_or("");
  surface.from = told.points.front()[0];
  surface.to = told.points.back()[0];
  if (told.circle)
    surface.circle = lem::Circle{told.circle->centre, told.circle->radius};
  else
    surface.line.assign(told.points.begin(), told.points.end());
  return surface;
}

bool is_better(const lem::Critical& one, const lem::Critical* other) {
  if (one.solution.refusal != lem::Refusal::none || !(one.solution.factor > 0)) return false;
  return other == nullptr || one.solution.factor < other->solution.factor * (1 - same_factor);
}

/// Search, or the surfaces of the case, at one time; it may begin with the polylines of others.
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

/// Tries the surfaces of other times at this one, and improves the best of them where it is lower. Returns whether one
/// was.
bool take_over(const std::vector<Moment>& others, const lem::SearchOptions& options, bool circular, Moment& moment) {
  bool any = false;
  auto& own = circular ? moment.circular : moment.noncircular;
  for (const lem::Method method : options.methods) {
    lem::Critical* mine = find_by(own, method);
    const lem::Surface* best = nullptr;
    double least = mine != nullptr ? mine->solution.factor * (1 - same_factor) : 1e9;
    for (const Moment& other : others)
      for (const lem::Critical& c : circular ? other.circular : other.noncircular) {
        if (c.method != method || &other == &moment) continue;
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

results::TimedFactor tell_moment(const lem::SearchOptions& options, const Moment& moment) {
  results::SliceResult slices;
  slices.methods = options.methods;
  const auto tell = [&](const std::vector<lem::Critical>& from, std::vector<results::CriticalSurface>& to) {
    for (const lem::Critical& c : from) to.push_back(tell_critical(*moment.slope, c));
  };
  tell(moment.circular, slices.critical);
  tell(moment.noncircular, slices.noncircular);
  tell(moment.given, slices.given);
  results::TimedFactor told;
  told.time = moment.time;
  if (const auto governing = results::find_governing_surface(slices, nullptr)) {
    told.factor = governing->found->surface.factor;
    told.surface = governing->found->surface;
    told.source = results::name_surface(*governing);
    told.refusal = governing->found->checks.refusal;
  }
  return told;
}

}  // namespace timeline

using namespace timeline;

struct TimelineRun::Parts {
  Parts(const input::Case& d, const RunOptions& o)
      : data(ground::close_sides(d)), options(o), search(make_search_options(data.lem, 1)) {}

  input::Case data;
  const RunOptions& options;
  lem::SearchOptions search;  ///< of one time: many times are searched side by side
  lem::Section section;
  mesh::Mesh<2> mesh, wet_mesh;
  std::vector<double> first_pressure;
  ground::FlowInTime<2> flow;
  std::vector<double> times;  ///< with 0
  std::vector<Moment> moments;
  ground::ToldWater water;
  results::Timeline told;

  void follow_water() {
    const Clock::time_point start = Clock::now();
    if (options.progress) options.progress->show("timeline: seepage");
    section = make_section(data).section;
    mesh = mesh::generate<2>(data.mesh);
    first_pressure = ground::find_nodal_pressure<2>(data, mesh, &water);
    const fem::SeepageModel<2> model = ground::make_seepage_model<2>(data, mesh, wet_mesh);
    std::vector<double> heads;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      heads.push_back(mesh.nodes[i][1] - first_pressure[i] / model.unit_weight);
    fem::SeepageSchedule schedule;
    schedule.outputs = list_times(data);
    schedule.head_tolerance = ground::head_tolerance;
    flow = ground::follow_flow<2>(data, model, heads, schedule, "[timeline]");
    times = {0};
    times.insert(times.end(), schedule.outputs.begin(), schedule.outputs.end());
    told.weather = ground::tell_season(flow.record);
    told.seepage_seconds = count_seconds(start);
  }

  const std::vector<double>& pressure(std::size_t number) const {
    return number == 0 ? first_pressure : flow.history.states[number - 1].pressure;
  }

  /// The state at a jump of a series is that before it.
  Moment make_moment(std::size_t number) const {
    Moment moment;
    moment.time = times[number];
    lem::Section now = section;
    set_pressures(data, mesh, pressure(number), moment.time + ground::find_first_time(data), now);
    moment.slope = std::make_unique<lem::Slope>(std::move(now));
    return moment;
  }

  void search_times(const results::SliceResult& first) {
    const Clock::time_point start = Clock::now();
    const input::Timeline& asked = *data.timeline;
    told.chosen = asked.times.empty();
    const int most = told.chosen ? asked.most_times : static_cast<int>(times.size());
    TimeChoice choice(times, asked.target, asked.tolerance, most);
    std::vector<std::size_t> numbers;
    const auto search_all = [&](const std::vector<std::size_t>& next) {
      if (options.progress) options.progress->show(fmt::format("timeline: {} searches", moments.size() + next.size()));
      std::vector<Moment> found(next.size());
      numbers.insert(numbers.end(), next.begin(), next.end());
      parallel_tasks(static_cast<int>(next.size()), options.threads, [&](int i) {
        Moment& moment = found[static_cast<std::size_t>(i)] = make_moment(next[static_cast<std::size_t>(i)]);
        search_moment(data, search, moments, moment);
      });
      std::move(found.begin(), found.end(), std::back_inserter(moments));
    };
    moments.push_back(take_first(first));
    numbers.push_back(0);
    search_all({times.size() - 1});  // the others begin with what these two know
    for (std::vector<std::size_t> next = told.chosen ? choice.next() : list_all(); !next.empty();
         next = choice.next()) {
      std::erase_if(next, [&](std::size_t n) { return std::find(numbers.begin(), numbers.end(), n) != numbers.end(); });
      search_all(next);
      share_surfaces();
      for (std::size_t i = 0; i < moments.size(); ++i) choice.set(numbers[i], tell_moment(search, moments[i]).factor);
      if (!told.chosen) break;
    }
    std::sort(moments.begin(), moments.end(), [](const Moment& a, const Moment& b) { return a.time < b.time; });
    if (told.chosen) told.distance = choice.find_distance();
    told.search_seconds = count_seconds(start);
  }

  /// Time 0, which the run has searched.
  Moment take_first(const results::SliceResult& first) const {
    Moment moment = make_moment(0);
    const auto take = [&](const std::vector<results::CriticalSurface>& from, std::vector<lem::Critical>& to) {
      for (const results::CriticalSurface& c : from)
        to.push_back(solve_surface(*moment.slope, take_surface(c.surface), c.surface.method, search));
    };
    take(first.critical, moment.circular);
    take(first.noncircular, moment.noncircular);
    take(first.given, moment.given);
    return moment;
  }

  std::vector<std::size_t> list_all() const {
    std::vector<std::size_t> all(times.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
  }

  /// A surface of one time is tried at all others, so that the curve has no scatter of the searches.
  void share_surfaces() {
    if (data.lem.search == input::SurfaceSearch::none) return;
    for (const bool circular : {true, false}) {
      for (int round = 0; round < most_rounds; ++round) {
        // All of a round see the surfaces of the one before: the same for any number of threads.
        std::vector<Moment> before(moments.size());
        for (std::size_t i = 0; i < moments.size(); ++i)
          (circular ? before[i].circular : before[i].noncircular) =
              circular ? moments[i].circular : moments[i].noncircular;
        std::vector<char> changed(moments.size(), 0);
        parallel_tasks(static_cast<int>(moments.size()), options.threads, [&](int i) {
          const auto k = static_cast<std::size_t>(i);
          changed[k] = take_over(before, search, circular, moments[k]) ? 1 : 0;
        });
        if (std::none_of(changed.begin(), changed.end(), [](char c) { return c != 0; })) break;
      }
    }
  }

  void conclude() {
    const input::Timeline& asked = *data.timeline;
    told.duration = asked.duration;
    told.target = asked.target;
    for (const Moment& moment : moments) {
      told.factors.push_back(tell_moment(search, moment));
      if (!told.factors.back().factor && !moment.error.empty())
        told.notes.push_back(fmt::format("no factor at {:g} s: {}", moment.time, moment.error));
    }
    note_refusals();
    const results::TimedFactor* last = nullptr;
    for (const results::TimedFactor& f : told.factors) {
      if (!f.factor) continue;
      if (!told.least || *f.factor < *told.least) told.least = f.factor, told.least_time = f.time;
      if (*f.factor < told.target && !told.failure && !told.fails_from_start) {
        if (last == nullptr)
          told.fails_from_start = true;
        else
          told.failure = {last->time, f.time, *last->factor, *f.factor};
      }
      last = &f;
    }
    keep_water();
  }

  /// Surfaces with lower factors that the checks refuse: the curve may be too high there.
  void note_refusals() {
    constexpr double noticeable = 0.99;
    std::vector<double> when;
    double least = std::numeric_limits<double>::infinity();
    const char* why = "";
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const Moment& m = moments[i];
      if (!told.factors[i].factor || m.refused_factor >= noticeable * *told.factors[i].factor) continue;
      when.push_back(m.time);
      if (m.refused_factor < least) least = m.refused_factor, why = lem::name_refusal(m.refusal);
    }
    if (when.empty()) return;
    told.notes.push_back(fmt::format(
        "at {} of {} times, from {} to {}, surfaces with lower factors, down to {:.3f}, are refused ({}): the factor "
        "may "
        "be lower there than it is shown",
        when.size(), moments.size(), units::say_time(when.front()), units::say_time(when.back()), least, why));
  }

  /// Where the water stood at the times of the factors.
  void keep_water() {
    if (!water.states || water.states->empty()) return;
    for (const Moment& moment : moments) {
      if (moment.time == 0) {
        told.states.push_back(water.states->back());
        continue;
      }
      const auto at = std::find(times.begin(), times.end(), moment.time);
      const auto& state = flow.history.states[static_cast<std::size_t>(at - times.begin()) - 1];
      told.states.push_back(ground::tell_state<2>(data, state, results::WaterFlow::transient, moment.time));
    }
  }
};

TimelineRun::TimelineRun(const input::Case& data, const RunOptions& options)
    : parts_(std::make_unique<Parts>(data, options)) {}
TimelineRun::~TimelineRun() = default;

void TimelineRun::calculate(const results::SliceResult& first) {
  parts_->follow_water();
  parts_->search_times(first);
  parts_->conclude();
  if (parts_->options.progress) parts_->options.progress->clear();
}

void TimelineRun::tell(results::RunResult& run) const {
  run.timeline = parts_->told;
  for (const std::string& note : parts_->told.notes) run.warnings.push_back("timeline: " + note);
}

}  // namespace talus::run
