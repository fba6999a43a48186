// SPDX-License-Identifier: MIT
#pragma once
// `talus study` with mode = "sample": uncertain numbers are drawn, every sample is calculated, and the statistics
// are reported.

#include <optional>
#include <string>
#include <vector>

#include "study/latin_hypercube.hpp"
#include "study/reliability.hpp"
#include "study/sampled_numbers.hpp"
#include "study/study.hpp"

namespace talus::study {

/// All samples, what each gave, and what is said about them as far as it is known.
struct SampleSet {
  SampledNumbers sampled;
  ScorePlan plan;
  std::vector<std::vector<double>> scores, values;  ///< [number][sample]
  std::vector<double> factor;        ///< per sample; NaN where there is none; empty where none is asked for
  std::vector<double> runout;        ///< per sample [m], NaN where there is none; empty without material points
  std::vector<double> failure_time;  ///< per sample [s], NaN where it does not fail; empty without a timeline
  results::Sampling told;

  std::size_t size() const { return values.empty() ? 0 : values[0].size(); }
  std::vector<double> get_sample(std::size_t i) const;
};

/// Draws the samples of [study].
SampleSet draw_samples(const input::LoadedCase& base);

/// A sample that is no possible case.
Error refuse_sample(const std::string& label, const InputError& error);

/// Calculates them by slices: `set.factor` and what is said about the surfaces. Throws what lem::search() does at the
/// means, Error (interrupted).
void calculate_slices(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                      const StudyOptions& options, SampleSet& set);

/// Calculates them by runs of the case, each in its folder, as a study of any other kind. Returns the study's own
/// table.
results::StudyResult calculate_runs(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                                    const StudyOptions& options, SampleSet& set, std::optional<Error>& failure);

/// Completes `set.told` with the statistics of the samples.
void tell_samples(const input::Sampling& asked, SampleSet& set);

/// study.md of it.
std::string write_sampling_markdown(const std::string& title, const results::Sampling& sampling);

/// One row per sample: its number, the values in the units of their keys, and its result.
std::string write_samples(const SampleSet& set);

/// What `talus study` does: draws, calculates, writes study.json, study.md and samples.csv into the folder. Errors as
/// run_study; `failure` is that of samples that did not finish.
struct SamplingResult {
  std::string markdown;
  results::StudyResult study;
  std::optional<Error> failure;
};
SamplingResult run_sampling(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                            const StudyOptions& options);

}  // namespace talus::study
