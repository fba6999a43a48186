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
  std::vector<double> steady_head;     ///< of steady flow at the end of the last stage [m]
  std::vector<double> start_pressure;  ///< nodal pore pressures at the start of the last stage [Pa]
  std::vector<double> head;            ///< at its end [m]
  std::vector<double> displacement, stress, state, strain, bars;  ///< of fem::SolidState, one number after the other
  std::vector<int> yields;
  std::vector<std::string> warnings;
  std::vector<std::vector<std::string>> stage_warnings;  ///< a warning, then the stages that have it
};
void describe(Visitor& v, ConstructionRestart& r);

}  // namespace talus::results
