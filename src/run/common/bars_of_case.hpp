// SPDX-License-Identifier: MIT
#pragma once
// The supports of a case as bars and beams of FEM, and their forces as results.

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "fem/solid/solid.hpp"
#include "results/elements.hpp"
#include "site/site.hpp"

namespace talus::run {

/// Shear stiffness κ G A of piles and walls over E A, of a rectangle with ν = 0.2.
inline constexpr double shear_share = 5.0 / 6 / 2.4;
/// Forces are rounded to this many parts of one newton per metre.
inline constexpr double force_digits = 10;

/// Makes the bars of a plane case, without its walls, with the bond of LEM along them. Throws what site::list_bars()
/// and, where the bond depends on σ'_v, make_section() throw.
std::vector<fem::Bar> make_bars(const site::Site& site);

/// Returns the sentence on what the factor divides.
std::string describe_bars(const input::Case& data);

/// Returns the forces of bars and walls at failure and at full strength.
std::vector<results::ElementBar> make_bar_results(const site::Site& site, const fem::SolidModel<2>& model,
                                                  const fem::ReductionResult<2>& found);

/// Returns the forces of one bar, and the limit that it has reached. `start`: at full strength.
results::ElementBar make_bar_result(const fem::BarForces& failed, const fem::BarForces& start);

/// A limit of a bar, with its utilisation; nullopt where the bar does not have it.
template <class Limit>
struct UsedLimit {
  std::optional<double> used;
  Limit limit;
};

/// Returns the limit with the largest utilisation among those that are reached, of equal ones the last; `none` if no
/// limit is.
template <class Limit>
Limit select_limit(std::initializer_list<UsedLimit<Limit>> limits, Limit none) {
  constexpr double reached = 0.98;
  double most = reached;
  Limit found = none;
  for (const UsedLimit<Limit>& u : limits)
    if (u.used && *u.used >= most) most = *u.used, found = u.limit;
  return found;
}

}  // namespace talus::run
