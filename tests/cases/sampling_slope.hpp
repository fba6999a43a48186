// SPDX-License-Identifier: MIT
#pragma once
// The slope of Li and Lumb with uncertain parameters, and an empty folder for its results.

#include <filesystem>
#include <string>

#include "input/read.hpp"
#include "support/scratch.hpp"

namespace talus::sampling_slope {

/// Mean values of Li and Lumb (1987): 1:1, 10 m, c = 18 kPa, φ = 30°, γ = 18 kN/m³, r_u = 0.2; `more` is appended.
inline std::string write_case(const std::string& more) {
  return R"(
title = "Li and Lumb"
[[geometry.polygon]]
name = "soil"
points = [[-10, 0], [40, 0], [40, 15], [15, 15], [5, 5], [-10, 5]]
[regions]
soil = "soil"
[materials.soil]
model = "mohr_coulomb"
unit_weight = "18 kN/m3"
cohesion = "18 kPa"
friction_angle = "30 deg"
pore_pressure_ratio = 0.2
[analysis]
methods = ["lem"]
[lem]
methods = ["bishop"]
noncircular = false
referee = false
[lem.entry_exit]
exits = 15
entries = 15
depths = 9
)" + more;
}

/// The deviations of Hassan and Wolff (1999); all distributions normal and independent.
inline const std::string deviations = R"(
[[study.random]]
key = "materials.soil.cohesion"
deviation = "3.6 kPa"
[[study.random]]
key = "materials.soil.friction_angle"
deviation = "3 deg"
[[study.random]]
key = "materials.soil.unit_weight"
deviation = 0.9
[[study.random]]
key = "materials.soil.pore_pressure_ratio"
deviation = 0.02
)";

inline input::LoadedCase read(const std::string& study, const std::vector<input::Override>& changes = {}) {
  return input::read_case_text(write_case(study), "li_lumb.toml", changes);
}

inline std::filesystem::path make_folder(const std::string& name) {
  const std::filesystem::path folder = support::name_scratch(name);
  std::filesystem::remove_all(folder);
  return folder;
}

}  // namespace talus::sampling_slope
