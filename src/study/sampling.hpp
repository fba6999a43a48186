#pragma once
// `talus study` with mode = "sample": uncertain numbers are drawn, every sample is calculated, and what follows is
// told.

#include <optional>
#include <string>
#include <vector>

#include "study/latin_hypercube.hpp"
#include "study/reliability.hpp"
#include "study/sampled_numbers.hpp"
#include "study/study.hpp"

namespace talus::study {

/// All samples, what each gave, and what is said about them.
struct SampleSet {
  SampledNumbers sampled;
  ScorePlan plan;
  std::vector<std::vector<double>> scores, values;  ///< [number][sample]
  std::vector<double> factor;  ///< per sample; NaN where there is none; empty where none is asked for
  std::vector<double> runout;  ///< per sample [m], NaN where there is none; empty without material points

  input::SampledMethod method = input::SampledMethod::lem;
  std::string method_title;  ///< "Spencer's method on 214 surfaces"
  std::string runout_name;   ///< of [[compare]], "runout.toe_distance"
  std::optional<FirstOrder> first_order;
  std::optional<DesignPoint> design_point;
  int surfaces = 0;  ///< that every sample was evaluated on; 0: each sample was searched
  std::optional<results::SurfaceCheck> check;
  double seconds = 0;
  std::vector<std::string> notes;

  std::size_t size() const { return values.empty() ? 0 : values[0].size(); }
  std::vector<double> get_sample(std::size_t i) const;
};

/// Draws the samples of [study].
SampleSet draw_samples(const input::LoadedCase& base);

/// Calculates them by slices: `set.factor` and what is said about the surfaces. Throws what lem::search() does at the
/// means, Error (interrupted).
void calculate_slices(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                      const StudyOptions& options, SampleSet& set);

/// Calculates them by runs of the case, each in its folder, as a study of any other kind. Returns the study's own
/// table.
results::StudyResult calculate_runs(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                                    const StudyOptions& options, SampleSet& set, std::optional<Error>& failure);

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
