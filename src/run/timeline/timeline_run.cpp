// SPDX-License-Identifier: MIT
#include "run/timeline/timeline_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>

#include "base/atomic_file.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/units.hpp"
#include "fem/seepage/seepage.hpp"
#include "mesh/generate.hpp"
#include "results/json.hpp"
#include "run/bounds/referee.hpp"
#include "run/fem/start_stress.hpp"
#include "run/lem/run_lem.hpp"
#include "run/lem/section_of_case.hpp"
#include "run/timeline/moment.hpp"
#include "run/timeline/times.hpp"
#include "site/ground_line.hpp"
#include "site/initial_water.hpp"
#include "site/pore_water.hpp"
#include "site/season.hpp"

namespace talus::run {
namespace {

constexpr const char* kept_file = "timeline.json";

using Clock = std::chrono::steady_clock;

double count_seconds(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

}  // namespace

struct TimelineRun::Parts {
  Parts(const input::Case& d, const RunOptions& o, std::string h)
      : given(d), data(site::close_sides(d)), options(o), hash(std::move(h)), search(make_search_options(data.lem, 1)) {
    mesh = mesh::generate<2>(data.mesh);
    model = site::make_seepage_model<2>(data, mesh, wet_mesh);
    summary.pool_loading = data.timeline->pool_loading;
    fem::check_storage(model);
  }

  const input::Case& given;
  input::Case data;  ///< with closed sides, for the seepage
  const RunOptions& options;
  const std::string hash;
  lem::SearchOptions search;  ///< for one time, with one thread: the times are searched in parallel
  mesh::Mesh<2> mesh, wet_mesh;
  fem::SeepageModel<2> model;
  lem::Section section;                ///< at time 0
  std::vector<double> first_pressure;  ///< at the nodes, positive in tension [Pa]
  site::FlowInTime<2> flow;
  std::vector<double> times;  ///< including 0
  std::vector<Moment> moments;
  std::vector<std::size_t> searched;  ///< indices of the times of the moments
  results::TimelineFile kept{hash, {}};
  std::vector<std::optional<double>> guide;  ///< least factor at every time of the surfaces that govern at some time
  site::WaterResult water;
  results::Timeline summary;
  std::optional<results::WaterFields> fields;

  void follow_water(const PreparedSlope& prepared) {
    const Clock::time_point start = Clock::now();
    if (options.progress) options.progress->show("timeline: seepage");
    section = prepared.slope->section();
    water = prepared.water;
    std::vector<double> heads;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      first_pressure.push_back(-section.pressure_grid->pressure[i]);
      heads.push_back(mesh.nodes[i][1] - first_pressure[i] / model.unit_weight);
    }
    fem::SeepageSchedule schedule;
    schedule.outputs = list_times(data);
    schedule.head_tolerance = site::head_tolerance;
    flow = site::follow_flow<2>(data, model, heads, schedule, "[timeline]");
    times = {0};
    times.insert(times.end(), schedule.outputs.begin(), schedule.outputs.end());
    summary.weather = site::make_season_result(flow.record);
    summary.step_error = flow.history.largest_error;
    summary.seepage_seconds = count_seconds(start);
  }

  const std::vector<double>& pressure(std::size_t number) const {
    return number == 0 ? first_pressure : flow.history.states[number - 1].pressure;
  }

  /// At a jump of a series the state is that before the jump.
  Moment make_moment(std::size_t number) const {
    Moment moment;
    moment.time = times[number];
    lem::Section now = section;
    set_pressures(data, mesh, pressure(number), moment.time + site::find_first_time(data), now);
    moment.slope = std::make_unique<lem::Slope>(std::move(now));
    return moment;
  }

