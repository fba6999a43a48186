#include "study/sampling.hpp"
#include "input/echo.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "results/json.hpp"
#include "run/head.hpp"
#include "run/run_case.hpp"
#include "study/sampling_table.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;

/// A Latin hypercube is made of so many that are drawn for themselves, where the samples are enough for it: their
/// scatter tells the standard error.
constexpr int hypercubes = 10, enough_samples = 1000;

void check_folder(const StudyOptions& options) {
  if (!fs::exists(options.folder)) return;
  const std::string folder = options.folder.string();
  if (!fs::is_directory(options.folder))
    throw Error(ExitCode::folder_exists, fmt::format("'{}' is a file; a study needs a folder", folder));
  if (!fs::is_empty(options.folder) && !options.overwrite && !options.resume)
    throw Error(ExitCode::folder_exists,
                fmt::format("the folder '{}' holds something already; give another one with -o, or replace it with "
                            "--overwrite",
                            folder));
}

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
  set.notes = set.sampled.notes;
  set.method = sampling.method;
  set.plan.samples = sampling.samples;
  set.plan.numbers = static_cast<int>(set.sampled.numbers.size());
  set.plan.seed = sampling.seed;
  set.plan.latin = sampling.plan == input::SamplePlan::latin_hypercube;
  set.plan.replicates = set.plan.latin && sampling.samples >= enough_samples ? hypercubes : 1;
  set.plan.correlation = set.sampled.correlation;
  set.scores = draw_scores(set.plan);
  for (std::size_t j = 0; j < set.scores.size(); ++j) {
    set.values.emplace_back();
    for (const double z : set.scores[j]) set.values[j].push_back(set.sampled.numbers[j].marginal.find_value(z));
  }
  return set;
}

SamplingResult run_sampling(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                            const StudyOptions& options) {
  SampleSet set = draw_samples(base);
  check_folder(options);
  SamplingResult result;
  results::StudyResult& study = result.study;
  if (set.method == input::SampledMethod::lem) {
    const input::Output& output = base.data.output;
    study.title = base.data.title;
    study.case_file = base.file;
    study.units = {output.displacement_unit, output.length_unit, output.stress_unit};
    study.project = run::tell_project(base.data);
    study.provenance = run::tell_provenance(base, input::hash_input(base.echo), options.threads);
    study.input = base.echo;
    calculate_slices(base, overrides, options, set);
  } else {
    study = calculate_runs(base, overrides, options, set, result.failure);
  }
  study.mode = "sample";
  study.sampling = describe_sampling(base.data.study.sampling, set);
  make_folder(options.folder);
  write_atomically(options.folder / "samples.csv", write_samples(set));
  results::write_file(options.folder / "study.json", study);
  result.markdown = write_sampling_markdown(base.data.title, *study.sampling);
  write_atomically(options.folder / "study.md", result.markdown);
  return result;
}

}  // namespace talus::study
