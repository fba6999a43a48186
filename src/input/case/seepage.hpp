// SPDX-License-Identifier: MIT
#pragma once
// [seepage]: the flow of water alone, with discharges, exit gradients, and the safety against uplift and heave.

#include <array>
#include <string>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

struct Case;
class Findings;

/// A line through which the discharge is computed.
struct FlowSection {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< [m]
};

/// A block of soil between a level and the ground, whose safety against heave is computed.
struct HeaveBlock {
  std::string name;
  std::array<double, 2> x{};  ///< from, to [m]
  double level = 0;           ///< of its base [m]
};

struct SeepageAnalysis {
  std::vector<double> times;  ///< of the results after time 0 [s]; empty: steady flow alone
  std::vector<FlowSection> sections;
  std::vector<HeaveBlock> blocks;
};

void describe(Visitor& v, FlowSection& s);

void describe(Visitor& v, HeaveBlock& b);

void describe(Visitor& v, SeepageAnalysis& s);

void check_seepage(const Case& data, Findings& findings);

}  // namespace talus::input
