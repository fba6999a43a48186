// SPDX-License-Identifier: MIT
#pragma once
// Piezometric lines of single soils, and grids of pore pressures.

#include <string>

namespace talus::input {

struct Case;
class Findings;

/// Reads the table of [initial.pressure_grid], relative to the folder of the case file `file`, into
/// initial.water.field. Faults are added to `findings`.
void load_pressure_table(Case& data, const std::string& file, Findings& findings);

/// Checks [[initial.piezometric_line]] and [initial.pressure_grid] against the rest of the case.
void check_given_pressures(const Case& data, Findings& findings);

}  // namespace talus::input
