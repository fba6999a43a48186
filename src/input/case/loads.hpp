// SPDX-License-Identifier: MIT
#pragma once
// [[surcharge]] and [earthquake]: loads of all methods.

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

/// Pseudo-static acceleration over g.
struct Earthquake {
  double horizontal = 0;  ///< k_h out of the slope [-]
  double vertical = 0;    ///< k_v, down positive [-]
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
  v.key("horizontal", e.horizontal, plain().at_least(0).usual_or_zero(0.01, 0.5, {{"%", 0.01}, {"m/s2", 0.10197}}),
        "k_h, horizontal acceleration over g, out of the slope.");
  v.key("vertical", e.vertical, plain().above(-1),
        "k_v, vertical acceleration over g; down (more weight) is positive.");
}

}  // namespace talus::input
