// SPDX-License-Identifier: MIT
#pragma once
// `talus study` with mode = "sample": uncertain numbers are drawn, every sample is computed, and the statistics are
// reported.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/distributions.hpp"
#include "study/sampled_numbers.hpp"
#include "study/slice_factor.hpp"
#include "study/study.hpp"

namespace talus::study {

/// All samples, their results, and the statistics as far as they are known.
struct SampleSet {
  SampledNumbers sampled;
  ScorePlan plan;
  std::vector<std::vector<double>> scores, values;  ///< [number][sample]
  std::vector<double> factor;                       ///< per sample; NaN if there is none; empty if not requested
  std::vector<double> runout;                       ///< per sample [m], NaN if there is none; empty without MPM
  std::vector<double> failure_time;  ///< per sample [s], NaN if the slope does not fail; empty without a timeline
  results::Sampling summary;

  std::size_t size() const { return values.empty() ? 0 : values[0].size(); }
  std::vector<double> get_sample(std::size_t i) const;
};

/// Draws the samples of [study].
SampleSet draw_samples(const input::LoadedCase& base);

/// Makes the error of a sample that is no valid case.
Error refuse_sample(const std::string& label, const InputError& error);

/// Returns true if LEM alone computes the samples. With a timeline every sample is a run, with a seepage of its own.
bool is_by_slices(const input::LoadedCase& base);

/// Searches the surfaces on which samples are evaluated, and stores first-order estimate and design point in
/// `set.summary`. Throws what lem::search() throws at the means.
std::unique_ptr<SliceFactor> begin_slices(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                                          const StudyOptions& options, SampleSet& set);

/// Returns the factors of the samples from `first` to before `end` on the surfaces of `slices`, NaN if there is none.
/// Throws Error (interrupted), refuse_sample().
std::vector<double> find_factors(const SliceFactor& slices, const SampleSet& set, std::size_t first, std::size_t end,
                                 const StudyOptions& options);

/// Factors of all samples computed earlier by find_factors().
struct KnownFactors {
  std::vector<double> factors;
  double seconds = 0;  ///< computing time [s]
};

/// Computes the samples by LEM, except for `known` factors: `set.factor` and the summary of the surfaces. Throws what
/// begin_slices() and find_factors() throw.
void calculate_slices(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                      const StudyOptions& options, SampleSet& set, const KnownFactors* known = nullptr);

/// Makes a variant for every sample, each read and checked as a case of its own, preceded by the case at the means.
StudyPlan plan_samples(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                       const SampleSet& set);

/// Collects factors and runouts of the samples from their runs. Returns the table of the study.
results::StudyResult make_runs_result(const input::LoadedCase& base, const StudyPlan& plan,
                                      const std::vector<StudyRow>& rows, double seconds, SampleSet& set);

/// Completes `set.summary` with the statistics of the samples.
void make_samples_result(const input::Sampling& asked, SampleSet& set);

/// Formats study.md with lengths in the unit `length`.
std::string write_sampling_markdown(const std::string& title, const results::Sampling& sampling,
                                    const ShownUnit& length);

/// Formats one row per sample: its number, the values in the units of their keys, and its result.
std::string write_samples(const SampleSet& set);

/// Result of a study of samples; `failure` is that of samples that did not finish.
struct SamplingResult {
  std::string markdown;
  results::StudyResult study;
  std::optional<Error> failure;
};

/// Makes the head of the study for LEM samples, for which there is no run with a head.
results::StudyResult begin_sampling(const input::LoadedCase& base, int threads);

/// Completes `result.study` with the statistics of the samples, and writes study.json, study.md and samples.csv.
void write_sampling(const input::LoadedCase& base, const std::filesystem::path& folder, SampleSet& set,
                    SamplingResult& result);

/// Draws and computes the samples, and writes the results. Throws what run_study() throws.
SamplingResult run_sampling(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                            const StudyOptions& options);

}  // namespace talus::study
