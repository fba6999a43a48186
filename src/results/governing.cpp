// SPDX-License-Identifier: MIT
#include "results/governing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

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

}  // namespace

std::string describe_side(const EarthquakeSide& side, const char* what) {
  const auto name = [](int direction) { return direction < 0 ? "smaller x" : "larger x"; };
  std::string text = fmt::format("the earthquake towards {} governs", name(side.direction));
  if (side.other_stable)
    text += fmt::format(" (towards {} {} {:.3f})", name(-side.direction), what, show_lower(*side.other_stable));
  return text;
}

std::optional<GoverningSurface> find_governing_surface(const SliceResult& slices, const MethodComparison* methods) {
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

std::optional<GoverningSurface> find_governing_surface(const RunResult& run) {
  if (!run.slices) return std::nullopt;
  return find_governing_surface(*run.slices, run.methods ? &*run.methods : nullptr);
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

void take_referee(Referee referee, SliceResult& slices) {
  if (!referee.why_not)
    for (auto* list : {&slices.critical, &slices.noncircular, &slices.given})
      for (CriticalSurface& c : *list) {
        if (!c.surface.factor) continue;
        c.verdict = referee.judge(*c.surface.factor);
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

void take_motion(const RunResult& run, Release& out) {
  if (run.stress_start) out.start_factor = run.stress_start->factor;
  if (run.stages && run.stages->size() > 1) out.rests = run.stages->front().end == StageEnd::rest;
  if (!run.runout) return;
  out.largest_displacement = run.runout->largest_displacement;
  out.moved_volume = run.runout->moved_volume;
  out.front_advance = run.runout->front_advance;
  out.toe_distance = run.runout->toe_distance;
  out.front_uncertainty = RunoutUncertainty(*run.runout).front_advance;
  out.limits = run.runout->limits;
}

RunResult::RunResult() = default;
RunResult::RunResult(const RunResult&) = default;
RunResult::RunResult(RunResult&&) noexcept = default;
RunResult& RunResult::operator=(const RunResult&) = default;
RunResult& RunResult::operator=(RunResult&&) noexcept = default;
RunResult::~RunResult() = default;

}  // namespace talus::results
