// SPDX-License-Identifier: MIT
#include "input/case/boundary.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/units.hpp"
#include "input/case/case.hpp"
#include "input/case/checks.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, Surcharge& s) {
  v.key("name", s.name, plain().required().example(R"("road")"), "Name of the load.");
  v.key("x", s.x, quantity("m").required().example("[2, 8]"), "Where on the ground, from left to right.");
  v.key("load", s.load,
        quantity("kPa").required().usual_or_zero(0.5, 500, {{"Pa", 1e-3}, {"psf", 0.0478803}}).example("[20, 20]"),
        "Load per horizontal area at each x, downwards, linear between them; none outside.");
  v.key("variable", s.variable, plain(), "A variable action in the sense of Eurocode 7; false: a permanent one.");
}

void describe(Visitor& v, Slurry& s) {
  v.key("name", s.name, plain().required().example(R"("bentonite")"), "Name of the liquid.");
  v.key("x", s.x, quantity("m").required().example("[20, 20.8]"), "From where to where it may stand on the ground.");
  v.key("level", s.level, quantity("m").required().example("9.5"), "Level of its surface.");
  v.key("unit_weight", s.unit_weight,
        quantity("kN/m3")
            .above(0)
            .usual(9, 16, {{"kg/m3", 9.80665e-3}, {"t/m3", 9.80665}, {"pcf", 0.1570875}})
            .required()
            .example("10.5"),
        "Its weight.");
}

void describe(Visitor& v, Earthquake& e) {
  v.key("horizontal", e.horizontal, plain().usual_or_zero(0.01, 0.5, {{"%", 0.01}, {"m/s2", 0.10197}}).of_either_sign(),
        "k_h, horizontal acceleration over g.");
  v.key("vertical", e.vertical, plain().above(-1),
        "k_v, vertical acceleration over g; down (more weight) is positive.");
  v.key("direction", e.direction, plain(), "Towards which side the horizontal acceleration pushes the soil.");
}

void describe(Visitor& v, Boundary& b) {
  v.key("on", b.on, plain().required().example_each({R"("bottom")", R"("left")", R"("right")"}),
        "A side (left, right, bottom, top; in 3D also front, back), a named line, or a side group of the mesh file.");
  v.key("fix", b.fix, plain().required().example_each({R"("full")", R"("normal")", R"("normal")"}),
        "What the boundary does to the motion.");
  v.key("normal", b.normal, plain().needed_with("fix", b.fix, Fix::plane).example("[1, 1]"),
        "Direction of the suppressed motion, of any length but zero.");
  v.key("friction", b.friction, plain().at_least(0).needed_with("fix", b.fix, Fix::friction).example("0.5"),
        "Coulomb's coefficient of the wall.");
  v.key("velocity", b.velocity, quantity("m/s").needed_with("fix", b.fix, Fix::velocity).example("[0.1, 0]"),
        "Prescribed velocity.");
  v.key("factor", b.factor, quantity("s").allowed_with("fix", b.fix, Fix::velocity).example("[[0, 0], [1, 1]]"),
        "The velocity is multiplied by this factor: linear between the rows, constant before and after them.");
  v.key("smooth", b.smooth, plain().allowed_with("fix", b.fix, Fix::velocity),
        "The velocity is prescribed across the boundary only, and the soil is free to move along it.");
}

void describe(Visitor& v, Traction& t) {
  v.key("on", t.on, plain().required().example(R"("crest")"), "A side or a named line, as in [[boundary]].");
  v.key("carrier", t.carrier, plain(), "What carries the load.");
  v.key("traction", t.traction, quantity("kPa").required().example("[0, -20]"), "Load per area.");
  v.key("factor", t.factor, quantity("s").example("[[0, 0], [2, 1]]"),
        "The load is multiplied by this factor: linear between the rows, constant before and after them.");
}
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

namespace {

/// Reports unit weights from which no density of MPM follows.
void check_masses(const Case& data, Findings& findings) {
  if (!uses(data, Method::mpm) || data.gravity.acceleration != 0 || !findings.is_sound("gravity")) return;
  for (const auto& [name, material] : data.materials) {
    const std::string path = "materials." + name;
    if (material.slices.unit_weight && findings.is_sound(path) && !findings.places.is_given(path + ".grain_density"))
      findings.add(path + ".unit_weight",
                   "without gravity the unit weight of material '{}' gives no mass; give 'grain_density' and "
                   "'porosity' for MPM",
                   name);
  }
}

}  // namespace

void check_conditions(const Case& data, Findings& findings) {
  check_vector(data, data.gravity.direction, "gravity.direction", true, findings);
  check_masses(data, findings);
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
