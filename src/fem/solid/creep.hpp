// SPDX-License-Identifier: MIT
#pragma once
// Rules of creep to rest with the elastic stiffness as viscosity, for soil with and without flow of water
// (docs/theory/19-finite-elements.md). Viscosities are over the elastic stiffness [-].

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace talus::fem::creep {

inline constexpr double first_viscosity = 0.05, least_viscosity = 1e-6, most_viscosity = 1;
inline constexpr double good_share = 0.4;    ///< fraction of the out-of-balance force at which a step has converged
inline constexpr int most_solves = 7;        ///< linear systems in a step
inline constexpr double hopeless = 100;      ///< growth of the out-of-balance force at which a step is abandoned
inline constexpr double least_gain = 0.9;    ///< largest ratio of residuals from the third linear system on
inline constexpr double steady_share = 0.8;  ///< fraction of the residual left when the motion has doubled (T19.8)
inline constexpr double steady_from = 3;     ///< smallest motion of steady flow, over the elastic one (T19.8)

/// Returns true if a step that has not converged is given up. `last`: out-of-balance force before the last of `solves`
/// linear systems, `lack` after it, `fault` at the start of the step.
inline bool is_hopeless(double lack, double last, double fault, int solves) {
  return !(lack < hopeless * fault) || (solves >= 3 && lack > least_gain * last);
}

/// Returns the viscosity after a step that has taken so many linear systems.
inline double relax(double viscosity, int solves) {
  const double share = solves <= 1 ? 0.1 : solves == 2 ? 0.25 : solves == 3 ? 0.5 : 1.0;
  return std::max(viscosity * share, least_viscosity);
}

/// Returns the viscosity after a step that did not converge; `went`: an earlier one did.
inline double stiffen(double viscosity, bool went) {
  return std::min(went ? 4 * viscosity : std::max(4 * viscosity, first_viscosity), most_viscosity);
}

/// The way of a creep.
class Way {
 public:
  /// Returns true if the soil flows after a step: the motion has doubled while the out-of-balance force, at least
  /// `least`, has kept its size (T19.8). `elastic`: motion of elastic soil under all loads.
  bool is_steady(double moved, double fault, double elastic, double least) {
    places_.push_back({moved, fault});
    if (moved < steady_from * elastic || fault < least) return false;
    for (std::size_t k = places_.size(); k-- > 0;)
      if (places_[k][0] < 0.5 * moved) return fault > steady_share * places_[k][1];
    return false;
  }
  void clear() { places_.clear(); }

 private:
  std::vector<std::array<double, 2>> places_;  ///< motion and out-of-balance force
};

inline double find_norm(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

}  // namespace talus::fem::creep
