// SPDX-License-Identifier: MIT
#include "run/construction/stage_factors.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/atomic_file.hpp"
#include "base/user_file.hpp"
#include "input/case/support.hpp"
#include "input/echo.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"
#include "run/bounds/bounds_run.hpp"
#include "run/bounds/referee.hpp"
#include "run/common/head.hpp"
#include "run/common/method_run.hpp"
#include "run/compare/compare.hpp"
#include "run/construction/undrained_strengths.hpp"
#include "run/fem/element_run.hpp"
#include "run/lem/slice_run.hpp"
#include "site/site.hpp"

namespace talus::run {
namespace {

results::StageFactor make_slices_factor(const results::RunResult& run) {
  results::StageFactor factor{Method::lem, "LEM", {}, {}, {}, {}};
  if (!run.slices) return factor;
  factor.factor = results::find_slices_factor(run);
  factor.error = run.slices->error;
  if (const auto governing = results::find_governing_surface(run))
    factor.title = fmt::format("LEM, {}, {}", governing->found->surface.title,
                               results::name_surface(*governing, results::read_units(run)));
  else if (factor.factor)
    factor.title = "limit analysis, which rules out the factors of LEM";
  return factor;
}

results::StageFactor make_elements_factor(const results::RunResult& run) {
  results::StageFactor factor{Method::fem, "FEM", {}, {}, {}, {}};
  if (!run.elements) return factor;
  factor.error = run.elements->error;
  if (const results::ElementRun* found = results::find_governing_elements(run)) {
    factor.title = "FEM, " + results::name_flow(*found);
    factor.factor = found->factor;
    if (found->interval) factor.lower = found->interval->lower, factor.upper = found->interval->upper;
  }
  return factor;
}

/// The lower bound, on the safe side.
results::StageFactor make_bounds_factor(const results::RunResult& run) {
  results::StageFactor factor{Method::bounds, "limit analysis, lower bound", {}, {}, {}, {}};
  if (!run.bounds) return factor;
  factor.error = run.bounds->error;
  factor.factor = factor.lower = run.bounds->lower;
  factor.upper = run.bounds->upper;
  return factor;
}

}  // namespace

StageFactors find_stage_factors(const input::LoadedCase& loaded, const input::Case& later, const std::string& title,
                                const RunOptions& options, const std::string& hash,
                                const std::vector<fem::KnownSpring>& known) {
  make_folder(options.folder);
  const site::Site site(later);
  results::RunResult run = begin_result(loaded, hash, options.threads);
  run.title = title;
  run.input = input::drop_absent(run.input, later);
  run.outlines.clear();
  for (const mesh::Polygon& p : later.mesh.polygons) run.outlines.emplace_back(p.points.begin(), p.points.end());
  std::optional<SliceRun> slices;
  std::optional<ElementRun<2>> elements;
  std::optional<BoundsRun> bounds;
  std::vector<results::StageFactor> factors;
  const auto fails = [&](Method method, const char* name, auto&& part) {
    const auto why = attempt(options, false, part);
    if (why) factors.push_back({method, name, {}, {}, {}, *why});
    return why.has_value();
  };
  if (input::uses(later, Method::lem) && !fails(Method::lem, "LEM", [&] {
        slices.emplace(site, false, options, hash).calculate();
        if (slices->needs_referee()) slices->take_referee(search_referee_interval(later, std::nullopt, options));
        slices->keep();
        slices->write_result(run);
      }))
    factors.push_back(make_slices_factor(run));
  if (input::uses(later, Method::fem) && !fails(Method::fem, "FEM", [&] {
        elements.emplace(site, false, options, hash).start_supports(known);
        elements->prepare();
        elements->calculate();
        elements->write_result(run);
      }))
    factors.push_back(make_elements_factor(run));
  if (input::uses(later, Method::bounds) && !fails(Method::bounds, "limit analysis", [&] {
        bounds.emplace(site, false, options, hash).prepare();
        bounds->calculate(factors.empty() ? std::nullopt : factors.front().factor);
        bounds->write_result(run);
      }))
    factors.push_back(make_bounds_factor(run));
  run.methods = compare_methods(later, slices ? slices->slope() : nullptr, run, options.folder, options.threads);
  // The comparison finds weaker surfaces of LEM, as without stages.
  for (results::StageFactor& factor : factors)
    if (slices && factor.method == Method::lem && factor.factor) factor = make_slices_factor(run);
  run.warnings.insert(run.warnings.begin(), run.methods->warnings.begin(), run.methods->warnings.end());
  run.status = results::Status::finished;
  run.results = list_results(later, run);
  results::write_file(options.folder / "summary.json", run);
  return {std::move(factors), std::move(run.warnings)};
}

StageFactors find_undrained_factors(const input::LoadedCase& loaded, const input::Case& later, const std::string& title,
                                    const RunOptions& options, const std::string& hash, double guess) {
  constexpr int most_repetitions = 8;
  constexpr double closeness = 1e-3;  // of the factors of two repetitions
  const UndrainedStrengths strengths(later);
  StageFactors all;
  if (strengths.empty()) return all;
  for (const auto& [method, name] : {std::pair{Method::lem, "LEM"}, {Method::bounds, "limit analysis, lower bound"}}) {
    if (!input::uses(later, method)) continue;
    results::StageFactor& out = all.factors.emplace_back();
    out = {method, fmt::format("{}, failure without drainage", name), {}, {}, {}, {}, true};
    const bool has_walls = std::any_of(later.supports.begin(), later.supports.end(),
                                       [](const auto& s) { return s.second.kind == input::SupportKind::wall; });
    if (!strengths.fault().empty() || (has_walls && method == Method::bounds)) {
      out.error = !strengths.fault().empty() ? strengths.fault()
                                             : "the strength of the interfaces of walls without drainage is not known";
      continue;
    }
    const RunOptions own =
        options.make_nested(join_name(options.folder, std::string("undrained_") + results::to_word(method)));
    std::vector<std::string> warnings;
    double factor = guess;
    for (int k = 0; k < most_repetitions; ++k) {
      input::Case made = strengths.make_case(factor);
      made.methods = {method};
      StageFactors found = find_stage_factors(loaded, made, title + ", failure without drainage", own,
                                              fmt::format("{}-{}-{}", hash, results::to_word(method), k));
      out.title = found.factors.front().title + ", failure without drainage";
      out.error = found.factors.front().error;
      out.factor = found.factors.front().factor;
      warnings = std::move(found.warnings);
      if (!out.factor) break;
      const double next = *out.factor;
      out.factor = strengths.correct(next, factor);
      if (std::abs(next - factor) < closeness * next) break;
      factor = next;
    }
    all.warnings.insert(all.warnings.end(), warnings.begin(), warnings.end());
  }
  return all;
}

}  // namespace talus::run
