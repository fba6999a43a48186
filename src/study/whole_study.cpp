// SPDX-License-Identifier: MIT
#include "study/whole_study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "run/forecast/forecast.hpp"
#include "study/sampling.hpp"
#include "study/study_table.hpp"

namespace talus::study {
namespace {

/// A forecast is made of so many variants, evenly among all, because material points are stepped for each.
constexpr std::size_t most_forecasts = 6;
/// Searches before samples by slices: at the means, and for first-order estimate and design point.
constexpr double searches = 4;

std::string count(double n, const char* one, const char* many) {
  return fmt::format("{:.0f} {}", n, n == 1 ? one : many);
}

double find_seconds(const input::Case& data) {
  double seconds = 0;
  for (const run::MethodForecast& f : run::forecast(data, true)) seconds += f.seconds;
  return seconds;
}

/// Empty where nothing is known.
std::string add_time(double seconds) {
  return seconds > 0 ? ", about " + run::write_time(seconds) : "";
}

std::string describe_samples(const input::LoadedCase& base) {
  const input::Sampling& sampling = base.data.study.sampling;
  const double samples = sampling.samples;
  const double seconds = is_by_slices(base)
                             ? searches * find_seconds(base.data) + samples * run::find_sample_seconds(base.data.lem)
                             : (samples + 1) * find_seconds(base.data);
  return fmt::format("  a study draws {} of {}{}\n", count(samples, "sample", "samples"),
                     count(static_cast<double>(sampling.numbers.size()), "uncertain number", "uncertain numbers"),
                     add_time(seconds));
}

}  // namespace

StudyOutcome calculate_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                             const StudyOptions& options) {
  if (base.data.study.mode == input::StudyMode::sample) {
    SamplingResult result = run_sampling(base, overrides, options);
    return {std::move(result.markdown), std::move(result.failure)};
  }
  const StudyPlan plan = plan_study(base, overrides);
  const std::vector<StudyRow> rows = run_study(plan, options);
  return {write_study_markdown(plan, rows, describe_study(plan, rows)), find_failure(rows)};
}

std::string forecast_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides) {
  const input::Study& study = base.data.study;
  if (study.mode == input::StudyMode::sample) return describe_samples(base);
  if (study.vary.empty()) return "";
  const StudyPlan plan = plan_study(base, overrides);
  const std::size_t runs = plan.variants.size(), forecasts = std::min(runs, most_forecasts);
  double seconds = 0;
  for (std::size_t i = 0; i < forecasts; ++i) seconds += find_seconds(plan.variants[i * runs / forecasts].loaded.data);
  seconds *= static_cast<double>(runs) / static_cast<double>(forecasts);
  return fmt::format("  a study varies {}: {}{}\n", count(static_cast<double>(study.vary.size()), "key", "keys"),
                     count(static_cast<double>(runs), "run", "runs"), add_time(seconds));
}

}  // namespace talus::study
