// SPDX-License-Identifier: MIT
#include "report/content/parts.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/units.hpp"
#include "report/folder/numbers.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

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
  std::string text = "initial stress by FEM";
  if (*r.start_factor < 1) text += fmt::format(", with {:.3g} times the strength", 1 / *r.start_factor);
  return text;
}

}  // namespace

json make_timeline(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.timeline) return {};
  const results::Timeline& timeline = *folder.run.timeline;
  json block{{"unit", report::to_json(choose_time_unit(timeline.duration))},
             {"sentence", results::format_failure(timeline)},
             {"factors", json::array()},
             {"states", json::array()},
             {"elements", json::array()},
             {"releases", json::array()}};
  for (const results::TimedFactor& f : timeline.factors)
    block["factors"].push_back(results::format_moment(timeline, f.time));
  for (const results::WaterState& state : timeline.states)
    block["states"].push_back({{"title", results::format_moment(timeline, state.time)}});
  for (const results::TimedReduction& e : timeline.elements)
    block["elements"].push_back(results::format_moment(timeline, e.time));
  const ShownUnits units = read_units(folder.run);
  for (const results::Release& r : timeline.releases)
    block["releases"].push_back({{"title", results::format_moment(timeline, r.time)},
                                 {"start", format_start(r)},
                                 {"front", format_estimate(make_estimates(r).front_advance, units.length)}});
  add_fields(folder, block, packer, warnings);
  return block;
}

}  // namespace talus::report
