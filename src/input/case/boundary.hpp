// SPDX-License-Identifier: MIT
#pragma once
// [[boundary]] and [[traction]], conditions on named sides and lines, and the loads [[surcharge]] and [earthquake].

#include <array>
#include <string>
#include <vector>

#include "input/language/spec.hpp"
#include "input/language/time_table.hpp"

namespace talus::input {

// [[surcharge]] and [earthquake]: loads for all methods.

/// A vertical load on the ground.
struct Surcharge {
  std::string name;
  std::vector<double> x;     ///< from left to right [m]
  std::vector<double> load;  ///< at each x [Pa], linear between; positive downwards
  bool variable = false;     ///< variable action (Eurocode 7); otherwise permanent
};

/// A liquid on the ground that does not enter the soil.
struct Slurry {
  std::string name;
  std::array<double, 2> x{};  ///< from, to [m]
  double level = 0;           ///< of its surface [m]
  double unit_weight = 0;     ///< [N/m³]
};

/// Direction of the horizontal inertia force along x.
enum class EarthquakeDirection { both, left, right };

template <>
inline constexpr auto choices<EarthquakeDirection> = std::array{
    Choice{EarthquakeDirection::both, "both", "towards either side, and the weaker one governs"},
    Choice{EarthquakeDirection::left, "left", "towards smaller x; with a negative `horizontal` towards larger x"},
    Choice{EarthquakeDirection::right, "right", "towards larger x; with a negative `horizontal` towards smaller x"},
};

/// Pseudo-static coefficients, accelerations over g.
struct Earthquake {
  double horizontal = 0;  ///< k_h [-]
  double vertical = 0;    ///< k_v, positive downwards [-]
  EarthquakeDirection direction = EarthquakeDirection::both;

  /// Returns the directions to be analysed.
  std::vector<EarthquakeDirection> list_directions() const {
    if (direction != EarthquakeDirection::both || horizontal == 0) return {direction};
    return {EarthquakeDirection::left, EarthquakeDirection::right};
  }
};

void describe(auto& v, Surcharge& s) {
  v.key("name", s.name, plain().required().example(R"("road")"), "Name of the load.");
  v.key("x", s.x, quantity("m").required().example("[2, 8]"), "Where on the ground, from left to right.");
  v.key("load", s.load,
        quantity("kPa").required().usual_or_zero(0.5, 500, {{"Pa", 1e-3}, {"psf", 0.0478803}}).example("[20, 20]"),
        "Load per horizontal area at each x, downwards, linear between them; none outside.");
  v.key("variable", s.variable, plain(), "A variable action in the sense of Eurocode 7; false: a permanent one.");
}

void describe(auto& v, Slurry& s) {
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

void describe(auto& v, Earthquake& e) {
  v.key("horizontal", e.horizontal, plain().usual_or_zero(0.01, 0.5, {{"%", 0.01}, {"m/s2", 0.10197}}).of_either_sign(),
        "k_h, horizontal acceleration over g.");
  v.key("vertical", e.vertical, plain().above(-1),
        "k_v, vertical acceleration over g; down (more weight) is positive.");
  v.key("direction", e.direction, plain(), "Towards which side the horizontal acceleration pushes the soil.");
}

enum class Fix { full, normal, plane, friction, velocity };

struct Boundary {
  std::string on;  ///< named side or line
  Fix fix = Fix::full;
  std::array<double, 3> normal{};    ///< plane: direction of suppressed motion (unit vector after reading)
  double friction = 0;               ///< friction: Coulomb's μ [-] of a wall that allows separation but no penetration
  std::array<double, 3> velocity{};  ///< velocity: prescribed [m/s], times `factor`
  TimeTable factor{};
  bool smooth = false;  ///< velocity: prescribe only the component normal to the boundary
};

enum class Carrier { sides, points };

struct Traction {
  std::string on;                     ///< named side or line
  Carrier carrier = Carrier::points;  ///< mesh sides (fixed in space) or the adjacent material points (2.31-2.32)
  std::array<double, 3> traction{};   ///< [Pa], times `factor`
  TimeTable factor{};
};

template <>
inline constexpr auto choices<Fix> = std::array{
    Choice{Fix::full, "full", "no motion"},
    Choice{Fix::normal, "normal", "no motion across the side, free motion along it"},
    Choice{Fix::plane, "plane", "no motion along the given normal"},
    Choice{Fix::friction, "friction", "a rough wall that the soil may leave but not cross"},
    Choice{Fix::velocity, "velocity", "the given velocity"},
};

template <>
inline constexpr auto choices<Carrier> = std::array{
    Choice{Carrier::points, "points", "the material points beside the side carry the load along with them"},
    Choice{Carrier::sides, "sides", "the load stays on the sides of the mesh, fixed in space"},
};

void describe(auto& v, Boundary& b) {
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

void describe(auto& v, Traction& t) {
  v.key("on", t.on, plain().required().example(R"("crest")"), "A side or a named line, as in [[boundary]].");
  v.key("carrier", t.carrier, plain(), "What carries the load.");
  v.key("traction", t.traction, quantity("kPa").required().example("[0, -20]"), "Load per area.");
  v.key("factor", t.factor, quantity("s").example("[[0, 0], [2, 1]]"),
        "The load is multiplied by this factor: linear between the rows, constant before and after them.");
}

}  // namespace talus::input
