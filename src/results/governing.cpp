// SPDX-License-Identifier: MIT
// The governing surface and factor, and the two factors that lie farthest apart.
#include "results/governing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "results/disagreement.hpp"

namespace talus::results {
namespace {

/// Returns the sort key of a surface; the surface with the smallest key governs.
std::tuple<bool, int, double> rank(const CriticalSurface& c) {
  return {!c.checks.refusal.empty(), rank_equilibrium(c.surface.method), *c.surface.factor};
}

bool is_possible(const CriticalSurface& c) {
  return c.verdict.value_or(Verdict::possible) == Verdict::possible;
}

bool has_verdict(const SliceResult& slices, Verdict verdict) {
  const auto has = [&](const std::vector<CriticalSurface>& list) {
    return std::any_of(list.begin(), list.end(), [&](const CriticalSurface& c) { return c.verdict == verdict; });
  };
  return has(slices.critical) || has(slices.noncircular) || has(slices.given);
}

/// Returns true if a method other than limit analysis had supports.
bool has_supports(const RunResult& run) {
  const auto crosses = [](const CriticalSurface& c) { return c.supports.has_value(); };
  if (run.slices)
    for (const auto* list : {&run.slices->critical, &run.slices->noncircular, &run.slices->given})
      if (std::any_of(list->begin(), list->end(), crosses)) return true;
  const auto holds = [](const ElementRun& r) { return r.supports.has_value(); };
  return run.supports || (run.elements && std::any_of(run.elements->runs.begin(), run.elements->runs.end(), holds));
}

/// Returns true if the pull of an active support has a part along the sliding of the base that it crosses.
bool may_be_driven(const CriticalSurface& c) {
  const SliceTable& t = c.slices;
  const auto drives = [&](const SupportForce& f) {
    for (std::size_t i = 0; f.is_active && i < t.size(); ++i) {
      if (f.crossing[0] < t.left[i] || f.crossing[0] > t.right[i]) continue;
      const Point &a = t.base_left[i], &b = t.base_right[i];
      const double along = f.direction[0] * (b[0] - a[0]) + f.direction[1] * (b[1] - a[1]);
      if (c.slides_left ? along < 0 : along > 0) return true;
    }
    return false;
  };
  return c.supports && std::any_of(c.supports->begin(), c.supports->end(), drives);
}

}  // namespace

std::string describe_side(const EarthquakeSide& side, const char* what) {
  const auto name = [](int direction) { return direction < 0 ? "smaller x" : "larger x"; };
  std::string text = fmt::format("the earthquake towards {} governs", name(side.direction));
  if (side.other_stable)
    text += fmt::format(" (towards {} {} {:.3f})", name(-side.direction), what, show_lower(*side.other_stable));
  return text;
}

namespace {

/// Returns the possible surface with the smallest factor.
std::optional<GoverningSurface> find_least_surface(const SliceResult& slices, const MethodComparison* methods) {
  std::optional<GoverningSurface> governing;
  const auto take = [&](const std::vector<CriticalSurface>& list, SurfaceSource source, const auto& name) {
    for (const CriticalSurface& c : list)
      if (c.surface.factor.value_or(0) > 0 && is_possible(c) && (!governing || rank(c) < rank(*governing->found)))
        governing = {&c, source, name(c)};
  };
  const auto follow = [](const char* path) {
    return [path](const CriticalSurface& c) { return std::string(path) + to_word(c.surface.method); };
  };
  take(slices.critical, SurfaceSource::critical, follow("lem."));
  take(slices.noncircular, SurfaceSource::noncircular, follow("lem.noncircular."));
  take(slices.given, SurfaceSource::given, [](const CriticalSurface& c) {
    return fmt::format("lem.surface[{}].{}", c.surface.name.value_or(""), to_word(c.surface.method));
  });
  if (methods != nullptr)
    take(methods->optimised, SurfaceSource::optimised,
         [](const CriticalSurface& c) { return c.surface.name.value_or(""); });
  return governing;
}

}  // namespace

std::optional<GoverningSurface> find_governing_surface(const SliceResult& slices, const MethodComparison* methods) {
  const auto least = find_least_surface(slices, methods);
  const bool is_missed = least && slices.search && slices.referee && slices.referee->lower &&
                         has_verdict(slices, Verdict::too_low) &&
                         *least->found->surface.factor > (1 + most_above_lower) * *slices.referee->lower;
  return is_missed ? std::nullopt : least;
}

std::optional<GoverningSurface> find_governing_surface(const RunResult& run) {
  if (!run.slices) return std::nullopt;
  return find_governing_surface(*run.slices, run.methods ? &*run.methods : nullptr);
}

std::string describe_ruled_out(const RunResult& run) {
  if (!run.slices || !run.slices->referee || !run.slices->referee->lower || find_governing_surface(run)) return "";
  const auto least = find_least_surface(*run.slices, run.methods ? &*run.methods : nullptr);
  if (!least) return "no factor by limit equilibrium is possible";
  return fmt::format(
      "lower factors by limit equilibrium are impossible, and the least possible one, {:.3f}, lies "
      "more than {:.0f} % above the lower bound",
      *least->found->surface.factor, 100 * most_above_lower);
}

std::string name_surface(const GoverningSurface& surface, const ShownUnits& units) {
  switch (surface.source) {
    case SurfaceSource::critical:
      return surface.found->crack
                 ? "critical circle with a tension crack of " + format_value(*surface.found->crack, units.length, 2)
                 : "critical circle";
    case SurfaceSource::noncircular:
      return "critical polyline";
    case SurfaceSource::given:
      return fmt::format("given surface '{}'", surface.found->surface.name.value_or(""));
    default:
      return "polyline optimised from another method's";
  }
}

Verdict judge(const Referee& referee, const CriticalSurface& surface) {
  Verdict verdict = referee.judge(*surface.surface.factor);
  if (!surface.supports) return verdict;
  // The heads of supports leave no upper bound, and without one there is no width that could make the lower one unsafe:
  // where it rules factors out, the factor that governs is at most `most_above_lower` above it.
  if (referee.lower && !referee.upper && !referee.upper_only &&
      *surface.surface.factor < (1 - judging_tolerance) * show_lower(*referee.lower))
    verdict = Verdict::too_low;
  return verdict == Verdict::too_low && may_be_driven(surface) ? Verdict::possible : verdict;
}

void take_referee(Referee referee, SliceResult& slices) {
  if (!referee.why_not)
    for (auto* list : {&slices.critical, &slices.noncircular, &slices.given})
      for (CriticalSurface& c : *list) {
        if (!c.surface.factor) continue;
        c.verdict = judge(referee, c);
        // Without a search the factor belongs to one given surface, which may lie above the bound of the slope because
        // another mechanism governs.
        if (c.verdict == Verdict::too_high && !slices.search) c.verdict = Verdict::possible;
      }
  slices.referee = std::move(referee);
}

std::optional<double> find_slices_factor(const SliceResult& slices, const MethodComparison* methods) {
  if (const auto governing = find_governing_surface(slices, methods)) return governing->found->surface.factor;
  if (!slices.referee) return std::nullopt;
  if (has_verdict(slices, Verdict::too_low)) return slices.referee->lower;
  return has_verdict(slices, Verdict::too_high) ? slices.referee->upper : std::nullopt;
}

std::optional<double> find_slices_factor(const RunResult& run) {
  if (!run.slices) return std::nullopt;
  return find_slices_factor(*run.slices, run.methods ? &*run.methods : nullptr);
}

std::optional<double> find_points_factor(const RunResult& run) {
  if (!run.factor_of_safety) return std::nullopt;
  if (run.factor_of_safety->value) return run.factor_of_safety->value;
  if (run.factor_of_safety->criteria)
    for (const Criterion& c : *run.factor_of_safety->criteria)
      if (c.factor) return c.factor;
  return std::nullopt;
}

const ElementRun* find_governing_elements(const RunResult& run) {
  if (run.elements)
    for (const ElementRun& r : run.elements->runs)
      if (r.verdict != Verdict::too_low) return &r;
  return nullptr;
}

std::optional<double> find_main_factor(const RunResult& run) {
  std::optional<double> least;
  const auto take = [&](std::optional<double> f) {
    if (f) least = std::min(least.value_or(*f), *f);
  };
  take(find_slices_factor(run));
  if (const ElementRun* elements = find_governing_elements(run)) take(elements->factor);
  take(find_points_factor(run));
  if (run.construction) take(run.construction->least);
  if (run.timeline) {
    take(run.timeline->least);
    if (const TimedReduction* elements = find_least_reduction(*run.timeline)) take(elements->runs.front().factor);
  }
  if (!run.bounds || run.bounds->is_davis) return least;
  // The upper bound of limit analysis limits the factors of the other methods, except with supports: its mechanism may
  // be that of the soil below their heads. With limit analysis alone the lower bound is the result.
  if (least && has_supports(run)) return least;
  take(least ? run.bounds->upper : run.bounds->lower);
  return least;
}

std::optional<ProvenEnd> find_proven_end(const RunResult& run) {
  const std::optional<double> main = find_main_factor(run);
  if (!main) return std::nullopt;
  std::optional<ProvenEnd> end;
  const auto compare = [&](const std::optional<double>& lower, const std::optional<double>& upper) {
    if (main == lower) end = ProvenEnd::lower;
    if (main == upper) end = ProvenEnd::upper;
  };
  if (run.bounds) compare(run.bounds->lower, run.bounds->upper);
  if (run.slices && run.slices->referee) compare(run.slices->referee->lower, run.slices->referee->upper);
  return end;
}

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A factor, or the interval between two bounds.
struct Part {
  std::string title;
  double lower = 0, upper = infinite;
  bool is_proven = false;    ///< bounds
  bool is_of_given = false;  ///< of a given surface without a search, beside which others may have a smaller factor
};

std::string write(const Part& part, bool is_low) {
  if (!part.is_proven) return fmt::format("{} {:.3f}", part.title, part.lower);
  return is_low ? fmt::format("{} at most {:.3f}", part.title, show_upper(part.upper))
                : fmt::format("{} at least {:.3f}", part.title, show_lower(part.lower));
}

/// Compares the factors of one state after the other and keeps the worst pair.
class Search {
 public:
  void add(const std::string& title, std::optional<double> factor, bool is_of_given = false) {
    if (factor.value_or(0) > 0) parts_.push_back({title, *factor, *factor, false, is_of_given});
  }

