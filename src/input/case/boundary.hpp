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

void describe(Visitor& v, Surcharge& s);

void describe(Visitor& v, Slurry& s);

void describe(Visitor& v, Earthquake& e);

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

void describe(Visitor& v, Boundary& b);

void describe(Visitor& v, Traction& t);

}  // namespace talus::input
