#pragma once
// What a study calculates: the base case and its variants, each read and checked as a case of its own.

#include <string>
#include <vector>

#include "input/read.hpp"

namespace talus::study {

/// A key that the study varies.
struct StudyKey {
  std::string path;  ///< as in the case file, `strength_reduction.curve.damping`
  std::string name;  ///< its last part, or as many parts as tell it from the other keys
  std::string unit;  ///< of its values in the tables; empty for plain numbers and words
};

/// One calculation of a study: a row of its table.
struct Variant {
  std::string name;                 ///< of its folder, `damping_0.01`; the base case is `base`
  std::string label;                ///< for people, `damping = 0.01`
  std::vector<std::string> values;  ///< of every varied key, in its unit
  input::LoadedCase loaded;         ///< without its [study], so that a longer study keeps what was calculated
  std::string input_hash;           ///< as the run's summary records it
};

struct StudyPlan {
  std::string title, file;
  std::string mode;  ///< how the values are combined, as in the case
  std::string displacement_unit, length_unit;
  std::vector<StudyKey> keys;
  std::vector<double> factors;        ///< strength reduction factors whose displacement the table lists
  std::vector<Variant> variants;      ///< the base case first
  std::vector<std::string> monitors;  ///< whose onset and displacement the table lists
  std::size_t reference = 0;          ///< the variant that displacements are divided by
  std::string extrapolate;            ///< path of the key to whose zero factors are extrapolated; empty: none
  std::vector<std::string> notes;     ///< values that make no variant of their own
};

/// Reads every variant of the study in `base`, which was read with `overrides`. Variants that equal an earlier one are
/// left out with a note. Throws InputError with the faults of all variants, each fault once, or when there is nothing
/// to vary.
StudyPlan plan_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides);

}  // namespace talus::study
