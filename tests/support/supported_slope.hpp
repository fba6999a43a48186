// SPDX-License-Identifier: MIT
#pragma once
// Supported slopes for FEM: strength reduction of a case from its text, and a published slope with a plate.

#include <fmt/format.h>

#include <string>
#include <utility>

#include "fem/solid/solid.hpp"
#include "input/read.hpp"
#include "run/fem/solid_of_case.hpp"
#include "site/site.hpp"

namespace talus::support {

inline site::Site read_site(const std::string& text) {
  return site::Site(input::read_case_text(text, "supported.toml").data);
}

/// The model is returned too, because results refer to it.
struct Reduced {
  run::SolidOfCase<2> solid;
  fem::ReductionResult<2> found;
};

inline Reduced reduce(run::SolidOfCase<2> solid, double from, double to) {
  Reduced reduced{std::move(solid), {}};
  fem::ReductionOptions options;
  options.from = from, options.to = to;
  reduced.found = fem::reduce_strength<2>(reduced.solid.model, options);
  return reduced;
}
/// `share`: size of the elements over that of the case.
inline Reduced reduce(const site::Site& site, double share, double from, double to) {
  return reduce(run::make_solid<2>(site, share), from, to);
}

/// Torggler (2016), 10 m at 30° on 20 m: PLAXIS has 1.111, and 1.175 with a plate of 7.5 m in the middle of the slope.
/// `plate`: its keys in [support.plate] but for the stiffness; empty: none.
inline std::string write_torggler_slope(const std::string& plate) {
  const std::string slope = R"(
title = "Plate in a slope"
[geometry]
ground = [[0, 20], [20, 20], [37.32, 30], [57, 30]]
[[geometry.layer]]
name = "soil"
level = 0
[regions]
soil = "soil"
[materials.soil]
model = "mohr_coulomb"
unit_weight = 16
cohesion = 10
friction_angle = 15
dilatancy_angle = 0
tensile_strength = 0
young_modulus = 2
poisson_ratio = 0.4
[analysis]
methods = ["fem"]
[fem]
size = 1
)";
  return plate.empty() ? slope : slope + "[support.plate]\naxial_stiffness = 2e6\nbending_stiffness = 4e4\n" + plate;
}

/// A smooth sheet pile of `length` along a cut of 3 m in sand, φ = ψ = 35°. `more`: further keys of its table, and
/// tables.
inline std::string write_sheet(double length, const std::string& more = "") {
  return fmt::format(R"(
title = "Cantilever sheet pile"
[geometry]
ground = [[0, 3], [12, 3], [12, 0], [24, 0]]
[[geometry.layer]]
name = "sand"
level = -9
[regions]
sand = "sand"
[materials.sand]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 0.2
friction_angle = 35
dilatancy_angle = 35
tensile_strength = 0
young_modulus = 30
poisson_ratio = 0.3
[analysis]
methods = ["fem", "lem"]
[lem]
methods = ["bishop"]
[fem]
size = 0.5
[support.sheet]
kind = "wall"
line = [[12, 3], [12, {}]]
bond_friction = 0
axial_stiffness = 2e6
bending_stiffness = 5e4
{}
)",
                     3 - length, more);
}

}  // namespace talus::support
