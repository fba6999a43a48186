// SPDX-License-Identifier: MIT
#pragma once
// Unknowns, equations and cones of bars and walls in the programs of both bounds (docs/theory/21-proven-bounds.md).

#include <tuple>
#include <utility>
#include <vector>

#include "bounds/check.hpp"
#include "bounds/conic/cones.hpp"
#include "bounds/problem.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

/// In the place of the number of an unknown: the lacking cohesion m.
inline constexpr int lacking = -1;

/// Σ coefficient × unknown + constant, with the derivatives of the coefficients and of the constant by the factor.
struct RowForm {
  std::vector<std::pair<int, double>> entries, rates;
  double constant = 0, constant_rate = 0;
};

/// The unknowns follow those of the soil, nine of each triangle; in the lower bound, first the tension of each bar over
/// its largest one.
struct SupportRows {
  int unknowns = 0;
  std::vector<RowForm> equations;           ///< each is zero
  std::vector<std::vector<RowForm>> cones;  ///< rows s₀ ≥ |(s₁, …)|
  /// Wall and edge of each cone of a section in the lower bound, by the index of the cone.
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> sections;
};

/// Returns the number of the unknown of a bar in the lower bound.
inline int find_bar_unknown(const Problem& problem, std::size_t bar) {
  return static_cast<int>(9 * problem.size() + bar);
}

/// Lower bound: the strength of bars; force and moment of the beams in equilibrium with the tractions of the soil, and
/// the strength of beams, struts and interfaces. Along an edge the moment is cubic; it lies between its four Bézier
/// points.
SupportRows make_static_rows(const Problem& problem, double factor, const Units& units);

/// Adds the gap that hinges leave in a solution of the lower bound to the contributions of the triangles beside them: a
/// fixed part of what their sections dissipate, as the Bézier points of an edge exceed the moment between them.
/// `soil`: first row of the criterion of the soil.
void add_hinges(const Problem& problem, const Units& units, const ConicSolution& solution, std::size_t soil,
                std::vector<double>& contributions);

/// Contributions of bars and walls to the equation of each degree of freedom in the upper bound: coefficients of
/// unknowns with their derivatives by the factor, and work of loads.
struct SupportWork {
  struct Use {
    int number, unknown;
    double value, rate;
  };
  std::vector<Use> uses;
  std::vector<double> work;  ///< by number
  SupportRows rows;
};

/// Upper bound: tension of bars, stresses at the contacts, and moments and forces of hinges.
SupportWork make_support_work(const Problem& problem, const Velocities& v, double factor, const Units& units);

/// Reads the tension of bars and the compression of struts from a solution of the lower bound. `unknowns`: those that
/// follow the soil.
void read_supports(const Problem& problem, const double* unknowns, const Units& units, StressField& field);

}  // namespace talus::bounds
