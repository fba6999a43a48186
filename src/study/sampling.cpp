// SPDX-License-Identifier: MIT
#include "study/sampling.hpp"

#include <fmt/format.h>

#include <chrono>

#include "base/atomic_file.hpp"
#include "base/encoding.hpp"
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
  set.summary.samples = sampling.samples;
  set.summary.seed = sampling.seed;
  set.summary.plan = is_latin ? results::SampleDraw::latin_hypercube : results::SampleDraw::random;
  set.summary.replicates = replicates;
  set.summary.method = input::find_method(sampling.method);
  set.summary.numbers = set.sampled.numbers;
  set.summary.notes = set.sampled.notes;
  return set;
}

Error refuse_sample(const std::string& label, const InputError& error) {
  return {ExitCode::wrong_input,
          fmt::format("{} is no possible case: {}; cut or correlate the distributions so that it cannot come up", label,
                      error.diagnostics().front().sentence)};
}

bool is_by_slices(const input::LoadedCase& base) {
  return input::find_method(base.data.study.sampling.method) == Method::lem && !base.data.timeline;
}

results::StudyResult begin_sampling(const input::LoadedCase& base, int threads) {
  results::StudyResult study = begin_study(base);
  study.units.stress = base.data.output.stress_unit;
  study.project = run::make_project(base.data);
  study.provenance = run::make_provenance(base, input::hash_input(base.echo), threads);
  study.input = base.echo;
  return study;
}

void write_sampling(const input::LoadedCase& base, const std::filesystem::path& folder, SampleSet& set,
                    SamplingResult& result) {
  make_samples_result(base.data.study.sampling, set);
  result.study.sampling = set.summary;
  write_atomically(folder / "samples.csv", write_samples(set));
  results::write_file(folder / "study.json", result.study);
  result.markdown = write_sampling_markdown(base.data.title, set.summary);
  write_atomically(folder / "study.md", make_printable(result.markdown, true));
}

SamplingResult run_sampling(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                            const StudyOptions& options) {
  SampleSet set = draw_samples(base);
  check_folder(base, {}, options, "give another one with -o, or replace it with --overwrite");
  FolderLock lock(options.folder);
  std::unique_ptr<FileList> files;
  SamplingResult result;
  if (is_by_slices(base)) {
    lock.take_existing();
    result.study = begin_sampling(base, options.threads);
    calculate_slices(base, overrides, options, set);
    lock.take();
    files = open_folder({}, options);
  } else {
    const auto start = std::chrono::steady_clock::now();
    const StudyPlan plan = plan_samples(base, overrides, set);
    const std::vector<StudyRow> rows = run_study(plan, options);  // it takes the lock itself
    result.failure = find_failure(rows);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    result.study = make_runs_result(base, plan, rows, passed.count(), set);
    lock.take();
    files = std::make_unique<FileList>(options.folder);
  }
  write_sampling(base, options.folder, set, result);
  return result;
}

}  // namespace talus::study
