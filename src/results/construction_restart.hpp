// SPDX-License-Identifier: MIT
#pragma once
// construction_state.json: the stages of construction that are computed, from which a resumed run goes on.

#include <string>
#include <vector>

#include "results/construction.hpp"

namespace talus::results {

/// State at the end of the last computed stage, and all results up to there. Numbers read back as the same doubles.
struct ConstructionRestart {
  std::string input_hash;
  Construction summary;  ///< without monitors and lines
  std::vector<ConstructionMonitor> monitors;
  std::vector<ConstructionLine> lines;
  std::vector<double> times;  ///< of the monitors [s]
  ConstructionFile fields;
  std::vector<double> first_head;      ///< at the start of the stages [m]
  std::vector<double> start_pressure;  ///< nodal pore pressures at the start of the last stage [Pa]
  std::vector<double> head;            ///< at its end [m]
  std::vector<double> displacement, stress, state, strain, bars;  ///< of fem::SolidState, one number after the other
  std::vector<int> yields;
  std::vector<std::string> warnings;
  std::vector<std::vector<std::string>> stage_warnings;  ///< a warning, then the stages that have it
};
void describe(auto& v, As<ConstructionRestart> auto& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "results of the stages"});
  v.key("monitors", r.monitors, {"", "monitored places"});
  v.key("lines", r.lines, {"", "section lines"});
  v.key("times", r.times, {"s", "times of the monitors"});
  v.key("fields", r.fields, {"", "fields at the ends of the stages"});
  v.key("first_head", r.first_head, {"m", "heads at the start of the stages"});
  v.key("start_pressure", r.start_pressure, {"Pa", "pore pressures at the start of the last stage"});
  v.key("head", r.head, {"m", "heads at its end"});
  v.key("displacement", r.displacement, {"m", "displacements"});
  v.key("stress", r.stress, {"Pa", "effective stresses"});
  v.key("state", r.state, {"", "state variables"});
  v.key("strain", r.strain, {"", "strains"});
  v.key("bars", r.bars, {"m", "deformations of supports"});
  v.key("yields", r.yields, {"", "points that have yielded"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("stage_warnings", r.stage_warnings, {"", "warnings of the methods, each with its stages"});
}

}  // namespace talus::results
