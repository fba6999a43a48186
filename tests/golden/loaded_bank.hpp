// SPDX-License-Identifier: MIT
#pragma once
// A case file of a bank on a softer base with a load at its crest, dry or wet, in which points soon cross element
// boundaries.

#include <fmt/format.h>

#include <string>

namespace talus::golden {

inline constexpr const char* settle = "[[stage]]\nname = \"settle\"\nduration = 0.25\ndamping = 0.2\n";
inline constexpr const char* slide =
    "[[stage]]\nname = \"slide\"\nduration = 0.35\ndamping = 0.01\nsmoothing = \"strain\"\n";
inline constexpr const char* come_to_rest =
    "[[stage]]\nname = \"rest\"\nduration = 20\nuntil = \"rest\"\ndamping = 0.7\n";

struct Bank {
  int dimension = 2;
  bool wet_base = false, wet_bank = false;
  std::string base = "a", bank = "b";  ///< materials of the regions base and bank
  double cohesion = 1.5;               ///< of the bank [kPa]
  std::string stages = settle;
};

inline std::string write_material(const std::string& name, double porosity, double cohesion, bool wet) {
  std::string text = fmt::format(R"(
[materials.{}]
model = "mohr_coulomb"
grain_density = 2650
porosity = {}
young_modulus = "5 MPa"
poisson_ratio = 0.3
cohesion = {}
friction_angle = 20
dilatancy_angle = 0
tensile_strength = 0
)",
                                 name, porosity, cohesion);
  if (wet)
    text += fmt::format(R"([materials.{}.water]
retention = "van_genuchten"
reference_pressure = 6
lambda = 0.3
minimum_saturation = 0.1
conductivity = 1e-4
relative_conductivity = "mualem"
)",
                        name);
  return text;
}

/// The part of the case after the materials: rain on the crest when anything is wet, rest, and the stages.
inline std::string write_rest(const Bank& bank) {
  std::string text = "[rest]\nhold = 0.05\n";
  if (bank.wet_base || bank.wet_bank) text += "[water]\nbulk_modulus = 50000\n";
  if (bank.wet_bank) text += "[[hydraulic]]\non = \"crest\"\ncondition = \"rain\"\nrate = \"100 mm/h\"\n";
  return text + bank.stages;
}

inline std::string write_bank(const Bank& bank) {
  const bool solid = bank.dimension == 3;
  return fmt::format(R"(title = "Bank"
[geometry]
dimension = {}
box = [[0, 0], [6, 3]]
{}
[[geometry.polygon]]
name = "base"
points = [[0, 0], [6, 0], [6, 1], [0, 1]]
[[geometry.polygon]]
name = "bank"
points = [[0, 1], [3, 1], [2.5, 2.5], [0, 2.5]]
[[geometry.line]]
name = "crest"
points = [[0, 2.5], [2.5, 2.5]]
[mesh]
size = {}
[regions]
base = "{}"
bank = "{}"
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[boundary]]
on = "right"
fix = "normal"
{}
[[traction]]
on = "crest"
traction = [0, "-5 kPa"]
)",
                     bank.dimension, solid ? "thickness = 0.8" : "", solid ? 0.8 : 0.4, bank.base, bank.bank,
                     solid ? "[[boundary]]\non = \"front\"\nfix = \"normal\"\n[[boundary]]\non = \"back\"\nfix = "
                             "\"normal\""
                           : "") +
         write_material(bank.base, 0.4, 4, bank.wet_base) +
         write_material(bank.bank, 0.3, bank.cohesion, bank.wet_bank) + write_rest(bank);
}

}  // namespace talus::golden
