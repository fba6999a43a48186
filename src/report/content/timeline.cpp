// SPDX-License-Identifier: MIT
#include "report/content/timeline.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/units.hpp"
#include "report/content/water_states.hpp"
#include "report/words/numbers.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

json write(const std::optional<double>& value) {
  return value ? json(*value) : json();
}

/// Adds the fields of the states and their mesh. Files that cannot be read are omitted with a warning.
void add_fields(const ResultFolder& folder, json& block, Packer& packer, json& warnings) {
  try {
    const auto file = results::read_file<results::WaterFields>(folder.path / "timeline_water.json");
    if (!file || file->nodes.empty() || file->elements.empty()) return;
    block["water_mesh"] = pack_water_mesh(*file, "timeline", packer);
    const std::vector<results::WaterState>& states = folder.run.timeline->states;
    for (std::size_t i = 0; i < states.size(); ++i)
      if (json packed = pack_water_field(*file, states[i], fmt::format("timeline.{}", i), packer); !packed.is_null())
        block["states"][i]["fields"] = std::move(packed);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The fields of the pore water in time are not drawn: {}", error.what()));
  }
}

/// Returns the clause on the initial stress of MPM and on rest before the release.
std::string format_start(const results::Release& r) {
  if (!r.start_factor) return r.rests ? "came to rest" : "did not rest";
  std::string text = "stress of finite elements";
  if (*r.start_factor < 1) text += fmt::format(", with {:.3g} times the strength", 1 / *r.start_factor);
  return text;
}

}  // namespace

json make_timeline(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.timeline) return {};
  const results::Timeline& timeline = *folder.run.timeline;
  json factors = json::array(), states = json::array();
  for (const results::TimedFactor& f : timeline.factors)
    factors.push_back({{"time", f.time},
                       {"title", results::format_moment(timeline, f.time)},
                       {"factor", write(f.factor)},
                       {"method", f.surface.title},
                       {"source", f.source},
                       {"refusal", f.refusal},
                       {"points", f.surface.points}});
  for (const results::WaterState& state : timeline.states)
    states.push_back(write_water_state(state, results::format_moment(timeline, state.time)));
  json block{{"duration", timeline.duration},
             {"start", timeline.start ? json(*timeline.start) : json()},
             {"unit", report::to_json(choose_time_unit(timeline.duration))},
             {"target", timeline.target},
             {"sentence", results::format_failure(timeline)},
             {"factors", factors},
             {"states", states},
             {"least", write(timeline.least)},
             {"least_time", write(timeline.least_time)},
             {"distance", write(timeline.distance)},
             {"seepage_seconds", timeline.seepage_seconds},
             {"steps", timeline.weather.steps},
             {"step_error", timeline.step_error},
             {"search_seconds", timeline.search_seconds},
             {"water",
              {{"inflow", timeline.weather.inflow},
               {"outflow", timeline.weather.outflow},
               {"runoff", timeline.weather.runoff},
               {"standing", timeline.weather.standing.value_or(0)},
               {"transpired", timeline.weather.transpired},
               {"growth", timeline.weather.growth},
               {"error", timeline.weather.error}}}};
  for (const results::TimedReduction& e : timeline.elements) {
    json runs = json::array();
    for (const results::ElementRun& r : e.runs)
      runs.push_back({{"flow", results::to_word(r.flow)}, {"factor", r.factor}, {"slip_line", r.slip_line}});
    block["elements"].push_back({{"time", e.time},
                                 {"title", results::format_moment(timeline, e.time)},
                                 {"folder", e.folder},
                                 {"runs", std::move(runs)},
                                 {"error", e.error ? json(*e.error) : json()}});
  }
  const ShownUnits units = read_units(folder.run);
  for (const results::Release& r : timeline.releases)
    block["releases"].push_back({{"time", r.time},
                                 {"title", results::format_moment(timeline, r.time)},
                                 {"factor", write(r.factor)},
                                 {"folder", r.folder},
                                 {"start", format_start(r)},
                                 {"error", r.error ? json(*r.error) : json()},
                                 {"largest_displacement", r.largest_displacement},
                                 {"moved_volume", r.moved_volume},
                                 {"front", format_uncertain(r.front_advance, r.front_uncertainty, units.length)}});
  if (timeline.failure) {
    const results::FailureTime& f = *timeline.failure;
    block["failure"] = {{"from", f.from}, {"to", f.to}, {"earliest", f.earliest}, {"latest", write(f.latest)}};
  }
  add_fields(folder, block, packer, warnings);
  return block;
}

}  // namespace talus::report
