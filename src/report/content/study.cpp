#include "report/content/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "base/error.hpp"
#include "input/echo.hpp"
#include "report/content/curve.hpp"
#include "report/content/head.hpp"
#include "report/content/sampling.hpp"
#include "report/content/sections.hpp"
#include "report/content/study_pictures.hpp"
#include "report/look_up.hpp"
#include "results/json.hpp"

namespace talus::report {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// A number in full digits; null for a word or nothing.
json to_number(const std::string& text) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc() && end == text.data() + text.size() && !text.empty() ? json(value) : json();
}

json make_column(const json& column) {
  json shown = json::array(), values = json::array();
  const bool is_name = get_text(column, {"name"}) == "variant";  // "25" may be the name of a folder
  for (const json& cell : find_list(column, {"cells"})) {
    shown.push_back(get_text(cell, {"shown"}));
    values.push_back(is_name ? json() : to_number(get_text(cell, {"full"})));
  }
  return {{"name", get_text(column, {"name"})},
          {"title", get_text(column, {"title"})},
          {"unit", get_text(column, {"unit"})},
          {"shown", shown},
          {"values", values}};
}

/// "FoS, frozen: 1.39 to 1.45 over 12 variants".
void say_ranges(const json& columns, json& sentences) {
  for (const json& c : columns) {
    const std::string name = c["name"];
    const bool is_ratio = name.starts_with("displacement of ") && name.find(" over ") != std::string::npos;
    if (!name.starts_with("FoS") && !name.starts_with("front advance") && name != "largest displacement" && !is_ratio)
      continue;
    double low = 0, high = 0;
    int count = 0;
    for (const json& v : c["values"]) {
      if (!v.is_number()) continue;
      const double value = v;
      low = count == 0 ? value : std::min(low, value);
      high = count == 0 ? value : std::max(high, value);
      ++count;
    }
    if (count == 0) continue;
    const std::string unit = c["unit"] == "" ? "" : " " + c["unit"].get<std::string>();
    const std::string title = name.starts_with("FoS, ") ? "The factor of safety (" + name.substr(5) + ")"
                                                        : "The " + c["title"].get<std::string>();
    const std::string lowest = show_number(low, 4) + unit, highest = show_number(high, 4) + unit;
    if (count == 1)
      sentences.push_back(fmt::format("{} is {} in the one variant that has it.", title, lowest));
    else if (low == high)
      sentences.push_back(fmt::format("{} is {} in all {} variants that have it.", title, lowest, count));
    else
      sentences.push_back(fmt::format("{} lies between {} and {} over {} variants.", title, lowest, highest, count));
  }
}

/// Factors of methods that know nothing of the size are the same at all sizes.
bool varies(const json& factor) {
  const json& factors = find_list(factor, {"factors"});
  return std::any_of(factors.begin(), factors.end(), [&](const json& f) { return f != factors[0]; });
}

json take_extrapolation(const json& block) {
  json factors = json::array();
  for (const json& f : find_list(block, {"factors"})) {
    if (!varies(f)) continue;
    json row{{"criterion", get_text(f, {"criterion"})}, {"variant", get_text(f, {"variant"})},
             {"sizes", find_list(f, {"sizes"})},        {"factors", find_list(f, {"factors"})},
             {"linear", get_number(f, {"linear"})},     {"finest_pair", get_number(f, {"finest_pair"})}};
    for (const char* key : {"standard_error", "order", "by_order"}) {
      const auto value = find_number(f, {key});
      row[key] = value ? json(*value) : json();
    }
    factors.push_back(std::move(row));
  }
  return {{"key", get_text(block, {"key"})}, {"unit", get_text(block, {"unit"})}, {"factors", factors}};
}

/// In a large study the table says it.
constexpr std::size_t most_extrapolated = 4;

void say_extrapolation(const json& study, json& sentences) {
  json factors = json::array();
  for (const json& f : find_list(study, {"extrapolation", "factors"}))
    if (varies(f)) factors.push_back(f);
  if (factors.empty() || factors.size() > most_extrapolated) return;
  std::vector<std::string> parts;
  for (const json& f : factors) {
    const auto error = find_number(f, {"standard_error"});
    const std::string variant = get_text(f, {"variant"});
    std::string criterion = get_text(f, {"criterion"});
    if (criterion.starts_with("FoS, ")) criterion.erase(0, 5);
    parts.push_back(fmt::format("{:.3f}{} ({}{})", get_number(f, {"linear"}),
                                error ? fmt::format(" ± {:.3f}", *error) : "", criterion,
                                variant.empty() ? "" : "; " + variant));
  }
  sentences.push_back(fmt::format("Extrapolated to {} = 0, the factor of safety is {}.",
                                  get_text(study, {"extrapolation", "key"}), join_words(parts)));
}

/// What a variant of kind "run" did: onset, paths of the monitors, sections.
void add_run(const fs::path& folder, const json& summary, json& row, json& warnings) {
  if (const json* motion = find(summary, {"motion"})) row["motion"] = take_motion(*motion);
  if (json paths = make_paths(folder, summary, warnings); !paths.is_null()) row["paths"] = std::move(paths);
  if (json sections = make_sections(folder, summary, warnings); !sections.empty())
    row["sections"] = std::move(sections);
}

/// In a large study the table says it.
constexpr std::size_t most_motions = 6;

