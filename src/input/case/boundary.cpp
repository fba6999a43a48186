// SPDX-License-Identifier: MIT
#include "input/case/boundary.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "input/case/checks.hpp"

namespace talus::input {
namespace {

bool is_zero(const std::array<double, 3>& v) {
  return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/// Checks that a vector of a plane case lies in the plane, and that a direction is not zero.
void check_vector(const Case& data, const std::array<double, 3>& v, const std::string& path, bool is_direction,
                  Findings& findings) {
  if (!findings.is_sound(path)) return;
  const std::string key = path.substr(path.rfind('.') + 1);
  if (is_direction && is_zero(v)) findings.add(path, "'{}' is zero; it must have a length to be a direction", key);
  if (data.mesh.dimension == 2 && v[2] != 0 && findings.is_sound("geometry.dimension"))
    findings.add(path, "the third component of '{}' must be 0 in 2D", key);
}

void check_side(const std::string& on, const std::string& path, const std::set<std::string>& sides,
                Findings& findings) {
  if (sides.count(on) != 0 || !findings.is_sound(path)) return;
  const std::string near = find_nearest(on, {sides.begin(), sides.end()});
  findings.add(path, "there is no side or line '{}'; {}known: {}", on,
               near.empty() ? "" : fmt::format("did you mean '{}'? ", near), fmt::join(sides, ", "));
}

void check_unit(const std::string& unit, const char* key, const char* wanted, Findings& findings) {
  const std::string path = std::string("output.") + key;
  if (!findings.is_sound(path)) return;
  try {
    units::parse_as_si("1 " + unit, wanted, key);
  } catch (const Error&) {
    findings.add(path, "'{}' is '{}'; it must be a unit of {}, such as \"{}\"", key, unit,
                 units::get_dimension_name(wanted).substr(2), wanted);
  }
}

}  // namespace

void check_sides(const Case& data, const std::set<std::string>& sides, Findings& findings) {
  for (std::size_t i = 0; i < data.boundaries.size(); ++i)
    check_side(data.boundaries[i].on, fmt::format("boundary.{}.on", i), sides, findings);
  for (std::size_t i = 0; i < data.tractions.size(); ++i)
    check_side(data.tractions[i].on, fmt::format("traction.{}.on", i), sides, findings);
  for (std::size_t i = 0; i < data.hydraulics.size(); ++i)
    check_side(data.hydraulics[i].on, fmt::format("hydraulic.{}.on", i), sides, findings);
  for (std::size_t i = 0; i < data.roots.size(); ++i)
    check_side(data.roots[i].ground, fmt::format("roots.{}.ground", i), sides, findings);
}

void check_conditions(const Case& data, Findings& findings) {
  check_vector(data, data.gravity.direction, "gravity.direction", true, findings);
  for (std::size_t i = 0; i < data.boundaries.size(); ++i) {
    const std::string path = fmt::format("boundary.{}.", i);
    if (!findings.is_sound(path + "fix")) continue;
    if (data.boundaries[i].fix == Fix::plane)
      check_vector(data, data.boundaries[i].normal, path + "normal", true, findings);
    check_vector(data, data.boundaries[i].velocity, path + "velocity", false, findings);
  }
  for (std::size_t i = 0; i < data.tractions.size(); ++i)
    check_vector(data, data.tractions[i].traction, fmt::format("traction.{}.traction", i), false, findings);
  for (const auto& [region, velocity] : data.initial.velocity)
    check_vector(data, velocity, "initial.velocity." + region, false, findings);
  check_unit(data.output.length_unit, "length_unit", "m", findings);
  check_unit(data.output.displacement_unit, "displacement_unit", "m", findings);
  check_unit(data.output.stress_unit, "stress_unit", "kPa", findings);
  // Sides of an external mesh are known only after it is read: check_against_mesh().
  if (!data.mesh.file.empty() || !findings.is_sound("geometry.line") || !findings.is_sound("geometry.dimension"))
    return;
  std::set<std::string> sides{"left", "right", "bottom", "top"};
  if (data.mesh.dimension == 3) sides.insert({"front", "back"});
  for (const mesh::Line& line : data.mesh.lines) sides.insert(line.name);
  check_sides(data, sides, findings);
}

}  // namespace talus::input
