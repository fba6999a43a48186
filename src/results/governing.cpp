// SPDX-License-Identifier: MIT
#include "results/governing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace talus::results {
namespace {

/// The smaller, the more it governs.
std::tuple<bool, int, double> rank(const CriticalSurface& c) {
  return {!c.checks.refusal.empty(), rank_equilibrium(c.surface.method), *c.surface.factor};
}

}  // namespace

std::optional<GoverningSurface> find_governing_surface(const SliceResult& slices, const MethodComparison* methods) {
  std::optional<GoverningSurface> governing;
  const auto take = [&](const std::vector<CriticalSurface>& list, SurfaceSource source, const auto& name) {
    for (const CriticalSurface& c : list)
      if (c.surface.factor.value_or(0) > 0 && (!governing || rank(c) < rank(*governing->found)))
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

std::string name_surface(const GoverningSurface& surface) {
  switch (surface.source) {
    case SurfaceSource::critical:
      return "critical circle";
    case SurfaceSource::noncircular:
      return "critical polyline";
    case SurfaceSource::given:
      return fmt::format("given surface '{}'", surface.found->surface.name.value_or(""));
    default:
      return "polyline optimised from another method's";
  }
}

std::optional<double> find_points_factor(const RunResult& run) {
  if (!run.factor_of_safety) return std::nullopt;
  if (run.factor_of_safety->value) return run.factor_of_safety->value;
  if (run.factor_of_safety->criteria)
    for (const Criterion& c : *run.factor_of_safety->criteria)
      if (c.factor) return c.factor;
  return std::nullopt;
}

std::optional<double> find_elements_factor(const RunResult& run) {
  return run.elements && !run.elements->runs.empty() ? std::optional(run.elements->runs.front().factor) : std::nullopt;
}

std::optional<double> find_main_factor(const RunResult& run) {
  std::optional<double> least;
  const auto take = [&](std::optional<double> f) {
    if (f) least = std::min(least.value_or(*f), *f);
  };
  if (const auto governing = find_governing_surface(run)) take(governing->found->surface.factor);
  take(find_elements_factor(run));
  take(find_points_factor(run));
  if (run.timeline) {
    take(run.timeline->least);
    if (const TimedReduction* elements = find_least_reduction(*run.timeline)) take(elements->runs.front().factor);
  }
  if (!run.bounds || run.bounds->is_davis) return least;
  // What is proven is no estimate: an upper bound lowers what others found, and bounds alone answer with the lower one.
  take(least ? run.bounds->upper : run.bounds->lower);
  return least;
}

bool is_main_factor_proven(const RunResult& run) {
  const std::optional<double> main = find_main_factor(run);
  return main && run.bounds && (main == run.bounds->lower || main == run.bounds->upper);
}

}  // namespace talus::results
