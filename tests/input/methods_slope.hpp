// SPDX-License-Identifier: MIT
#pragma once
// A minimal slope for LEM, and checks of the messages on faults in variants of it.

#include "slope.hpp"

namespace talus::input {

/// ACADS 1(a) of Giam and Donald.
inline const std::string slices_alone = R"(title = "Slices alone"

[[geometry.polygon]]
name = "soil"
points = [[0, 20], [90, 20], [90, 35], [50, 35], [30, 25], [0, 25]]

[materials.soil]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 3
friction_angle = 19.6

[regions]
soil = "soil"

[analysis]
methods = ["lem"]
)";

/// Further keys that FEM needs.
inline const std::string stiffness =
    "young_modulus = 1e5\npoisson_ratio = 0.3\ndilatancy_angle = 0\ntensile_strength = 0\n";

inline const std::string with_elements =
    change(change(slices_alone, "friction_angle = 19.6\n", "friction_angle = 19.6\n" + stiffness), "[\"lem\"]",
           "[\"lem\", \"fem\"]") +
    "[fem]\nsize = 1.5\n";

/// The dry slope of slope.hpp by all three methods.
inline const std::string all_three = slope + "[analysis]\nmethods = [\"lem\", \"fem\", \"mpm\"]\n";

inline Case read(const std::string& text, const std::vector<Override>& overrides = {}) {
  try {
    return read_case_text(text, "slope.toml", overrides).data;
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what() << "\nin\n" << text;
    return {};
  }
}

/// Expects exactly one fault, wherever it is, whose sentence holds `part`.
inline void expect_one_fault(const std::string& text, const std::string& part) {
  const std::vector<Diagnostic> faults = find_faults(text);
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "" : InputError(faults).what()) << "\nexpected: " << part;
  EXPECT_NE(faults[0].sentence.find(part), std::string::npos) << faults[0].sentence << "\nexpected: " << part;
}

}  // namespace talus::input
