// SPDX-License-Identifier: MIT
#pragma once
// What must hold between the keys of a case. A check is silent about keys that are already known to be wrong.

#include <set>
#include <string>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// Returns false, and adds a fault, where the section has more corners than the checks of geometry take, which compare
/// each with all others.
bool check_extent(const Case& data, Findings& findings);
/// Moves corners that nearly lie on another polygon onto it, with a warning that says so.
void join_polygons(Case& data, Findings& findings);
/// Polygons, lines, box and points per element.
void check_geometry(const Case& data, Findings& findings);
/// Whether the polygons overlap or leave gaps, and whether the mesh generator can take them; after check_geometry.
void check_cover(const Case& data, Findings& findings);
/// Whether the keys that `unusual` names are in the file.
void check_unusual(const Case& data, Findings& findings);
/// Materials, and which region has which.
void check_materials(const Case& data, Findings& findings);
/// [[roots]], the soils that they are in, and the stage of initial.equilibrium.
void check_roots(const Case& data, Findings& findings);
/// Vectors that need a direction, names of sides and regions, units of the output.
void check_conditions(const Case& data, Findings& findings);
/// The result that the case starts from, and what has no meaning with one.
void check_result(const Case& data, Findings& findings);
/// Reports a stress at the start that the case cannot begin with.
void check_start_stress(const Case& data, Findings& findings);
/// Stages, strength reduction and names of monitors.
void check_analysis(const Case& data, Findings& findings);
/// The methods of [analysis]: what each of them needs of the case, and what it cannot take.
void check_methods(const Case& data, Findings& findings);
/// [lem] and its surfaces, surcharges and partial factors.
void check_slices(const Case& data, Findings& findings);
class SoilOutline;
/// One [[lem.surface]], which is at `path`.
void check_slip_surface(const SlipSurface& surface, const std::string& path, const SoilOutline& soil,
                        Findings& findings);
/// Whether a list is [from, to], increasing. False for an empty list; false with a finding for any other wrong list.
/// `what` names the numbers.
bool check_range(const std::vector<double>& range, const std::string& path, const char* what, Findings& findings);
/// Whether a water table has points that run from left to right; false with a finding, or where one stands already.
bool check_water_table(const std::vector<std::array<double, 2>>& line, const std::string& path, Findings& findings);
/// Uncertain numbers of a study and their correlations, and the key that is extrapolated.
void check_sampling(const Case& data, Findings& findings);
/// The pore water itself, that of the materials, and whether stages and start ask for what needs it.
void check_water(const Case& data, Findings& findings);
/// Hydraulic conditions and the pore pressure at the start.
void check_hydraulics(const Case& data, Findings& findings);
/// [lem.drawdown]: what it needs of the case, and what it cannot take.
void check_drawdown(const Case& data, Findings& findings);
/// [timeline]: what it needs of the case, and its times.
void check_timeline(const Case& data, Findings& findings);
/// Clock and sections of the output.
void check_output(const Case& data, Findings& findings);
/// Names, units and tolerances of the values that results are compared with. A result that this case leaves out is
/// no fault: the report says that it was not calculated.
void check_compare(const Case& data, Findings& findings);
/// Element tests: names, materials, and what each of them follows.
void check_point_tests(const Case& data, Findings& findings);
/// [calibration]: keys, limits and curves, and what follows from them and from the files of the measurements, which are
/// found from the folder of the case file `file`. The tests must be checked before.
void complete_calibration(Case& data, const std::string& file, Findings& findings);

/// Whether any material has pore water.
bool is_wet(const Case& data);
/// Reports boundaries, tractions, hydraulic conditions and roots on sides that are not in `sides`.
void check_sides(const Case& data, const std::set<std::string>& sides, Findings& findings);
/// Reports regions without material, and materials and velocities for regions that do not exist.
void check_regions(const Case& data, const std::set<std::string>& regions, Findings& findings);

}  // namespace talus::input