void say_motions(const json& rows, json& sentences) {
  if (rows.size() > most_motions) return;
  for (const json& row : rows)
    if (const json* motion = find(row, {"motion"}))
      sentences.push_back(fmt::format("{}: {}", row["name"].get<std::string>(), get_text(*motion, {"sentence"})));
}

}  // namespace

StudyContent read_study(const ResultFolder& folder, Packer& packer) {
  StudyContent content;
  content.first.summary = json::object();
  json rows = json::array(), vary = json::array(), columns = json::array(), warnings = json::array();
  std::map<std::string, int> statuses;
  std::vector<PictureSource> sources;
  std::vector<std::size_t> rows_of_sources;
  double wall = 0, cpu = 0;
  for (const json& v : find_list(folder.study, {"variants"})) {
    const std::string name = get_text(v, {"name"}), status = get_text(v, {"status"}, "not started");
    const json summary = read_json(folder.path / get_text(v, {"folder"}, name) / "summary.json");
    json row{{"name", name},
             {"status", status},
             {"reason", get_text(v, {"reason"})},
             {"warnings", summary.is_object() ? find_list(summary, {"warnings"}) : json::array()}};
    ++statuses[status];
    if (!row["reason"].get<std::string>().empty())
      warnings.push_back(fmt::format("{}: {}", name, row["reason"].get<std::string>()));
    for (const json& w : row["warnings"]) warnings.push_back(fmt::format("{}: {}", name, w.get<std::string>()));
    if (summary.is_object()) {
      if (json curve = make_curve(summary); !curve.is_null()) row["curve"] = std::move(curve);
      const fs::path path = folder.path / get_text(v, {"folder"}, name);
      if (content.first.summary.empty()) {
        content.first.summary = summary;
        content.first.path = path;
      }
      add_run(path, summary, row, warnings);
      if (find(summary, {"motion"}) != nullptr || find(summary, {"sections"}) != nullptr) {
        try {
          sources.push_back({name, open_folder(path)});
          if (content.first.path == path) content.first.frames = sources.back().folder.frames;
          rows_of_sources.push_back(rows.size());
        } catch (const Error& error) {
          warnings.push_back(fmt::format("{}: no pictures: {}", name, error.what()));
        }
      }
      wall += get_number(summary, {"timing", "wall"});
      cpu += get_number(summary, {"timing", "cpu"});
    }
    rows.push_back(std::move(row));
  }
  std::vector<std::string> keys;
  for (const json& k : find_list(folder.study, {"vary"})) {
    vary.push_back({{"key", get_text(k, {"key"})}, {"values", find_list(k, {"values"})}});
    keys.push_back(get_text(k, {"key"}));
  }
  for (const json& c : find_list(folder.study, {"columns"})) columns.push_back(make_column(c));

  json sequences = json::array();
  std::vector<Pictures> pictures = pack_pictures(sources, packer);
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    if (pictures[k].sequence.is_null()) continue;
    sequences.push_back(std::move(pictures[k].sequence));
    rows[rows_of_sources[k]]["frames"] = std::move(pictures[k].frames);
  }

  const json* sampling = find(folder.study, {"sampling"});
  // Slices are sampled without folders of variants; the study is written when all samples are there.
  const bool finished = rows.empty() ? sampling != nullptr : statuses.size() == 1 && statuses.contains("finished");
  content.status = finished                           ? "finished"
                   : statuses.contains("interrupted") ? "interrupted"
                   : statuses.contains("not started") ? "unfinished"
                   : statuses.contains("unstable")    ? "unstable"
                                                      : "failed";
  json sentences = json::array();
  if (sampling != nullptr) say_sampling(*sampling, sentences);
  say_extrapolation(folder.study, sentences);
  say_ranges(columns, sentences);
  if (!rows.empty())
    sentences.push_back(fmt::format("A study of {} variant{} of one case{}; {} finished.", rows.size(),
                                    rows.size() == 1 ? "" : "s",
                                    keys.empty() ? "" : ", which differ in " + join_words(keys),
                                    finished ? std::string("all") : std::to_string(statuses["finished"])));
  say_motions(rows, sentences);
  // Of a study without variants, what it says of itself.
  for (const char* key : {"project", "provenance", "units", "input"})
    if (const json* block = find(folder.study, {key}); block != nullptr && !content.first.summary.contains(key))
      content.first.summary[key] = *block;
  if (const std::string title = get_text(folder.study, {"title"}); !title.empty())
    content.first.summary["title"] = title;
  content.first.run = results::from_json<results::RunResult>(content.first.summary, "summary.json");
  content.first.data = input::read_echo(content.first.run.input);
  content.answer = {{"sentences", sentences}, {"factors", json::array()}, {"results", json::array()}};
  content.warnings = warnings;
  if (sampling != nullptr && wall == 0) wall = get_number(*sampling, {"seconds"});
  content.timing = {{"wall", wall}, {"cpu", cpu}, {"parts", json::array()}};
  content.sequences = sequences;
  content.table = {{"vary", vary},
                   {"mode", get_text(folder.study, {"mode"})},
                   {"reference", get_text(folder.study, {"reference"})},
                   {"columns", columns},
                   {"rows", rows}};
  if (sampling != nullptr) content.table["sampling"] = make_sampling(*sampling);
  if (const json* extrapolation = find(folder.study, {"extrapolation"}))
    content.table["extrapolation"] = take_extrapolation(*extrapolation);
  return content;
}

}  // namespace talus::report
