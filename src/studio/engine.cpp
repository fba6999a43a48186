// SPDX-License-Identifier: MIT
#include "studio/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.hpp"
#include "base/user_file.hpp"
#include "input/sketch.hpp"
#include "results/governing.hpp"
#include "run/case_picture.hpp"
#include "run/common/section_of_case.hpp"
#include "run/lem/run_lem.hpp"
#include "run/lem/slice_run.hpp"
#include "site/design_values.hpp"
#include "site/initial_water.hpp"
#include "studio/messages.hpp"
#include "studio/section.hpp"

namespace talus::studio {
namespace {

using nlohmann::json;

/// Writes JSON; bytes of a text that are not UTF-8 are replaced.
std::string write(const json& answer) {
  return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Returns the answer of `work`, or its error as an answer.
template <class Work>
std::string answer(Work work) {
  try {
    return write(work());
  } catch (const InputError& error) {
    const std::vector<Diagnostic>& faults = error.diagnostics();
    const std::string first = faults.empty() ? error.what() : faults.front().sentence;
    return write({{"error", faults.size() > 1 ? fmt::format("{} (and {} more)", first, faults.size() - 1) : first}});
  } catch (...) {
    return write({{"error", explain_failure(std::current_exception()).sentence}});
  }
}

void check_size(const std::string& text) {
  if (text.size() > largest_file::case_file)
    fail_input("the text has {} bytes, and a case has at most {}", text.size(), largest_file::case_file);
}

/// Adds what LEM and the ground of a case without faults in its text show.
void add_model_messages(const input::LoadedCase& loaded, const MessageWriter& writer, json& messages, bool& is_ready) {
  const auto add = [&](const char* severity, const std::string& sentence) {
    writer.add(severity, {"", 0, 0, sentence}, messages);
  };
  try {
    const site::DesignValues design = site::apply_partial_factors(loaded.data);
    for (const std::string& sentence : run::list_ground_warnings(design.data)) add("warning", sentence);
    if (input::uses(loaded.data, input::Method::lem) && !site::needs_seepage(design.data))
      run::prepare_slope(site::Site(design.data));
  } catch (const Error& error) {
    add("error", error.what());
    is_ready = false;
  }
}

json check_text(const std::string& text, const std::string& name) {
  check_size(text);
  const input::Examination found = input::examine_text(text, name);
  const MessageWriter writer(text, found.sketch);
  json messages = json::array();
  for (const Diagnostic& fault : found.faults) writer.add("error", fault, messages);
  for (const Diagnostic& warning : found.warnings) writer.add("warning", warning, messages);
  bool is_ready = found.loaded && found.loaded->is_whole;
  if (is_ready) add_model_messages(*found.loaded, writer, messages, is_ready);
  return {{"messages", std::move(messages)},
          {"spans", writer.spans().values},
          {"keys", writer.spans().keys},
          {"section", write_section(found.sketch, !found.faults.empty())},
          {"ready", is_ready}};
}

struct SolveOptions {
  std::vector<lem::Method> methods;
  int circles = 0;  ///< 0: the search of the case
  int threads = 1;
};

SolveOptions read_options(const std::string& text) {
  constexpr int most_threads = 256, most_circles = 1'000'000;
  const json given = json::parse(text.empty() ? "{}" : text, nullptr, false);
  if (!given.is_object()) fail_input("the options of solve must be a JSON object such as {{\"circles\": 1000}}");
  SolveOptions options;
  for (const auto& [key, value] : given.items()) {
    const auto read_count = [&, &key = key, &value = value](int most) {
      if (!value.is_number_integer() || value.get<double>() < 1 || value.get<double>() > most)
        fail_input("the option '{}' must be a whole number from 1 to {}", key, most);
      return value.get<int>();
    };
    if (key == "circles")
      options.circles = read_count(most_circles);
    else if (key == "threads")
      options.threads = read_count(most_threads);
    else if (key != "methods")
      fail_input("there is no option '{}'; known are 'methods', 'circles' and 'threads'", key);
    if (key != "methods") continue;
    if (!value.is_array() || value.empty()) fail_input("the option 'methods' must be a list such as [\"bishop\"]");
    for (const json& word : value) {
      const auto method = word.is_string() ? results::from_word<lem::Method>(word.get<std::string>()) : std::nullopt;
      if (!method)
        fail_input("{} is no method of [lem]; known are {}", word.dump(-1, ' ', false, json::error_handler_t::replace),
                   fmt::join(results::words<lem::Method>, ", "));
      if (std::find(options.methods.begin(), options.methods.end(), *method) == options.methods.end())
        options.methods.push_back(*method);
    }
  }
  return options;
}

/// Returns the settings of a search of about `circles` surfaces in place of those of the case.
lem::SearchOptions make_quick_search(const input::Case& data, const SolveOptions& asked) {
  constexpr int depths = 8, radii = 8, least_places = 3;
  lem::SearchOptions options = run::make_search_options(data, asked.threads);
  options.optimise_surface = options.optimise_circle = false;
  options.kept_minima = 1;
  const double places = static_cast<double>(asked.circles) / depths;
  if (options.entry_exit) {
    lem::EntryExitSearch& search = *options.entry_exit;
    search.depths = depths;
    // Any two of n points of the whole ground, or each exit with each entry.
    const int all = static_cast<int>(search.is_whole_ground() ? std::sqrt(2 * places) : 2 * std::sqrt(places));
    search.exits = std::max(least_places, all / 2);
    search.entries = std::max(least_places, all - all / 2);
  }
  if (options.grid) {
    options.grid->radii = radii;
    options.grid->columns = options.grid->rows =
        std::max(least_places, static_cast<int>(std::sqrt(static_cast<double>(asked.circles) / radii)));
  }
  if (options.block) options.block->surfaces = std::min(options.block->surfaces, asked.circles);
  return options;
}

json write_surface(const results::SlipSurface& surface, bool is_searched) {
  json out{{"method", results::to_word(surface.method)},
           {"title", surface.title},
           {"factor", nullptr},
           {"circular", surface.circular},
           {"points", surface.points},
           {"circle", nullptr},
           {"searched", is_searched}};
  if (surface.factor) out["factor"] = *surface.factor;
  if (surface.circle) out["circle"] = {{"centre", surface.circle->centre}, {"radius", surface.circle->radius}};
  if (surface.name) out["name"] = *surface.name;
  return out;
}

/// Runs the search of the case, or a quick one and the optimisation of its best circle.
results::SliceResult run_search(const input::Case& data, const SolveOptions& asked) {
  const run::PreparedSlope prepared = run::prepare_slope(site::Site(data));
  if (asked.circles == 0) return run::run_lem(data, prepared, asked.threads).result;
  const lem::SearchOptions options = make_quick_search(data, asked);
  const lem::SearchResult found = lem::search(*prepared.slope, options);
  results::SliceResult result;
  result.methods = options.methods;
  result.warnings = prepared.notes;
  result.search = run::make_search_result(options, found);
  for (const lem::Critical& c : found.circular)
    result.critical.push_back(
        run::make_critical_result(*prepared.slope, lem::optimise(*prepared.slope, c.surface, c.method, options)));
  for (const lem::Critical& c : found.noncircular)
    result.noncircular.push_back(run::make_critical_result(*prepared.slope, c));
  return result;
}

json write_result(const results::SliceResult& result) {
  json out{{"factor", nullptr}, {"surface", json::array()}, {"circle", nullptr}, {"searched", 0}};
  if (result.search) out["searched"] = result.search->tried;
  if (const auto governing = results::find_governing_surface(result, nullptr)) {
    const results::CriticalSurface& found = *governing->found;
    const json surface = write_surface(found.surface, true);
    out["factor"] = surface["factor"];
    out["method"] = surface["method"];
    out["title"] = surface["title"];
    out["surface"] = surface["points"];
    out["circle"] = surface["circle"];
    out["slides_left"] = found.slides_left;
  }
  json& surfaces = out["surfaces"] = json::array();
  for (const auto* list : {&result.critical, &result.noncircular})
    for (const results::CriticalSurface& c : *list) surfaces.push_back(write_surface(c.surface, true));
  for (const results::CriticalSurface& c : result.given) surfaces.push_back(write_surface(c.surface, false));
  return out;
}

json solve_text(const std::string& text, const std::string& options, const std::string& name) {
  check_size(text);
  const SolveOptions asked = read_options(options);
  input::LoadedCase loaded = input::read_case_text(text, name);
  // Only a case with LEM among its methods is refused for what LEM does not take, such as three dimensions.
  const bool is_of_case = input::uses(loaded.data, input::Method::lem);
  if (!is_of_case) loaded = input::read_case_text(text, name, {{"analysis.methods", "[\"lem\"]"}});
  const site::DesignValues design = site::apply_partial_factors(loaded.data);
  input::Case data = design.data;
  if (!asked.methods.empty()) data.lem.methods = asked.methods;
  if (asked.circles > 0 && site::needs_seepage(data))
    fail_input("the pore pressures of this case come from seepage, which takes too long while drawing: run the case");
  const results::SliceResult result = run_search(data, asked);
  json out = write_result(result);
  json& messages = out["messages"] = json::array();
  const auto add = [&](const char* severity, const std::string& sentence) {
    messages.push_back({{"severity", severity}, {"text", sentence}});
  };
  if (!is_of_case) add("note", "LEM is not among the methods of the case: its settings are the defaults of [lem].");
  for (const std::string& warning : result.warnings) add("warning", warning);
  if (asked.circles == 0 && data.lem.referee && result.search)
    add("note",
        "The factors were not held against limit analysis; a run does that, and its smallest factor that is "
        "possible governs.");
  return out;
}

}  // namespace

std::string check(const std::string& text, const std::string& name) {
  return answer([&] { return check_text(text, name); });
}

std::string solve(const std::string& text, const std::string& options, const std::string& name) {
  return answer([&] { return solve_text(text, options, name); });
}

std::string schema() {
  return input::write_schema().dump(2) + "\n";
}

std::string template_text() {
  return input::write_template();
}

}  // namespace talus::studio
