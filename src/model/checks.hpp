#pragma once
// What must hold between the keys of a case. A check is silent about keys that are already known to be wrong.

#include <set>
#include <string>

#include "model/case.hpp"
#include "model/findings.hpp"

namespace talus::model {

/// Polygons, lines, box and points per element.
void check_geometry(const Case& data, Findings& findings);
/// Materials, and which region has which.
void check_materials(const Case& data, Findings& findings);
/// Vectors that need a direction, names of sides and regions, units of the output.
void check_conditions(const Case& data, Findings& findings);
/// The result that the case starts from, and what has no meaning with one.
void check_result(const Case& data, Findings& findings);
/// Stages, strength reduction and names of monitors.
void check_analysis(const Case& data, Findings& findings);
/// The pore water itself, that of the materials, and whether stages and start ask for what needs it.
void check_water(const Case& data, Findings& findings);
/// Hydraulic conditions and the pore pressure at the start.
void check_hydraulics(const Case& data, Findings& findings);
/// Names, units and tolerances of the values that results are held against. A result that this case leaves out is no
/// fault: the report says that it was not calculated.
void check_compare(const Case& data, Findings& findings);

/// Whether any material has pore water.
bool is_wet(const Case& data);
/// Reports boundaries, tractions and hydraulic conditions on sides that are not in `sides`.
void check_sides(const Case& data, const std::set<std::string>& sides, Findings& findings);
/// Reports regions without material, and materials and velocities for regions that do not exist.
void check_regions(const Case& data, const std::set<std::string>& regions, Findings& findings);

}  // namespace talus::model
