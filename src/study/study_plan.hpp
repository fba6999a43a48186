// SPDX-License-Identifier: MIT
#pragma once
// Plan of a study: the base case and its variants, each read and checked as a case of its own.

#include <optional>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/study.hpp"

namespace talus::study {

/// One run of a study: a row of its table.
struct Variant {
  std::string name;                      ///< of its folder, `damping_0.01`; the base case is `base`
  std::string label;                     ///< for display, `damping = 0.01`
  std::vector<std::string> values;       ///< of every varied key, in its unit
  std::vector<input::Override> changes;  ///< overrides of the case text
  input::LoadedCase loaded;  ///< without its [study], so that the results remain valid for an extended study
  std::string input_hash;    ///< as recorded in the summary of the run
};

struct StudyPlan {
  results::StudyResult summary;             ///< without results; values that make no variant are notes
  std::vector<std::string> names;           ///< of the keys: their shortest unique ends
  std::vector<double> factors;              ///< strength reduction factors whose displacement is a column of the table
  std::vector<Variant> variants;            ///< the base case first
  std::vector<std::string> monitors;        ///< monitors whose onset and displacement are columns of the table
  std::size_t reference = 0;                ///< the variant by whose displacements the others are divided
  std::optional<std::size_t> extrapolated;  ///< index of the key whose value zero is the limit of the extrapolation
};

/// Makes title, mode and units of the study of a case.
results::StudyResult begin_study(const input::LoadedCase& base);

/// Reads every variant of the study in `base`, which was read with `overrides`. Variants that equal an earlier one are
/// left out with a note. Throws InputError with the faults of all variants, each fault once, or if there is nothing to
/// vary.
StudyPlan plan_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides);

}  // namespace talus::study
