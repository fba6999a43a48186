// SPDX-License-Identifier: MIT
#include "run/compare/read_referee.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace talus::run {
namespace {

/// The factors with this verdict, in one sentence; empty where there are none.
std::string read_verdicts(const results::SliceResult& slices, results::Verdict verdict, const char* words) {
  std::vector<std::string> list;
  const auto add = [&](const std::vector<results::CriticalSurface>& surfaces, const char* surface) {
    for (const results::CriticalSurface& c : surfaces)
      if (c.verdict == verdict)
        list.push_back(fmt::format("{:.3f} ({}, {})", *c.surface.factor, c.surface.title, surface));
  };
  add(slices.critical, "circle");
  add(slices.noncircular, "polyline");
  add(slices.given, "given surface");
  return list.empty() ? "" : fmt::format("These factors {}: {}.", words, fmt::join(list, ", "));
}

std::string describe_interval(const results::Referee& referee) {
  if (referee.is_interval())
    return fmt::format(
        "Limit analysis proves for the soil of limit equilibrium (ψ = φ, tension up to c/tan φ) that the factor lies "
        "between {:.3f} and {:.3f}.",
        results::show_lower(*referee.lower), results::show_upper(*referee.upper));
  if (referee.upper)
    return fmt::format("Limit analysis proves that the factor is at most {:.3f}; there is no lower bound: {}.",
                       results::show_upper(*referee.upper), referee.no_lower);
  return fmt::format("Limit analysis is undecided, so that the factors of limit equilibrium are not judged: {}.",
                     referee.no_upper);
}

}  // namespace

std::vector<std::string> read_referee(const input::Case& data, const results::RunResult& run,
                                      std::optional<double> governing) {
  if (!run.slices || run.slices->error) return {};
  if (!data.lem.referee)
    return {"The factors of limit equilibrium were not held against limit analysis (referee = false)."};
  if (!run.slices->referee) return {};
  const results::Referee& referee = *run.slices->referee;
  if (referee.why_not)
    return {fmt::format("Limit analysis cannot judge the factors of limit equilibrium: {}.", *referee.why_not)};
  std::vector<std::string> sentences{describe_interval(referee)};
  if (!run.slices->search && referee.upper && governing && *governing > results::show_upper(*referee.upper))
    sentences.push_back(
        fmt::format("The factors are those of the given surfaces. The slope has a mechanism with a lower factor, of "
                    "at most {:.3f}.",
                    results::show_upper(*referee.upper)));
  if (referee.upper_only)
    sentences.push_back(fmt::format("Factors below the lower bound are not refused: {}.", *referee.upper_only));
  for (std::string sentence :
       {read_verdicts(*run.slices, results::Verdict::too_low, "lie below the lower bound and are impossible"),
        read_verdicts(*run.slices, results::Verdict::too_high,
                      "lie above the upper bound, so that a weaker mechanism exists")})
    if (!sentence.empty()) sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace talus::run