  void search_times(const results::SliceResult& first) {
    const Clock::time_point start = Clock::now();
    const input::Timeline& asked = *data.timeline;
    summary.duration = asked.duration;
    if (data.initial.date) summary.start = format_date(data.initial.date->seconds);
    summary.target = asked.target;
    summary.chosen = asked.times.empty();
    const int most = summary.chosen ? asked.most_times : static_cast<int>(times.size());
    TimeChoice choice(times, asked.target, asked.tolerance, most);
    std::size_t guided = 0;  // number of moments whose surfaces are part of the guide
    guide.assign(times.size(), std::nullopt);
    moments.push_back(make_moment(0));
    take_known(first, search, moments.back());
    searched.push_back(0);
    for (const results::SearchedMoment& known : load_kept()) {
      searched.push_back(find_nearest(known.time));
      moments.push_back(make_moment(searched.back()));
      take_kept(known, search, moments.back());
    }
    search_more({times.size() - 1});  // all other searches start from these two
    for (std::vector<std::size_t> next = summary.chosen ? choice.next() : list_all(); !next.empty();
         next = choice.next()) {
      search_more(next);
      share();
      std::vector<results::TimedFactor> fresh;
      for (std::size_t i = 0; i < moments.size(); ++i) {
        results::TimedFactor factor = make_moment_result(search, moments[i]);
        choice.set(searched[i], factor.factor);
        if (i >= guided) fresh.push_back(std::move(factor));
      }
      if (!summary.chosen) break;
      guided = moments.size();
      extend_guide(fresh);
      choice.set_guide(guide);
    }
    if (summary.chosen) summary.distance = choice.find_distance();
    make_factors_result();
    if (asked.release && asked.release->criterion == input::ReleaseCriterion::equilibrium) find_loss();
    if (asked.release) search_releases();
    summary.search_seconds = count_seconds(start);
    if (data.lem.referee) judge_governing_times();
  }

  /// Compares the least factor, and those between which the slope fails, with the interval of limit analysis. If limit
  /// analysis rejects a factor, another time may govern, which is compared next.
  void judge_governing_times() {
    constexpr int most_times = 12;
    for (int judged = 0; judged < most_times; ++judged) {
      const auto is_governing = [&](double time) {
        return summary.least_time == time ||
               (summary.failure && (summary.failure->from == time || summary.failure->to == time));
      };
      const auto next = std::find_if(moments.begin(), moments.end(),
                                     [&](const Moment& m) { return !m.referee && is_governing(m.time); });
      if (next == moments.end()) return;
      const std::size_t number = searched[static_cast<std::size_t>(next - moments.begin())];
      next->referee = search_referee_interval(begin_at(number), find_factor(number), options);
      make_factors_result();
    }
  }

  /// Searches at those of the times that were not tried yet. Results are stored at once, so that an interrupted run
  /// resumes from them. Returns true if there was such a time.
  bool search_more(std::vector<std::size_t> next) {
    std::erase_if(next,
                  [&](std::size_t n) { return std::find(searched.begin(), searched.end(), n) != searched.end(); });
    if (next.empty()) return false;
    if (options.progress) options.progress->show(fmt::format("timeline: {} searches", moments.size() + next.size()));
    std::vector<Moment> found(next.size());
    std::mutex keeping;
    parallel_tasks(static_cast<int>(next.size()), options.threads, [&](int i) {
      Moment& moment = found[static_cast<std::size_t>(i)] = make_moment(next[static_cast<std::size_t>(i)]);
      throw_if_interrupted();
      search_moment(data, search, moments, moment);
      const std::lock_guard lock(keeping);
      kept.moments.push_back(keep_moment(moment));
      results::write_file(options.folder / kept_file, kept, -1);
    });
    searched.insert(searched.end(), next.begin(), next.end());
    std::move(found.begin(), found.end(), std::back_inserter(moments));
    return true;
  }

  void share() {
    if (data.lem.search != input::SurfaceSearch::none) share_surfaces(search, options.threads, moments);
  }

  /// Writes the factors of all tried times in order of time, and the times at which they pass the target.
  void make_factors_result() {
    summary.factors.clear();
    summary.fails_from_start = false;
    summary.failure.reset();
    summary.least.reset();
    for (const Moment& moment : moments) summary.factors.push_back(make_moment_result(search, moment));
    std::sort(summary.factors.begin(), summary.factors.end(),
              [](const auto& a, const auto& b) { return a.time < b.time; });
    results::find_failure(summary);
  }

