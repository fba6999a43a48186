// SPDX-License-Identifier: MIT
#include "results/interval.hpp"

#include <algorithm>

#include "base/extrapolate.hpp"
#include "results/governing.hpp"

namespace talus::results {
namespace {

constexpr const char* by_bounds = "limit analysis";
/// Differences below this fraction of an estimated interval do not narrow the value that is searched.
constexpr double significant_part = 0.1;

ResultInterval make_bounds_interval(const RunResult& run) {
  if (!run.bounds || (!run.bounds->lower && !run.bounds->upper)) return {};
  return {run.bounds->lower, run.bounds->upper, 0, by_bounds};
}

ResultInterval make_referee_interval(const RunResult& run) {
  if (!run.slices || !run.slices->referee || run.slices->referee->why_not) return {};
  const Referee& referee = *run.slices->referee;
  if (!referee.lower && !referee.upper) return {};
  return {referee.upper_only ? std::nullopt : referee.lower, referee.upper, 0, by_bounds};
}

/// Returns the interval of limit analysis if the factor lies in it and belongs to a search: a given surface is not the
/// weakest one.
ResultInterval make_slices_interval(const RunResult& run, std::optional<double> factor) {
  if (!factor || !run.slices->search) return {};
  const auto& referee = run.slices->referee;
  if (!referee || referee->judge(*factor) != Verdict::possible) return {};
  // Printed bounds, by which a factor is judged, are rounded outward.
  ResultInterval interval = make_referee_interval(run);
  if (interval.lower) *interval.lower = std::min(*interval.lower, *factor);
  if (interval.upper) *interval.upper = std::max(*interval.upper, *factor);
  return interval;
}

ResultInterval make_elements_interval(const ElementRun& run) {
  ResultInterval interval;
  interval.resolution = run.failed - run.stable;
  if (!run.interval) return interval;
  interval.lower = run.interval->lower, interval.upper = run.interval->upper;
  interval.resolution = std::max(interval.resolution, significant_part * (run.interval->upper - run.interval->lower));
  interval.source = "FEM, mesh and search";
  return interval;
}

ResultInterval make_points_interval(const PointFactors& factors) {
  ResultInterval interval;
  if (!factors.frozen) return interval;
  interval.resolution = 2 * factors.frozen->bracket;
  interval.lower = factors.frozen->lower(), interval.upper = factors.frozen->upper();
  if (!interval.lower) return interval;
  interval.resolution = std::max(interval.resolution, significant_part * (*interval.upper - *interval.lower));
  interval.source = "MPM, mesh and search";
  return interval;
}

ResultInterval make_criterion_interval(const PointFactors& factors, const std::string& word) {
  for (const Criterion& c : factors.criteria.value_or(std::vector<Criterion>{}))
    if (word == to_word(c.kind) && c.lower && c.upper) return {c.lower, c.upper, 0, "MPM, neighbouring trials"};
  return {};
}

enum class Owner { none, slices, elements, points, bounds };

/// Returns the method whose factor equals the main factor.
Owner find_owner(const RunResult& run) {
  const std::optional<double> main = find_main_factor(run);
  if (!main) return Owner::none;
  if (run.slices && find_slices_factor(run) == main) return Owner::slices;
  if (const ElementRun* elements = find_governing_elements(run); elements != nullptr && elements->factor == *main)
    return Owner::elements;
  if (find_points_factor(run) == main) return Owner::points;
  return run.bounds && (run.bounds->lower == main || run.bounds->upper == main) ? Owner::bounds : Owner::none;
}

ResultInterval find_main_interval(const RunResult& run) {
  switch (find_owner(run)) {
    case Owner::slices:
      return find_governing_surface(run) ? make_slices_interval(run, find_slices_factor(run))
                                         : make_referee_interval(run);
    case Owner::elements:
      return make_elements_interval(*find_governing_elements(run));
    case Owner::points:
      return make_points_interval(*run.factor_of_safety);
    case Owner::bounds:
      return make_bounds_interval(run);
    default:
      return {};
  }
}

/// Returns the factor of a critical circle or polyline by its name; nullopt for other names.
std::optional<double> find_searched_factor(const RunResult& run, const std::string& name) {
  const std::string circle = "lem.", polyline = "lem.noncircular.";
  for (const CriticalSurface& c : run.slices->critical)
    if (name == circle + to_word(c.surface.method)) return c.surface.factor;
  for (const CriticalSurface& c : run.slices->noncircular)
    if (name == polyline + to_word(c.surface.method)) return c.surface.factor;
  return std::nullopt;
}

}  // namespace

ResultInterval find_interval(const RunResult& run, const std::string& name) {
  if (name == "main_factor") return find_main_interval(run);
  if (name.starts_with("bounds.")) return make_bounds_interval(run);
  if (name.starts_with("lem.referee.")) return make_referee_interval(run);
  if (name == "lem.factor" && run.slices)
    return find_governing_surface(run) ? make_slices_interval(run, find_slices_factor(run))
                                       : make_referee_interval(run);
  if (name.starts_with("lem.") && run.slices) return make_slices_interval(run, find_searched_factor(run, name));
  if (run.elements)
    for (const ElementRun& elements : run.elements->runs)
      if (name == (elements.flow == Flow::associated ? "fem.associated.factor" : "fem.factor"))
        return make_elements_interval(elements);
  if (!run.factor_of_safety) return {};
  const std::string criterion = "factor_of_safety.";
  if (name == "factor_of_safety" || name == "factor_of_safety.frozen")
    return make_points_interval(*run.factor_of_safety);
  if (name.starts_with(criterion)) return make_criterion_interval(*run.factor_of_safety, name.substr(criterion.size()));
  return {};
}

std::optional<FarExtrapolation> find_far_extrapolation(const RunResult& run) {
  if (find_owner(run) != Owner::elements) return std::nullopt;
  const ElementRun& elements = *find_governing_elements(run);
  if (!elements.meshes || elements.meshes->empty() || !elements.interval) return std::nullopt;
  const ElementMeshFactor& fine = elements.meshes->back();
  const double fraction = 1 - elements.factor / fine.factor;
  if (!(fraction > most_extrapolated)) return std::nullopt;
  return FarExtrapolation{fraction, fine.size, elements.interval->lower, elements.interval->upper};
}

std::string name_main_method(const RunResult& run) {
  switch (find_owner(run)) {
    case Owner::slices: {
      const auto governing = find_governing_surface(run);
      return governing ? governing->name : "limit analysis";
    }
    case Owner::elements:
      return find_governing_elements(run)->flow == Flow::associated ? "fem.associated" : "fem";
    case Owner::points:
      return "mpm";
    case Owner::bounds:
      return run.bounds->lower == find_main_factor(run) ? "lower bound" : "upper bound";
    default:
      return find_main_factor(run) ? "timeline" : "";
  }
}

}  // namespace talus::results
