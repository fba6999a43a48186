// SPDX-License-Identifier: MIT
#pragma once
// [fem] and [bounds]: the factor of safety by quadratic finite elements and its bounds by limit analysis.

#include <array>
#include <optional>

#include "input/case/geometry.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

/// Flow rule of the trials.
enum class FlowRule { as_given, associated, both };

/// Associated flow with the strength of Davis (1968) in place of ψ < φ, by the angles that give its share.
enum class DavisRule { none, a, b, c };

/// Treatment of soil that softens.
enum class FemSoftening { none, progressive };

struct FiniteElements {
  std::optional<double> size;  ///< element size [m]; not given: that of [mesh]
  mesh::Algorithm algorithm = mesh::Algorithm::delaunay;
  int meshes = 2;                      ///< 2: also a mesh of twice the size, with linear extrapolation
  bool adapt = false;                  ///< refine the mesh where the soil shears, in place of `meshes`
  FlowRule flow = FlowRule::as_given;  ///< both: ψ as given, and ψ = φ
  DavisRule davis = DavisRule::none;   ///< of the trials with ψ as given
  FemSoftening softening = FemSoftening::none;
  double from = 1.0, to = 2.0;           ///< initial bracket [-]
  double resolution = 0.005;             ///< width of the final bracket [-]
  double force_tolerance = 1e-4;         ///< relative [-]
  double displacement_tolerance = 1e-4;  ///< relative [-]
  int iterations = 400;                  ///< limit of linear solutions per load step or trial
  int load_steps = 4;
};

template <>
inline constexpr auto choices<FlowRule> = std::array{
    Choice{FlowRule::as_given, "as_given", "the dilatancy of the materials"},
    Choice{FlowRule::associated, "associated", "ψ = φ, as limit analysis and LEM assume"},
    Choice{FlowRule::both, "both", "one after the other"},
};

template <>
inline constexpr auto choices<DavisRule> = std::array{
    Choice{DavisRule::none, "none", "the flow rule as given"},
    Choice{DavisRule::a, "a", "φ and ψ as given"},
    Choice{DavisRule::b, "b", "φ and ψ reduced, tan φ/F and tan ψ/F"},
    Choice{DavisRule::c, "c", "φ reduced and ψ as given; no change where ψ exceeds the reduced φ"},
};

template <>
inline constexpr auto choices<FemSoftening> = std::array{
    Choice{FemSoftening::none, "none", "the peak or the residual strength everywhere, by `limit_strength`"},
    Choice{FemSoftening::progressive, "progressive",
           "the strength falls with plastic shear strain, averaged over mesh.softening_length"},
};

void describe(Visitor& v, FiniteElements& f);

// [bounds]: lower and upper bound of the factor of safety by limit analysis.

/// Tensile strength in effective stresses.
enum class BoundsTension { as_given, apex };

/// Flow rule of the soil. The bound theorems hold for `associated` only.
enum class BoundsFlow { associated, davis };

struct ProvenBounds {
  std::optional<double> size;  ///< triangle size of the first mesh [m]; not given: see find_bounds_size()
  double gap = 0.01;           ///< relative width of the interval at which refinement ends [-]
  int triangles = 6000;        ///< number of triangles at which refinement ends
  BoundsTension tension = BoundsTension::as_given;
  BoundsFlow flow = BoundsFlow::associated;
};

template <>
inline constexpr auto choices<BoundsTension> = std::array{
    Choice{BoundsTension::as_given, "as_given", "the tensile strength of the materials"},
    Choice{BoundsTension::apex, "apex", "up to the apex, c/tan φ, as LEM assumes"},
};

template <>
inline constexpr auto choices<BoundsFlow> = std::array{
    Choice{BoundsFlow::associated, "associated", "ψ = φ, for which the bound theorems hold"},
    Choice{BoundsFlow::davis, "davis",
           "the strength times cos ψ cos φ/(1 − sin ψ sin φ), which Davis (1968) proposes for ψ < φ: an interval for "
           "that weaker soil, and no bound for the given one"},
};

void describe(Visitor& v, ProvenBounds& b);

struct Case;

/// Returns the triangle size of the first mesh [m]: that of the case, otherwise a sixth of the section's height, or a
/// twelfth with pore water, since pore pressure is linear in a triangle.
double find_bounds_size(const Case& data);

}  // namespace talus::input
