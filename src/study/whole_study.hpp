// SPDX-License-Identifier: MIT
#pragma once
// A study whatever its mode: the one entry behind `talus study` and Python's talus.study.

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

}  // namespace talus::study