  /// Searches at the times of release as well. A search there may find an earlier failure, whose times are then
  /// searched too.
  void search_releases() {
    for (auto at = find_release(); at; at = find_release()) {
      std::vector<std::size_t> next = find_beside(*at);
      next.push_back(*at);
      if (!search_more(next)) return;
      share();
      make_factors_result();
    }
  }

  /// Searches the loss of equilibrium by FEM, between two consecutive stored times. First the times of the searches
  /// are tried one after the other, then those in between by bisection.
  void find_loss() {
    results::EquilibriumLoss& loss = summary.equilibrium.emplace();
    const auto is_balanced = [&](std::size_t number) {
      if (options.progress)
        options.progress->show(fmt::format("timeline: equilibrium at {}", units::format_time(times[number])));
      ++loss.trials;
      const Balance found = find_balance(begin_at(number), options.threads);
      (found.stands ? loss.from : loss.to) = times[number];
      if (found.undecided)
        summary.notes.push_back(
            fmt::format("at {} FEM ran out of iterations before its soil flowed: with more `iterations` under [fem] it "
                        "may find equilibrium later than that",
                        units::format_time(times[number])));
      return found.stands;
    };
    std::vector<std::size_t> tried = searched;
    std::sort(tried.begin(), tried.end());
    auto fails = std::find_if_not(tried.begin(), tried.end(), is_balanced);
    if (fails == tried.end() || fails == tried.begin()) return;
    for (std::size_t low = *(fails - 1), high = *fails; high - low > 1;) {
      const std::size_t middle = low + (high - low) / 2;
      (is_balanced(middle) ? low : high) = middle;
    }
  }

  /// Reads the surfaces that an interrupted run has found at times after 0.
  std::vector<results::SearchedMoment> load_kept() {
    if (!options.resume) return {};
    auto known = results::find_file<results::TimelineFile>(options.folder / kept_file);
    if (known && known->input_hash == hash) kept = std::move(*known);
    return kept.moments;
  }

  /// Evaluates the surfaces that govern at some times at all times, which gives an upper limit of what searches there
  /// would find.
  void extend_guide(const std::vector<results::TimedFactor>& fresh) {
    parallel_tasks(static_cast<int>(times.size()), options.threads, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      const auto factor = try_surfaces(fresh, search, *make_moment(k).slope);
      if (factor && !(guide[k] && *guide[k] <= *factor)) guide[k] = factor;
    });
  }

  const input::Timeline& asked() const { return *data.timeline; }

  std::vector<std::size_t> list_all() const {
    std::vector<std::size_t> all(times.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
  }

  void conclude() {
    const input::Timeline& asked = *data.timeline;
    std::sort(moments.begin(), moments.end(), [](const Moment& a, const Moment& b) { return a.time < b.time; });
    for (std::size_t i = 0; i < moments.size(); ++i)
      if (!summary.factors[i].factor && !moments[i].error.empty())
        summary.notes.push_back(fmt::format("no factor at {:g} s: {}", moments[i].time, moments[i].error));
    note_refusals();
    note_sudden_pools();
    if (summary.distance && *summary.distance > asked.tolerance)
      summary.notes.push_back(
          fmt::format("after {} times straight lines between them may still be off by {:.2g} % of the "
                      "factor; a larger most_times or times of your own show more",
                      moments.size(), 100 * *summary.distance));
    keep_water();
  }

  std::size_t find_nearest(double time) const {
    const auto nearer = [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); };
    return static_cast<std::size_t>(std::min_element(times.begin(), times.end(), nearer) - times.begin());
  }

  /// Returns the index of the time of release to MPM.
  std::optional<std::size_t> find_release() const {
    const input::Release& asked = *data.timeline->release;
    std::optional<double> time = asked.time;
    if (asked.criterion == input::ReleaseCriterion::equilibrium) {
      time = summary.equilibrium->to;
    } else {
      if (!time && summary.fails_from_start) time = 0;
      if (!time && summary.failure) time = summary.failure->to;
    }
    return time ? std::optional(find_nearest(*time)) : std::nullopt;
  }

