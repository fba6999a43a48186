// SPDX-License-Identifier: MIT
#pragma once
// Checks between the keys of a case. A check reports nothing about keys that are already faulty.

#include <set>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// Returns false and adds a fault if the section has more corners than the geometric checks, of quadratic cost, allow.
bool check_extent(const Case& data, Findings& findings);
/// Moves corners that nearly lie on another polygon onto it, with a warning.
void join_polygons(Case& data, Findings& findings);
/// Checks polygons, lines, box and points per element.
void check_geometry(const Case& data, Findings& findings);
/// Checks for overlaps and gaps of polygons, and for faults that the mesh generator rejects; after check_geometry().
void check_cover(const Case& data, Findings& findings);
/// Checks that the keys listed in `unusual` are in the file.
void check_unusual(const Case& data, Findings& findings);
/// Checks materials and their assignment to regions.
void check_materials(const Case& data, Findings& findings);
/// Checks [[roots]], the rooted soils, and the stage of initial.equilibrium.
void check_roots(const Case& data, Findings& findings);
/// Checks directions, names of sides and regions, and units of the output.
void check_conditions(const Case& data, Findings& findings);
/// Checks the result that the case starts from, and keys that it replaces.
void check_result(const Case& data, Findings& findings);
/// Reports an initial stress that is not possible in the case.
void check_start_stress(const Case& data, Findings& findings);
/// Checks stages, strength reduction and names of monitors.
void check_analysis(const Case& data, Findings& findings);
/// Checks the requirements and limitations of the methods of [analysis].
void check_methods(const Case& data, Findings& findings);
/// Checks [lem] and its surfaces, surcharges and partial factors.
void check_slices(const Case& data, Findings& findings);
class SoilOutline;
/// Checks the [[lem.surface]] at `path`.
void check_slip_surface(const SlipSurface& surface, const std::string& path, const SoilOutline& soil,
                        Findings& findings);
/// Checks windows, layers, tangents, excluded areas and impenetrable soil of [lem].
void check_slip_search(const Case& data, const SoilOutline& soil, Findings& findings);
/// Returns true if a list is [from, to], increasing. Returns false for an empty list; false with a finding for any
/// other list. `what` is the name of the numbers in the finding.
bool check_range(const std::vector<double>& range, const std::string& path, const char* what, Findings& findings);
/// Returns true if a water table has points from left to right; false with a finding, unless there is one already.
bool check_water_table(const std::vector<std::array<double, 2>>& line, const std::string& path, const ShownUnit& length,
                       Findings& findings);
/// Checks uncertain numbers of a study, their correlations, and the key of the extrapolation.
void check_sampling(const Case& data, Findings& findings);
/// Checks [water], the water of the materials, and keys of stages and [initial] that depend on pore water.
void check_water(const Case& data, Findings& findings);
/// Checks hydraulic conditions and the initial pore pressure.
void check_hydraulics(const Case& data, Findings& findings);
/// Checks the requirements and limitations of [lem.drawdown].
void check_drawdown(const Case& data, Findings& findings);
/// Checks the requirements of [timeline] and its times.
void check_timeline(const Case& data, Findings& findings);
/// Checks the reference stage of times and the sections of the output.
void check_output(const Case& data, Findings& findings);
/// Checks names, units and tolerances of the values to compare with. A result that this case leaves out is not a fault:
/// the report lists it as not calculated.
void check_compare(const Case& data, Findings& findings);
/// Checks names, materials and paths of element tests.
void check_point_tests(const Case& data, Findings& findings);
/// Checks keys, limits and curves of [calibration] and derives its further members, also from measurement files
/// relative to the folder of the case file `file`. Requires check_point_tests() before.
void complete_calibration(Case& data, const std::string& file, Findings& findings);

/// Reports names that occur twice in a list of tables.
void check_names(const auto& list, const std::string& path, const char* what, Findings& findings) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (const std::string at = fmt::format("{}.{}.name", path, i);
        findings.is_sound(at) && !names.insert(list[i].name).second)
      findings.add(at, "there are two {} named '{}'", what, list[i].name);
}
/// Returns true if any material has pore water.
bool is_wet(const Case& data);
/// Reports boundaries, tractions, hydraulic conditions and roots on sides that are not in `sides`.
void check_sides(const Case& data, const std::set<std::string>& sides, Findings& findings);
/// Reports regions without material, and materials and velocities of regions that do not exist.
void check_regions(const Case& data, const std::set<std::string>& regions, Findings& findings);

// Completion of a case by values that follow from several keys, and replacement of harmful settings.

/// Completes a case before the checks: paths relative to the folder of the case file `file`, porosities, densities of
/// soils with a given unit weight, and defaults of a case without MPM: box, element size, supports.
void complete(Case& data, const std::string& file, const Places& places);

/// Sets the units of messages. If [output] names an unknown unit, which check_conditions() reports, they stay metric.
void complete_units(Case& data);

/// Sets the porosities that follow from given void ratios.
void complete_porosities(Case& data);

// Combinations of keys that are known to ruin a calculation, and their replacements.

/// Replaces harmful settings of stages and of the trials of the displacement curve and returns a sentence for each:
/// setting, place, reason and replacement. The echo and all methods use the replaced values.
std::vector<std::string> replace_harmful(Case& data);

}  // namespace talus::input
