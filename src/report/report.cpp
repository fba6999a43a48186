// SPDX-License-Identifier: MIT
#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/folder_lock.hpp"
#include "base/parallel.hpp"
#include "input/echo.hpp"
#include "report/content/head.hpp"
#include "report/content/laboratory.hpp"
#include "report/content/method_results.hpp"
#include "report/content/method_table.hpp"
#include "report/content/model.hpp"
#include "report/content/sequence.hpp"
#include "report/content/study.hpp"
#include "report/content/tables.hpp"
#include "report/content/timeline.hpp"
#include "report/content/water.hpp"
#include "report/content/water_states.hpp"
#include "report/pack/pack.hpp"
#include "report/words/answer.hpp"
#include "report/words/assumptions.hpp"
#include "report/words/numbers.hpp"
#include "results/governing.hpp"
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

}  // namespace

std::shared_ptr<const output::ResultsReader> open_frames(const fs::path& folder) {
  return output::holds_frames(folder) ? std::make_shared<const output::ResultsReader>(folder) : nullptr;
}

std::size_t get_dimension(const results::RunResult& run) {
  return run.mesh && run.mesh->dimension == 3 ? 3 : 2;
}

std::optional<ResultFolder> open_run(const fs::path& path) {
  auto run = results::read_file<results::RunResult>(path / "summary.json");
  if (!run) return std::nullopt;
  ResultFolder folder;
  folder.path = path;
  folder.run = std::move(*run);
  folder.data = input::read_echo(folder.run.input);
  return folder;
}

ResultFolder open_folder(const fs::path& path) {
  if (!fs::is_directory(path)) fail(fmt::format("there is no folder '{}'", path.string()));
  std::optional<ResultFolder> run = open_run(path);
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
  if (!run) {
    // A killed run has the reports of its finished stages and their warnings in stages.json.
    if (auto record = results::read_file<results::StageRecord>(path / "stages.json")) {
      folder.run.stages = std::move(record->stages);
      folder.run.warnings = std::move(record->warnings);
    }
  }
  note_dimension(folder);
  return folder;
}

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string find_title(const results::RunResult& run) {
  const std::string& title = run.title.empty() ? run.project.title : run.title;
  return title.empty() ? "Untitled case" : title;
}

std::string name_folder(const fs::path& path) {
  fs::path name = fs::absolute(path).lexically_normal();
  if (!name.has_filename()) name = name.parent_path();
  return name.filename().string();
}

/// Returns the results of a run as the page shows them. Without a summary the trials of a killed run are its curve, and
/// the water table of the case is its water.
results::RunResult take_run(const ResultFolder& folder) {
  results::RunResult run = folder.run;
  if (auto states = find_water_states(folder); !states.empty()) run.water_states = std::move(states);
  if (run.curve) return run;
  for (const TrialFolder& trial : folder.trials) {
    if (!trial.result) continue;
    if (!run.curve) run.curve.emplace();
    run.curve->points.push_back(*trial.result);
  }
  return run;
}

/// Returns the results of the first variant that stand for all variants of a study.
results::RunResult take_head(const StudyContent& study) {
  const results::RunResult first = take_run(study.first);
  results::RunResult head;
  head.title = first.title;
  head.project = first.project;
  head.provenance = first.provenance;
  head.units = first.units;
  head.input = first.input;
  head.slope_height = first.slope_height;
  head.water = first.water;
  head.seepage = first.seepage;
  head.season = first.season;
  head.water_states = first.water_states;
  head.status = study.status;
  results::Timing& timing = head.timing.emplace();
  timing.wall = study.wall;
  timing.cpu = study.cpu;
  return head;
}

/// Returns the parts that reports of runs and of studies share; for a study they are those of its first variant.
json make_common(const ResultFolder& folder, Packer& packer) {
  const results::RunResult& run = folder.run;
  const ShownUnits units = read_units(run);
  json document{{"kind", "run"},
                {"title", find_title(run)},
                {"folder", name_folder(folder.path)},
                {"units",
                 {{"length", report::to_json(units.length)},
                  {"displacement", report::to_json(units.displacement)},
                  {"stress", report::to_json(units.stress)},
                  {"line_force", report::to_json(units.line_force)},
                  {"volume", report::to_json(units.volume(get_dimension(run)))},
                  {"flow", report::to_json(units.flow(get_dimension(run)))},
                  {"speed", report::to_json(units.speed())}}},
                {"model", make_model(folder, results::find_main_factor(run), packer)},
                {"sequences", json::array()},
                {"tables", json::array()},
                {"assumptions", list_assumptions(folder)},
                {"methods", list_methods(folder)}};
  if (json water = make_water(folder); !water.is_null()) document["water"] = std::move(water);
  return document;
}

json make_answer_of(const std::vector<std::string>& sentences) {
  return {{"sentences", sentences}, {"factors", json::array()}, {"results", json::array()}};
}

