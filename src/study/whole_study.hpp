// SPDX-License-Identifier: MIT
#pragma once
// A study whatever its mode: its forecast, and the one entry behind `talus study` and Python's talus.study.

#include <optional>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace talus::study {

struct StudyOutcome {
  std::string tables;            ///< study.md
  std::optional<Error> failure;  ///< of variants or samples that did not finish
};

/// Calculates the variants or the samples of the case, which was read with `overrides`. Errors as run_study() and
/// run_sampling().
StudyOutcome calculate_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                             const StudyOptions& options);

/// "a study varies 3 keys: 24 runs, about 10 minutes"; empty where the case has no study. The time is that of runs one
/// after another. Throws InputError with the faults of the variants.
std::string forecast_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides);

}  // namespace talus::study
