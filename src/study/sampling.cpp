// SPDX-License-Identifier: MIT
#include "study/sampling.hpp"

#include <fmt/format.h>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "input/case/sampled_method.hpp"
#include "input/echo.hpp"
#include "results/json.hpp"
#include "run/head.hpp"
#include "run/run_case.hpp"
#include "study/sample_statistics.hpp"

namespace talus::study {
namespace {

/// With enough samples a Latin hypercube is made of so many independent ones, whose scatter gives the standard error.
constexpr int hypercubes = 10, enough_samples = 1000;

}  // namespace

std::vector<double> SampleSet::get_sample(std::size_t i) const {
  std::vector<double> sample;
  for (const auto& column : values) sample.push_back(column[i]);
  return sample;
}

SampleSet draw_samples(const input::LoadedCase& base) {
  const input::Sampling& sampling = base.data.study.sampling;
  SampleSet set;
  set.sampled = read_sampled_numbers(base);
  const bool is_latin = sampling.plan == input::SamplePlan::latin_hypercube;
  const int replicates = is_latin && sampling.samples >= enough_samples ? hypercubes : 1;
  set.plan = {sampling.samples,       static_cast<int>(set.sampled.numbers.size()), sampling.seed, is_latin, replicates,
              set.sampled.correlation};
  set.scores = draw_scores(set.plan);
  for (std::size_t j = 0; j < set.scores.size(); ++j) {
    std::vector<double>& values = set.values.emplace_back();
    for (const double z : set.scores[j]) values.push_back(set.sampled.marginals[j].find_value(z));
    const results::SampledValues found = find_moments(values);
    set.sampled.numbers[j].sampled = {found.mean, found.deviation, found.smallest, found.largest};
  }
  set.told.samples = sampling.samples;
  set.told.seed = sampling.seed;
  set.told.plan = is_latin ? results::SampleDraw::latin_hypercube : results::SampleDraw::random;
  set.told.replicates = replicates;
  set.told.method = input::find_method(sampling.method);
  set.told.numbers = set.sampled.numbers;
  set.told.notes = set.sampled.notes;
  return set;
}

Error refuse_sample(const std::string& label, const InputError& error) {
  return {ExitCode::wrong_input,
          fmt::format("{} is no possible case: {}; cut or correlate the distributions so that it cannot come up", label,
                      error.diagnostics().front().sentence)};
}

SamplingResult run_sampling(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                            const StudyOptions& options) {
  SampleSet set = draw_samples(base);
  check_folder(options, "give another one with -o, or replace it with --overwrite");
  FolderLock lock(options.folder);
  // In time every sample is a run, with a seepage of its own.
  const bool by_slices = set.told.method == Method::lem && !base.data.timeline;
  if (by_slices) lock.take_existing();  // a study of runs takes it itself
  SamplingResult result;
  results::StudyResult& study = result.study;
  if (by_slices) {
    study = begin_study(base);
    study.units.stress = base.data.output.stress_unit;
    study.project = run::tell_project(base.data);
    study.provenance = run::tell_provenance(base, input::hash_input(base.echo), options.threads);
    study.input = base.echo;
    calculate_slices(base, overrides, options, set);
  } else {
    study = calculate_runs(base, overrides, options, set, result.failure);
  }
  tell_samples(base.data.study.sampling, set);
  study.sampling = set.told;
  lock.take();
  write_atomically(options.folder / "samples.csv", write_samples(set));
  results::write_file(options.folder / "study.json", study);
  result.markdown = write_sampling_markdown(base.data.title, *study.sampling);
  write_atomically(options.folder / "study.md", result.markdown);
  return result;
}

}  // namespace talus::study
