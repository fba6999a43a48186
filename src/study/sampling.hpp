// SPDX-License-Identifier: MIT
#pragma once
// `talus study` with mode = "sample": uncertain numbers are drawn, every sample is calculated, and the statistics
// are reported.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/distributions.hpp"
#include "study/reliability.hpp"
#include "study/sampled_numbers.hpp"
#include "study/slice_factor.hpp"
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
  results::Sampling summary;

  std::size_t size() const { return values.empty() ? 0 : values[0].size(); }
  std::vector<double> get_sample(std::size_t i) const;
};

/// Draws the samples of [study].
SampleSet draw_samples(const input::LoadedCase& base);

/// A sample that is no possible case.
Error refuse_sample(const std::string& label, const InputError& error);

/// Whether samples are calculated by slices alone. In time every sample is a run, with a seepage of its own.
bool is_by_slices(const input::LoadedCase& base);

/// Searches for the surfaces that samples are evaluated on, and tells first-order estimate and design point in
/// `set.told`. Throws what lem::search() does at the means.
std::unique_ptr<SliceFactor> begin_slices(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                                          const StudyOptions& options, SampleSet& set);

/// The factors of the samples from `first` to before `end` on the surfaces that `slices` has, NaN where there is none.
/// Throws Error (interrupted), refuse_sample().
std::vector<double> find_factors(const SliceFactor& slices, const SampleSet& set, std::size_t first, std::size_t end,
                                 const StudyOptions& options);

/// Factors that find_factors() found for all samples before, elsewhere.
struct KnownFactors {
  std::vector<double> factors;
  double seconds = 0;  ///< that it took [s]
};

/// Calculates the samples by slices, except for what is known: `set.factor` and what is said about the surfaces. Throws
/// what begin_slices() and find_factors() do.
void calculate_slices(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                      const StudyOptions& options, SampleSet& set, const KnownFactors* known = nullptr);

/// A variant for every sample, each read and checked as a case of its own; before them the case at the means.
StudyPlan plan_samples(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                       const SampleSet& set);

/// Factors and runouts of the samples from their runs. Returns the study's own table.
results::StudyResult make_runs_result(const input::LoadedCase& base, const StudyPlan& plan,
                                      const std::vector<StudyRow>& rows, double seconds, SampleSet& set);

/// Completes `set.told` with the statistics of the samples.
void make_samples_result(const input::Sampling& asked, SampleSet& set);

/// study.md of it.
std::string write_sampling_markdown(const std::string& title, const results::Sampling& sampling);

/// One row per sample: its number, the values in the units of their keys, and its result.
std::string write_samples(const SampleSet& set);

/// What is told of a study of samples; `failure` is that of samples that did not finish.
struct SamplingResult {
  std::string markdown;
  results::StudyResult study;
  std::optional<Error> failure;
};

/// The head of the study of samples by slices, which have no run that holds it.
results::StudyResult begin_sampling(const input::LoadedCase& base, int threads);

/// Completes `result.study` with the statistics of the samples, and writes study.json, study.md and samples.csv.
void write_sampling(const input::LoadedCase& base, const std::filesystem::path& folder, SampleSet& set,
                    SamplingResult& result);

/// What `talus study` does: draws, calculates, writes. Errors as run_study.
SamplingResult run_sampling(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                            const StudyOptions& options);

}  // namespace talus::study
