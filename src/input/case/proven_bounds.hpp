// SPDX-License-Identifier: MIT
#pragma once
// [bounds]: the interval that holds the factor of safety, by limit analysis.

#include <array>
#include <optional>

#include "input/language/spec.hpp"

namespace talus::input {

/// Effective tension that the soil bears.
enum class BoundsTension { as_given, apex };

/// Plastic flow of the soil. The theorems hold for the first alone.
enum class BoundsFlow { associated, davis };

struct ProvenBounds {
  std::optional<double> size;  ///< of the first mesh's triangles [m]; not given: see find_bounds_size()
  double gap = 0.01;           ///< of the interval over its middle, at which the meshes end [-]
  int triangles = 6000;        ///< a mesh with as many is the last
  BoundsTension tension = BoundsTension::as_given;
  BoundsFlow flow = BoundsFlow::associated;
};

template <>
inline constexpr auto choices<BoundsTension> = std::array{
    Choice{BoundsTension::as_given, "as_given", "the tensile strength of the materials"},
    Choice{BoundsTension::apex, "apex", "up to the apex, c/tan φ, as methods of slices assume"},
};

template <>
inline constexpr auto choices<BoundsFlow> = std::array{
    Choice{BoundsFlow::associated, "associated", "ψ = φ: the interval is proven"},
    Choice{BoundsFlow::davis, "davis",
           "the strength times cos ψ cos φ/(1 − sin ψ sin φ), which Davis (1968) proposes for ψ < φ: an interval for "
           "that weaker soil, and no bound for the given one"},
};

template <class Visitor>
void describe(Visitor& v, ProvenBounds& b) {
  v.key("size", b.size, quantity("m").above(0).example("2.0"),
        "Size of the triangles of the first mesh, on which pore pressures and strengths are linear. If not given, a "
        "sixth of the section's height, and a twelfth with pore water.");
  v.key("gap", b.gap, plain().above(0).below(1),
        "The meshes become finer where the bounds lie apart, until the interval is no wider than this share of its "
        "middle.");
  v.key("triangles", b.triangles, plain().at_least(1).at_most(200000),
        "A mesh with as many triangles is the last one, whatever the interval.");
  v.key("tension", b.tension, plain(), "Largest effective tension of the soils.");
  v.key("flow", b.flow, plain(), "Plastic flow of the soils.");
}

struct Case;

/// Size of the first mesh's triangles: the case's; else a sixth of the section's height, and a twelfth with pore water,
/// whose pressure is linear in a triangle [m].
double find_bounds_size(const Case& data);

}  // namespace talus::input
