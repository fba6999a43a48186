// SPDX-License-Identifier: MIT
#pragma once
// The definition of a unit in SI base units, from UDUNITS-2 (unit_database.cpp), or in WebAssembly from a table of its
// units (unit_table.cpp, docs/decisions/0054-webassembly.md).

#include <array>
#include <optional>
#include <string>

namespace talus::units {

/// A value in this unit is factor · value + offset in SI base units with these powers.
struct UnitDefinition {
  /// Base units in the order of `powers`; the radian is one of them, which separates angles from plain numbers.
  static constexpr std::array<const char*, 8> base{"m", "kg", "s", "A", "K", "mol", "cd", "rad"};

  double factor = 1, offset = 0;
  std::array<int, 8> powers{};
};

/// Units of practice that are missing in the database. A ton is 2000 pounds.
inline constexpr std::array<std::array<const char*, 2>, 8> practice_units{{{"deg", "degree"},
                                                                           {"psf", "pound_force/foot2"},
                                                                           {"ksf", "1000 pound_force/foot2"},
                                                                           {"tsf", "2000 pound_force/foot2"},
                                                                           {"pcf", "pound_force/foot3"},
                                                                           {"kcf", "1000 pound_force/foot3"},
                                                                           {"plf", "pound_force/foot"},
                                                                           {"klf", "1000 pound_force/foot"}}};

/// Returns the definition of "kN/m3" or "kg m-3"; nullopt if the text is no unit. Calls must be serialised.
std::optional<UnitDefinition> define_unit(const std::string& text);

}  // namespace talus::units
