// SPDX-License-Identifier: MIT
#include "report/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/folder_lock.hpp"
#include "base/parallel.hpp"
#include "output/plots/case_picture.hpp"
#include "report/content/method_table.hpp"
#include "report/content/model.hpp"
#include "report/content/parts.hpp"
#include "report/content/sequence.hpp"
#include "report/content/water.hpp"
#include "report/folder/numbers.hpp"
#include "report/folder/result_folder.hpp"
#include "report/pack/pack.hpp"
#include "report/words/words.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"
#include "run/case_picture.hpp"

namespace talus::report {

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
                {"method_titles", list_method_titles()},
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
  add("reduction", pack_reduction(folder, packer));
  add("proven_bounds", pack_proven_bounds(folder, packer, document["warnings"]));
  add("construction_stages", pack_stages(folder, packer, document["warnings"]));
}

/// A picture that cannot be drawn does not prevent the report.
void add_input_picture(const ResultFolder& folder, json& document) {
  if (folder.run.input.is_empty()) return;
  try {
    if (const auto picture = run::make_input_picture(folder.data))
      document["input_picture"] = output::write_case_picture(*picture);
  } catch (const Error& error) {
    document["warnings"].push_back(fmt::format("The input has no picture: {}", error.what()));
  }
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
  add_input_picture(folder, document);
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

std::string write_data(const fs::path& folder) {
  const Content content = collect_report(folder);
  json arrays = json::object();
  for (const PackedText& array : content.arrays) arrays[array.id] = array.base64;
  const json data{
      {"report", content.document.get()}, {"results", content.results.get()}, {"arrays", std::move(arrays)}};
  return data.dump(-1, ' ', false, json::error_handler_t::replace);
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