  void add_bounds(std::optional<double> lower, std::optional<double> upper) {
    if (lower || upper) parts_.push_back({"limit analysis", lower.value_or(0), upper.value_or(infinite), true});
  }

  /// Compares the factors added since the last call. `state`: such as " at 3 d".
  void compare(const std::string& state = "") {
    for (const Part& low : parts_)
      for (const Part& high : parts_) take(low, high, state);
    parts_.clear();
  }

  std::optional<Disagreement> found;

 private:
  void take(const Part& low, const Part& high, const std::string& state) {
    const double ratio = high.lower / low.upper;
    if (low.is_proven && high.is_of_given) return;
    if (!(ratio > (found ? found->ratio : largest_ratio))) return;
    found = {low.title, high.title, low.upper, high.lower, ratio, {}};
    found->text = fmt::format(
        "The methods disagree by a factor of {:.1f}{}: {}, {}; neither may be used before the reason is found.", ratio,
        state, write(low, true), write(high, false));
  }

  std::vector<Part> parts_;
};

bool is_admissible(const CriticalSurface& c) {
  return c.surface.factor && c.checks.refusal.empty() && c.verdict.value_or(Verdict::possible) == Verdict::possible;
}

/// Compares the methods of LEM by their searches, and on each given surface.
void compare_slices(const SliceResult& slices, const MethodComparison* methods, Search& search) {
  std::map<SliceMethod, double> least;
  const auto take = [&](const std::vector<CriticalSurface>& list) {
    for (const CriticalSurface& c : list)
      if (is_admissible(c)) {
        const auto [entry, is_new] = least.try_emplace(c.surface.method, *c.surface.factor);
        if (!is_new) entry->second = std::min(entry->second, *c.surface.factor);
      }
  };
  take(slices.critical);
  take(slices.noncircular);
  if (methods != nullptr) take(methods->optimised);
  for (const auto& [method, factor] : least) search.add(fmt::format("LEM ({})", get_title(method)), factor);
  search.compare();
  std::map<std::string, std::vector<const CriticalSurface*>> by_name;
  for (const CriticalSurface& c : slices.given)
    if (is_admissible(c)) by_name[c.surface.name.value_or("")].push_back(&c);
  for (const auto& [name, list] : by_name) {
    for (const CriticalSurface* c : list)
      search.add(fmt::format("LEM ({})", get_title(c->surface.method)), c->surface.factor);
    search.compare(fmt::format(" on the given surface '{}'", name));
  }
}

void compare_methods(const RunResult& run, Search& search) {
  if (const auto governing = find_governing_surface(run))
    search.add(fmt::format("LEM ({}, {})", get_title(governing->found->surface.method),
                           name_surface(*governing, read_units(run))),
               governing->found->surface.factor, !run.slices->search);
  if (run.elements)
    for (const ElementRun& r : run.elements->runs)
      if (r.verdict != Verdict::too_low) search.add(fmt::format("FEM ({})", name_flow(r)), r.factor);
  search.add("MPM", find_points_factor(run));
  if (run.bounds && !run.bounds->error && !run.bounds->is_davis)
    search.add_bounds(run.bounds->lower, run.bounds->upper);
  else if (run.slices && run.slices->referee && !run.slices->referee->why_not)
    search.add_bounds(run.slices->referee->upper_only ? std::nullopt : run.slices->referee->lower,
                      run.slices->referee->upper);
  search.compare();
}

void compare_in_time(const Timeline& timeline, Search& search) {
  for (const TimedReduction& reduction : timeline.elements) {
    for (const TimedFactor& f : timeline.factors)
      if (f.time == reduction.time && f.refusal.empty()) search.add("LEM", f.factor);
    for (const ElementRun& r : reduction.runs) search.add(fmt::format("FEM ({})", name_flow(r)), r.factor);
    search.compare(" at " + format_moment(timeline, reduction.time));
  }
}

/// Factors with and without drainage are of different states.
void compare_stages(const Construction& construction, Search& search) {
  for (const ConstructionStage& stage : construction.stages)
    for (const bool undrained : {false, true}) {
      for (const StageFactor& f : stage.factors) {
        if (f.undrained.value_or(false) != undrained) continue;
        if (f.method == Method::bounds)
          search.add_bounds(f.lower, f.upper);
        else
          search.add(f.title, f.factor);
      }
      search.compare(fmt::format(" at the end of stage '{}'", stage.name));
    }
}

}  // namespace