  /// Returns the stored times nearest to `apart` before and after the release; the adjacent ones if none is given.
  std::vector<std::size_t> find_beside(std::size_t at) const {
    const std::optional<double> apart = data.timeline->release->apart;
    std::vector<std::size_t> beside;
    if (apart == 0.0) return beside;
    const auto is_nearer = [&](std::size_t a, std::size_t b) {
      const auto miss = [&](std::size_t i) { return std::abs(std::abs(times[i] - times[at]) - apart.value_or(0)); };
      return miss(a) < miss(b);
    };
    std::vector<std::size_t> numbers = list_all();
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(at);
    if (middle != numbers.begin()) beside.push_back(*std::min_element(numbers.begin(), middle, is_nearer));
    if (middle + 1 != numbers.end()) beside.push_back(*std::min_element(middle + 1, numbers.end(), is_nearer));
    return beside;
  }

  std::optional<double> find_factor(std::size_t number) const {
    for (const results::TimedFactor& f : summary.factors)
      if (f.time == times[number]) return f.factor;
    return std::nullopt;
  }

  ReleaseCase make_release(std::size_t number) const {
    ReleaseCase release;
    release.summary.time = times[number];
    release.summary.factor = find_factor(number);
    release.data = begin_at(number);
    return release;
  }

  input::Case begin_at(std::size_t number) const {
    return begin_later(given, times[number], number == 0 ? nullptr : keep_state(number));
  }

  std::shared_ptr<const input::KnownWater> keep_state(std::size_t number) const {
    const fem::SeepageResult<2>& state = flow.history.states[number - 1];
    return std::make_shared<const input::KnownWater>(input::KnownWater{mesh, state.pressure, state.velocity});
  }

  /// Notes surfaces with lower factors that are rejected: the curve may be too high there.
  void note_refusals() {
    constexpr double noticeable = 0.99;
    std::vector<double> when;
    double least = std::numeric_limits<double>::infinity();
    const char* why = "";
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const Moment& m = moments[i];
      if (!summary.factors[i].factor || m.refused_factor >= noticeable * *summary.factors[i].factor) continue;
      when.push_back(m.time);
      if (m.refused_factor < least) least = m.refused_factor, why = lem::name_refusal(m.refusal);
    }
    if (when.empty()) return;
    summary.notes.push_back(fmt::format(
        "at {} of {} times, from {} to {}, surfaces with lower factors, down to {:.3f}, are refused ({}): the factor "
        "may be lower there than it is shown",
        when.size(), moments.size(), units::format_time(when.front()), units::format_time(when.back()), least, why));
  }

  /// Returns true if water of that level stands on the ground of a condition, and not on a side of the model or inside
  /// it.
  bool stands_on_ground(const input::Hydraulic& condition, double level) const {
    input::Case alone = data;
    alone.hydraulics = {condition};
    alone.hydraulics.front().head = {{0}, {level}};
    return !site::find_ponds(alone, site::find_ground(data.mesh), 0).empty();
  }

  /// Notes pools that change suddenly: the pore pressures just after depend on whether the weight of the water counts.
  void note_sudden_pools() {
    const bool gives_way = std::any_of(data.materials.begin(), data.materials.end(),
                                       [](const auto& m) { return m.second.water.compressibility > 0; });
    if (asked().pool_loading || !gives_way) return;
    for (const input::Hydraulic& h : data.hydraulics) {
      if (h.condition != input::WaterCondition::total_head) continue;
      for (std::size_t i = 1; i < h.head.time.size(); ++i) {
        const double at = h.head.time[i];
        const bool jumps = at == h.head.time[i - 1] && h.head.value[i] != h.head.value[i - 1];
        if (!jumps || at < 0 || at >= summary.duration ||
            !stands_on_ground(h, std::max(h.head.value[i], h.head.value[i - 1])))
          continue;
        const bool falls = h.head.value[i] < h.head.value[i - 1];
        summary.notes.push_back(fmt::format(
            "the pool on '{}' {} at once at {}, and total stress is taken as constant: right after, pore pressures are "
            "too "
            "{} and factors too {}; pool_loading = true lets its weight count",
            h.on, falls ? "falls" : "rises", units::format_time(at), falls ? "high" : "low", falls ? "low" : "high"));
      }
    }
  }

  /// Returns the field of time 0: that of the methods, if it is on this mesh.
  results::WaterField make_first_field() const {
    if (water.fields && water.fields->nodes.size() == mesh.nodes.size() && !water.fields->states.empty())
      return water.fields->states.back();
    results::WaterField first;
    first.flow = water.states->back().flow;
    for (const double p : first_pressure) first.pressure.push_back(-p);
    return first;
  }

  /// Stores the water levels and pressures at the times of the factors.
  void keep_water() {
    if (!water.states || water.states->empty()) return;
    fields = site::begin_fields(data, wet_mesh);
    for (const Moment& moment : moments) {
      if (moment.time == 0) {
        summary.states.push_back(water.states->back());
        if (fields) fields->states.push_back(make_first_field());
        continue;
      }
      const auto at = std::find(times.begin(), times.end(), moment.time);
      const auto& state = flow.history.states[static_cast<std::size_t>(at - times.begin()) - 1];
      summary.states.push_back(site::make_state_result<2>(data, state, results::WaterFlow::transient, moment.time));
      if (fields)
        fields->states.push_back(
            site::make_field_result<2>(wet_mesh, state, results::WaterFlow::transient, moment.time));
    }
  }
};

