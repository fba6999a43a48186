// SPDX-License-Identifier: MIT
#pragma once
// [[surcharge]] and [earthquake]: loads of all methods.

#include <array>
#include <string>
#include <vector>

#include "input/language/spec.hpp"

namespace talus::input {

/// A vertical load on the ground.
struct Surcharge {
  std::string name;
  std::vector<double> x;     ///< from left to right [m]
  std::vector<double> load;  ///< at each x [Pa], linear between; down positive
  bool variable = false;     ///< a variable action in the sense of Eurocode 7, else permanent
};

/// Towards which x the horizontal part of an earthquake pushes the soil.
enum class EarthquakeDirection { both, left, right };

template <>
inline constexpr auto choices<EarthquakeDirection> = std::array{
    Choice{EarthquakeDirection::both, "both", "towards either side, and the weaker one governs"},
    Choice{EarthquakeDirection::left, "left", "towards smaller x; with a negative `horizontal` towards larger x"},
    Choice{EarthquakeDirection::right, "right", "towards larger x; with a negative `horizontal` towards smaller x"},
};

/// Pseudo-static acceleration over g.
struct Earthquake {
  double horizontal = 0;  ///< k_h [-]
  double vertical = 0;    ///< k_v, down positive [-]
  EarthquakeDirection direction = EarthquakeDirection::both;

  /// The directions that are tried, `left` and `right` or one of them.
  std::vector<EarthquakeDirection> list_directions() const {
    if (direction != EarthquakeDirection::both || horizontal == 0) return {direction};
    return {EarthquakeDirection::left, EarthquakeDirection::right};
  }
};

template <class Visitor>
void describe(Visitor& v, Surcharge& s) {
  v.key("name", s.name, plain().required().example(R"("road")"), "Name of the load.");
  v.key("x", s.x, quantity("m").required().example("[2, 8]"), "Where on the ground, from left to right.");
  v.key("load", s.load,
        quantity("kPa").required().usual_or_zero(0.5, 500, {{"Pa", 1e-3}, {"psf", 0.0478803}}).example("[20, 20]"),
        "Load per horizontal area at each x, downwards, linear between them; none outside.");
  v.key("variable", s.variable, plain(), "A variable action in the sense of Eurocode 7; false: a permanent one.");
}

template <class Visitor>
void describe(Visitor& v, Earthquake& e) {
  v.key("horizontal", e.horizontal, plain().usual_or_zero(0.01, 0.5, {{"%", 0.01}, {"m/s2", 0.10197}}).of_either_sign(),
        "k_h, horizontal acceleration over g.");
  v.key("vertical", e.vertical, plain().above(-1),
        "k_v, vertical acceleration over g; down (more weight) is positive.");
  v.key("direction", e.direction, plain(), "Towards which side the horizontal acceleration pushes the soil.");
}

}  // namespace talus::input
