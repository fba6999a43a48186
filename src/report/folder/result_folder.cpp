// SPDX-License-Identifier: MIT
#include "report/folder/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/error.hpp"
#include "input/echo.hpp"
#include "results/json.hpp"

namespace talus::report {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& sentence) {
  throw Error(ExitCode::wrong_input, sentence);
}

std::vector<TrialFolder> list_trials(const fs::path& folder) {
  static constexpr std::string_view prefix = "srf_";
  std::vector<TrialFolder> trials;
  if (!fs::is_directory(folder)) return trials;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || !name.starts_with(prefix)) continue;
    TrialFolder trial;
    trial.path = entry.path();
    const char* end = name.data() + name.size();
    if (std::from_chars(name.data() + prefix.size(), end, trial.factor).ptr != end) continue;
    trial.result = results::read_file<results::Trial>(entry.path() / "trial.json");
    trial.runs_out = fs::exists(entry.path() / "history.csv");
    trials.push_back(std::move(trial));
  }
  std::sort(trials.begin(), trials.end(), [](const auto& a, const auto& b) { return a.factor < b.factor; });
  return trials;
}

/// Sets the dimension of a run that was killed before it wrote a summary: plane strain if all z of its frames are zero.
void note_dimension(ResultFolder& folder) {
  if (folder.run.mesh || !folder.frames || folder.frames->size() == 0) return;
  const output::Frame frame = folder.frames->read(0);
  bool plane = true;
  for (std::size_t i = 2; i < frame.positions.size(); i += 3) plane = plane && frame.positions[i] == 0;
  results::Mesh& mesh = folder.run.mesh.emplace();
  mesh.dimension = plane ? 2 : 3;
  mesh.points = frame.point_count();
}

/// Returns a run with the parts that element tests contain: title, case, units, warnings.
results::RunResult make_run_of_tests(const results::PointTests& tests) {
  results::RunResult run;
  run.title = tests.title;
  run.project = tests.project;
  run.provenance = tests.provenance;
  run.units = tests.units;
  run.input = tests.input;
  run.status = results::Status::finished;
  run.warnings = tests.warnings;
  run.comparisons = tests.comparisons;
  run.timing = tests.timing;
  return run;
}

std::optional<ResultFolder> open_summary(const fs::path& path, const char* name) {
  auto run = results::read_file<results::RunResult>(path / name);
  if (!run) return std::nullopt;
  ResultFolder folder;
  folder.path = path;
  folder.run = std::move(*run);
  folder.data = input::read_echo(folder.run.input);
  return folder;
}

/// Opens what a run in progress has found so far.
std::optional<ResultFolder> open_present(const fs::path& path) {
  std::optional<ResultFolder> folder = open_summary(path, results::present_summary_file);
  if (!folder) return folder;
  if (!folder->run.elements)
    folder->reduction = results::read_file<results::PresentReduction>(path / results::present_reduction_file);
  if (!folder->run.bounds)
    if (auto file = results::read_file<results::BoundsFile>(path / results::present_bounds_file))
      folder->run.bounds = std::move(file->summary);
  return folder;
}

}  // namespace

std::shared_ptr<const output::ResultsReader> open_frames(const fs::path& folder) {
  return output::holds_frames(folder) ? std::make_shared<const output::ResultsReader>(folder) : nullptr;
}

std::size_t get_dimension(const results::RunResult& run) {
  return run.mesh && run.mesh->dimension == 3 ? 3 : 2;
}

std::optional<ResultFolder> open_run(const fs::path& path) {
  return open_summary(path, "summary.json");
}

ResultFolder open_folder(const fs::path& path) {
  if (!fs::is_directory(path)) fail(fmt::format("there is no folder '{}'", path.string()));
  std::optional<ResultFolder> run = open_run(path);
  const bool has_ended = run.has_value();
  if (!run) run = open_present(path);
  ResultFolder folder = run ? std::move(*run) : ResultFolder{};
  folder.path = path;
  folder.study_result = results::read_file<results::StudyResult>(path / "study.json");
  folder.tests = results::read_file<results::PointTests>(path / "point" / "point.json");
  folder.calibration = results::read_file<results::Calibration>(path / "calibration" / "calibration.json");
  folder.trials = list_trials(path / "trials");
  folder.frames = open_frames(path);
  if (!run && !folder.study_result && !folder.frames && folder.trials.empty()) {
    if (folder.tests) {
      folder.has_tests_alone = true;
      folder.run = make_run_of_tests(*folder.tests);
      folder.data = input::read_echo(folder.run.input);
      return folder;
    }
    fail(fmt::format("'{}' is no folder of results: it holds neither summary.json nor study.json nor frames of a run",
                     path.string()));
  }
  if (!has_ended) {
    // A run that is killed or in progress has the reports of its finished stages and their warnings in stages.json.
    if (auto record = results::read_file<results::StageRecord>(path / "stages.json")) {
      folder.run.stages = std::move(record->stages);
      folder.run.warnings.insert(folder.run.warnings.end(), record->warnings.begin(), record->warnings.end());
    }
  }
  note_dimension(folder);
  return folder;
}

}  // namespace talus::report