TimelineRun::TimelineRun(const input::Case& data, const RunOptions& options, std::string input_hash)
    : parts_(std::make_unique<Parts>(data, options, std::move(input_hash))) {}
TimelineRun::~TimelineRun() = default;

void TimelineRun::calculate(const PreparedSlope& prepared, const results::SliceResult& first) {
  parts_->follow_water(prepared);
  parts_->search_times(first);
  parts_->conclude();
  if (parts_->options.progress) parts_->options.progress->clear();
}

const results::WaterFields* TimelineRun::water_fields() const {
  return parts_->fields ? &*parts_->fields : nullptr;
}

std::vector<ReleaseCase> TimelineRun::list_releases() {
  const auto at = parts_->find_release();
  if (!at) {
    parts_->summary.notes.push_back(fmt::format(
        "MPM does not start: {}; [timeline.release] time starts it all the same",
        parts_->summary.equilibrium
            ? "FEM converges at every time that was tried"
            : fmt::format("the factor is not below {:g} at any time that was tried", parts_->summary.target)));
    return {};
  }
  std::vector<ReleaseCase> releases{parts_->make_release(*at)};
  for (const std::size_t beside : parts_->find_beside(*at)) {
    releases.push_back(parts_->make_release(beside));
    releases.back().summary.folder = beside < *at ? "released_earlier" : "released_later";
  }
  return releases;
}

std::vector<ReductionCase> TimelineRun::list_reductions() const {
  std::vector<double> times;
  if (const auto& asked = parts_->data.timeline->element_times)
    times = *asked;
  else if (parts_->summary.least_time)
    times = {*parts_->summary.least_time};
  std::vector<ReductionCase> reductions;
  for (const double time : times) {
    const std::size_t number = parts_->find_nearest(time);
    if (number == 0) continue;  // calculated by the run itself
    ReductionCase& reduction = reductions.emplace_back();
    reduction.summary.time = parts_->times[number];
    reduction.summary.folder = fmt::format("elements_{}", reductions.size());
    reduction.data = parts_->begin_at(number);
  }
  return reductions;
}

void TimelineRun::add_reduction(results::TimedReduction reduction) {
  parts_->summary.elements.push_back(std::move(reduction));
}

void TimelineRun::add_release(results::Release release) {
  parts_->summary.releases.push_back(std::move(release));
}

void TimelineRun::forget() const {
  remove_file(parts_->options.folder / kept_file);
}

void TimelineRun::write_result(results::RunResult& run) const {
  run.timeline = parts_->summary;
  for (const std::string& note : parts_->summary.notes) run.warnings.push_back("timeline: " + note);
}

}  // namespace talus::run
