// SPDX-License-Identifier: MIT
#include "study/slice_factor.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "lem/search/evaluator.hpp"
#include "run/lem/run_lem.hpp"
#include "run/lem/section_of_case.hpp"

namespace talus::study {
namespace {

/// Searches are made where one number is so many deviations of its score off, the others at their means: beyond that
/// one sample of twenty lies.
constexpr double corner_score = 2;

}  // namespace

SliceFactor::SliceFactor(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                         const SampledNumbers& sampled, const std::vector<lem::Surface>& surfaces)
    : base_(base),
      overrides_(overrides),
      sampled_(sampled),
      numbers_(base, overrides, sampled),
      options_(run::make_search_options(base.data.lem, 1)) {
  // The method that would govern a run.
  options_.methods = {
      *std::min_element(options_.methods.begin(), options_.methods.end(),
                        [](lem::Method a, lem::Method b) { return rank_equilibrium(a) < rank_equilibrium(b); })};
  if (is_full()) return;
  slope_ = std::make_unique<lem::Slope>(numbers_.middle());
  candidates_ = std::make_unique<lem::Candidates>(*slope_, surfaces, options_, method());
}

SliceFactor::SliceFactor(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                         const SampledNumbers& sampled, int threads)
    : SliceFactor(base, overrides, sampled, std::vector<lem::Surface>()) {
  options_.threads = threads;
  if (is_full()) return;
  std::vector<lem::Surface> given;
  for (const input::SlipSurface& s : base.data.lem.surfaces) given.push_back(run::make_surface(*slope_, s));
  if (searches()) {
    const std::vector<lem::Section> corners = make_corners();
    corners_ = static_cast<int>(corners.size());
    candidates_ = std::make_unique<lem::Candidates>(*slope_, corners, options_, method(), threads);
    if (!given.empty()) add(given);
  } else {
    candidates_ = std::make_unique<lem::Candidates>(*slope_, given, options_, method());
  }
}

std::vector<lem::Section> SliceFactor::make_corners() const {
  std::vector<lem::Section> corners;
  for (std::size_t i = 0; i < sampled_.means.size(); ++i)
    for (const double score : {-corner_score, corner_score}) {
      std::vector<double> corner = sampled_.means;
      corner[i] = sampled_.marginals[i].find_value(score);
      corners.push_back(numbers_.make_section(corner));
    }
  return corners;
}

std::vector<lem::Surface> SliceFactor::list_surfaces() const {
  std::vector<lem::Surface> all;
  for (int i = 0; i < count_surfaces(); ++i) all.push_back(candidates_->surface(i));
  return all;
}

void SliceFactor::add(const std::vector<lem::Surface>& surfaces) {
  if (!candidates_) return;
  std::vector<lem::Surface> all = list_surfaces();
  all.insert(all.end(), surfaces.begin(), surfaces.end());
  candidates_ = std::make_unique<lem::Candidates>(*slope_, all, options_, method());
}

std::optional<double> SliceFactor::find(const std::vector<double>& values, Workspace& work) const {
  if (is_full()) {
    const std::optional<Searched> searched = search(values);
    return searched ? std::optional(searched->factor) : std::nullopt;
  }
  if (work.soils.empty()) work.soils = numbers_.middle().soils;
  double horizontal = 0, vertical = 0;
  numbers_.apply(values, work.soils, horizontal, vertical);
  const double factor = candidates_->find_factor(work.soils, horizontal, vertical, work.candidates);
  return factor > 0 ? std::optional(factor) : std::nullopt;
}

std::optional<SliceFactor::Searched> SliceFactor::search(const std::vector<double>& values) const {
  lem::SearchOptions options = options_;
  options.threads = 1;
  Searched result;
  const auto take = [&](double factor) {
    if (factor > 0 && (result.factor == 0 || factor < result.factor)) result.factor = factor;
  };
  const lem::Slope slope(is_full() ? run::make_section(read_sample(base_, overrides_, sampled_, values).data).section
                                   : numbers_.make_section(values));
  lem::Evaluator evaluate(slope, method(), options.checks, options.slices);
  for (const input::SlipSurface& given : base_.data.lem.surfaces) {
    const double factor = evaluate(run::make_surface(slope, given));
    if (factor < lem::Evaluator::refused) take(factor);
  }
  if (searches()) {
    try {
      const lem::SearchResult found = lem::search(slope, options);
      for (const auto* list : {&found.circular, &found.noncircular})
        for (const lem::Critical& c : *list) {
          take(c.solution.factor);
          result.surfaces.push_back(c.surface);
        }
      for (const auto& minima : found.minima)
        for (const lem::Critical& c : minima) result.surfaces.push_back(c.surface);
    } catch (const Error& error) {
      if (error.code() == ExitCode::interrupted) throw;
      // No admissible surface: no factor of this sample.
    }
  }
  return result.factor > 0 ? std::optional(result) : std::nullopt;
}

}  // namespace talus::study
