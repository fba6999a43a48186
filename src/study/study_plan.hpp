// SPDX-License-Identifier: MIT
#pragma once
// What a study calculates: the base case and its variants, each read and checked as a case of its own.

#include <optional>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/study.hpp"

namespace talus::study {

/// One calculation of a study: a row of its table.
struct Variant {
  std::string name;                      ///< of its folder, `damping_0.01`; the base case is `base`
  std::string label;                     ///< for people, `damping = 0.01`
  std::vector<std::string> values;       ///< of every varied key, in its unit
  std::vector<input::Override> changes;  ///< of the case's text
  input::LoadedCase loaded;              ///< without its [study], so that a longer study keeps what was calculated
  std::string input_hash;                ///< as the run's summary records it
};

struct StudyPlan {
  results::StudyResult summary;          ///< before anything is calculated: keys without their values, values that make
                                      ///< no variant of their own as notes
  std::vector<std::string> names;     ///< of the keys: the last part, or as many as tell it from the others
  std::vector<double> factors;        ///< strength reduction factors whose displacement the table lists
  std::vector<Variant> variants;      ///< the base case first
  std::vector<std::string> monitors;  ///< whose onset and displacement the table lists
  std::size_t reference = 0;          ///< the variant that displacements are divided by
  std::optional<std::size_t> extrapolated;  ///< number of the key to whose zero factors are extrapolated
};

/// Title, mode and units of the study of a case.
results::StudyResult begin_study(const input::LoadedCase& base);

/// Reads every variant of the study in `base`, which was read with `overrides`. Variants that equal an earlier one are
/// left out with a note. Throws InputError with the faults of all variants, each fault once, or when there is nothing
/// to vary.
StudyPlan plan_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides);

}  // namespace talus::study