/// Adds LEM, FEM, limit analysis, and the comparison of all methods.
void add_other_methods(const ResultFolder& folder, Packer& packer, json& document) {
  const auto add = [&](const char* key, json block) {
    if (!block.is_null()) document[key] = std::move(block);
  };
  add("methods_read", read_methods(folder));
  add("slices", pack_slices(folder, packer, document["warnings"]));
  add("finite_elements", pack_finite_elements(folder, packer, document["warnings"]));
  add("proven_bounds", pack_proven_bounds(folder, packer, document["warnings"]));
}

json make_run(const ResultFolder& folder, Packer& packer) {
  json document = make_common(folder, packer);
  const results::RunResult& run = folder.run;
  document["answer"] = make_answer(folder);
  document["answer"]["results"] = list_named_results(folder);
  document["warnings"] = list_unrest(run);
  for (const std::string& warning : run.warnings) document["warnings"].push_back(warning);
  document["sequences"] = pack_sequences(folder, packer);
  document["tables"] = make_tables(folder, document["warnings"]);
  if (json sections = make_sections(folder, document["warnings"]); !sections.empty())
    document["sections"] = std::move(sections);
  add_other_methods(folder, packer, document);
  if (json timeline = make_timeline(folder, packer, document["warnings"]); !timeline.is_null())
    document["timeline"] = std::move(timeline);
  add_water_fields(folder, document, packer);
  return document;
}

json make_study_report(const ResultFolder& folder, const StudyContent& study, Packer& packer) {
  ResultFolder first = study.first;
  first.path = folder.path;  // uses the name of the study; the frames of the variant are not shown
  json document = make_common(first, packer);
  document["kind"] = "study";
  document["answer"] = make_answer_of(study.sentences);
  document["warnings"] = study.warnings;
  document["study"] = study.table.get();
  for (const JsonTree& sequence : study.sequences) document["sequences"].push_back(sequence.get());
  if (folder.study_result->sampling) {
    // Samples evaluated by LEM have no run, and so no input.
    if (first.run.input.is_empty()) document["methods"] = json::array();
    document["methods"].push_back("sampling");
  }
  return document;
}

/// Returns the report of element tests without a run; the parts on slopes are omitted.
json make_tests_report(const ResultFolder& folder, Packer& packer) {
  json document = make_common(folder, packer);
  document["kind"] = "tests";
  document["answer"] = make_answer_of(format_point_tests(folder));
  document["warnings"] = folder.run.warnings;
  document["methods"] = json::array();
  document["assumptions"] = list_point_assumptions();
  return document;
}

/// Adds the element tests of the folder to any kind of report.
void add_point_tests(const ResultFolder& folder, json& document) {
  if (!folder.tests) return;
  document["point_columns"] = read_point_columns(folder);
  if (folder.has_tests_alone) return;
  for (const std::string& warning : folder.tests->warnings) document["warnings"].push_back(warning);
}

}  // namespace

Content collect_report(const fs::path& path) {
  const ResultFolder folder = open_folder(path);
  Packer packer;
  Content content;
  try {
    json document, found;
    if (folder.is_study()) {
      const StudyContent study = read_study(folder, packer);
      document = make_study_report(folder, study, packer);
      found = {{"result", results::to_json(take_head(study))},
               {"study_result", results::to_json(*folder.study_result)}};
    } else {
      document = folder.has_tests_alone ? make_tests_report(folder, packer) : make_run(folder, packer);
      found = {{"result", results::to_json(take_run(folder))}};
    }
    if (folder.tests) found["point_tests"] = results::to_json(*folder.tests);
    if (folder.calibration) found["calibration"] = results::to_json(*folder.calibration);
    add_point_tests(folder, document);
    add_calibration(folder, document);
    content.document = JsonTree(std::move(document));
    content.results = JsonTree(std::move(found));
  } catch (const json::exception& error) {
    throw Error(ExitCode::wrong_input,
                fmt::format("cannot make a report of '{}': its {} is not as this version writes it ({})", path.string(),
                            folder.is_study()        ? "study.json"
                            : folder.has_tests_alone ? "point/point.json"
                                                     : "summary.json",
                            error.what()));
  }
  content.arrays = packer.compress(default_threads());
  return content;
}

fs::path write_report(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw Error(ExitCode::wrong_input, fmt::format("there is no folder '{}'", folder.string()));
  const ResultsLock lock(folder);
  const Content content = collect_report(folder);
  const json& document = content.document.get();
  fs::path path = folder / "report.html";
  const auto files = FileList::find(path);
  write_atomically(
      path,
      fill_page(get_page(), document["title"].get<std::string>(), content.results.get(), document, content.arrays),
      "the results are whole");
  return path;
}

}  // namespace talus::report