std::optional<Disagreement> find_disagreement(const RunResult& run) {
  Search search;
  if (run.slices) compare_slices(*run.slices, run.methods ? &*run.methods : nullptr, search);
  compare_methods(run, search);
  if (run.timeline) compare_in_time(*run.timeline, search);
  if (run.construction) compare_stages(*run.construction, search);
  return std::move(search.found);
}

void take_motion(const RunResult& run, Release& out) {
  if (run.stress_start) out.start_factor = run.stress_start->factor;
  if (run.stages && run.stages->size() > 1) out.rests = run.stages->front().end == StageEnd::rest;
  if (!run.runout) return;
  out.largest_displacement = run.runout->largest_displacement;
  out.moved_volume = run.runout->moved_volume;
  out.front_advance = run.runout->front_advance;
  out.toe_distance = run.runout->toe_distance;
  out.mass_front_advance = run.runout->mass_front_advance;
  out.front_uncertainty = RunoutEstimates(*run.runout).front_advance.uncertainty();
  out.coarser_mesh = run.runout->coarser_mesh;
  out.undetermined = run.runout->undetermined;
  out.limits = run.runout->limits;
}

RunResult::RunResult() = default;
RunResult::RunResult(const RunResult&) = default;
RunResult::RunResult(RunResult&&) noexcept = default;
RunResult& RunResult::operator=(const RunResult&) = default;
RunResult& RunResult::operator=(RunResult&&) noexcept = default;
RunResult::~RunResult() = default;

}  // namespace talus::results
