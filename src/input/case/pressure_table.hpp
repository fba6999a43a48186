// SPDX-License-Identifier: MIT
#pragma once
// Piezometric lines of single soils, and grids of pore pressures.

#include <string>

namespace talus::input {

struct Case;
struct Material;
class Findings;

/// Reads the table of [initial.pressure_grid], relative to the folder of the case file `file`, into
/// initial.water.field. Faults are added to `findings`.
void load_pressure_table(Case& data, const std::string& file, Findings& findings);

/// Checks [[initial.piezometric_line]] and [initial.pressure_grid] against the rest of the case.
void check_given_pressures(const Case& data, Findings& findings);

/// Returns true if the strength of a soil depends on its pore pressure.
bool has_effective_strength(const Material& soil);
/// Returns why MPM refuses a given pressure in soil without pore water of its own beside soil with it.
std::string describe_missing_water(const std::string& material);

}  // namespace talus::input
