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

void describe(auto& v, FlowSection& s) {
  v.key("name", s.name, plain().required().example(R"("core")"), "Name of the section in results.");
  v.key("points", s.points, quantity("m").required().example("[[30, 0], [30, 12]]"),
        "A line through the soil. Flow is positive to its right, seen from its first point to its last.");
}

void describe(auto& v, HeaveBlock& b) {
  v.key("name", b.name, plain().required().example(R"("behind the wall")"), "Name of the block in results.");
  v.key("x", b.x, quantity("m").required().example("[20, 22.5]"),
        "From where to where it reaches. Behind a cut-off: half its embedded depth (Terzaghi).");
  v.key("level", b.level, quantity("m").required().example("5"), "Level of its base, such as the tip of the cut-off.");
}

void describe(auto& v, SeepageAnalysis& s) {
  v.key("times", s.times, quantity("day").above(0).example(R"(["6 h", 1, 3])"),
        "Times after time 0 at which transient flow is written. It begins with the pore pressure of [initial]; the "
        "[[hydraulic]] series give the boundaries. Without times the flow is steady.");
  v.tables("section", s.sections, 0, "A line through which the discharge is computed.");
  v.tables("heave", s.blocks, 0,
           "A block of soil that upward flow may lift: F = buoyant weight over the force of the excess pore pressure "
           "at its base (Terzaghi).");
}

void check_seepage(const Case& data, Findings& findings);

}  // namespace talus::input
