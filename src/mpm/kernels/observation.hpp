// SPDX-License-Identifier: MIT
#pragma once
// Quantities that are read from a body between steps: single points, and sums and extremes over the points.

#include <limits>

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// All quantities of one point, in global coordinates.
template <int D>
struct PointView {
  int element = -1, material = 0;
  Vec<D> position{}, velocity{}, displacement{};          ///< [m], [m/s]; displacement from the reference [m]
  std::array<double, material::stress_size<D>> stress{};  ///< [Pa]
  std::array<double, material::stress_size<D>> strain{};  ///< sum of increments, engineering shear [-]
  double mass = 0, volume = 0;                            ///< of the grains [kg], [m³]
  double plastic_strain = 0;                              ///< deviatoric, 0 for elastic models [-]
  std::array<double, material::max_state_size> state{};   ///< state variables of its law
  bool wet = false;                                       ///< has pore water
  Vec<D> water_velocity{};                                ///< [m/s]
  double pressure = 0, water_mass = 0;                    ///< tension positive [Pa], [kg]
  double saturation = 0, porosity = 0;                    ///< [-]
};

/// Largest displacement [m] of a point since the last reset, and its point.
struct LargestDisplacement {
  double value = 0;
  int id = -1;
};

/// Energies [J] and momentum of the points.
template <int D>
struct Totals {
  double mass = 0, water = 0;                      ///< of grains and of pore water [kg]
  double kinetic = 0, potential = 0, elastic = 0;  ///< energies of both phases; potential: -Σ m g·x
  Vec<D> momentum{}, centre{};                     ///< [kg m/s], centre of mass [m]
  int points = 0;

  /// Adds the totals of more points. `centre` is a sum weighted with mass until it is divided.
  TALUS_PORTABLE void add(const Totals& more) {
    mass += more.mass;
    water += more.water;
    kinetic += more.kinetic;
    potential += more.potential;
    elastic += more.elastic;
    for (int d = 0; d < D; ++d) {
      momentum[d] += more.momentum[d];
      centre[d] += more.centre[d];
    }
    points += more.points;
  }
  void find_centre() {
    if (!(mass > 0)) return;
    for (double& c : centre) c /= mass;
  }
};

/// Pore water, and the extremes of its pressure over the points.
template <int D>
struct WaterState {
  double mass = 0;                                                     ///< [kg]
  double largest_pressure = -std::numeric_limits<double>::infinity();  ///< positive in compression [Pa]
  double largest_suction = 0;                                          ///< [Pa]; 0 when there is none
  Vec<D> place{};                                                      ///< of the largest suction [m]

  TALUS_PORTABLE void add_point(const PointView<D>& p) {
    if (p.wet) add({p.water_mass, -p.pressure, p.pressure, p.position});
  }
  TALUS_PORTABLE void add(const WaterState& more) {
    mass += more.mass;
    if (more.largest_pressure > largest_pressure) largest_pressure = more.largest_pressure;
    if (!(more.largest_suction > largest_suction)) return;
    largest_suction = more.largest_suction;
    place = more.place;
  }
};

/// Values of a body for histories.
template <int D>
struct Observation {
  Totals<D> totals;
  WaterState<D> water;               ///< of a body with water
  double largest_displacement = 0;   ///< [m]
  std::vector<PointView<D>> points;  ///< the points requested; element is -1 where they have left the grid
};

/// Constrained modulus E_c [Pa] of the point whose fields start at `p`, with the law of its material.
template <int D>
double find_modulus(const material::Law& law, const double* p) {
  using P = Points<D>;
  double sigma[P::stress_size], state[material::max_state_size];
  for (int i = 0; i < P::stress_size; ++i) sigma[i] = p[(P::stress + i) * lane_width];
  for (int i = 0; i < material::state_size(law); ++i) state[i] = p[(P::state + i) * lane_width];
  return material::constrained_modulus(law, sigma, state);
}

}  // namespace talus::mpm
