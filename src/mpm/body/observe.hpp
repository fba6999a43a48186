// SPDX-License-Identifier: MIT
#pragma once
// Reading a body: single points and sums.

#include "mpm/step/critical_step.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {

/// One point as the outside world sees it.
template <int D>
struct PointView {
  int element = -1, material = 0;
  Vec<D> position{}, velocity{}, displacement{};          ///< [m], [m/s]; displacement from the reference [m]
  std::array<double, material::stress_size<D>> stress{};  ///< [Pa]
  std::array<double, material::stress_size<D>> strain{};  ///< summed increments, engineering shear [-]
  double mass = 0, volume = 0;                            ///< of the grains [kg], [m³]
  double plastic_strain = 0;                              ///< deviatoric, 0 for elastic models [-]
  std::array<double, material::max_state_size> state{};   ///< of its law
  bool wet = false;                                       ///< has pore water
  Vec<D> water_velocity{};                                ///< [m/s]
  double pressure = 0, water_mass = 0;                    ///< tension positive [Pa], [kg]
  double saturation = 0, porosity = 0;                    ///< [-]
};

/// False when the point has left the grid.
template <int D>
bool is_present(const Body<D>& body, int id) {
  return body.points.element[id] >= 0;
}

/// View of a point that is present. With frozen geometry the displacement is that of the nodes.
template <int D>
PointView<D> view_point(const Body<D>& body, int id);

/// Displacements are counted from where the points are now.
template <int D>
void reset_displacements(Body<D>& body);

/// Largest displacement of a point since the last reset, and which point [m].
struct LargestDisplacement {
  double value = 0;
  int id = -1;
};
template <int D>
LargestDisplacement find_largest_displacement(const Body<D>& body);

/// Energies [J] and momentum of the points.
template <int D>
struct Totals {
  double mass = 0, water = 0;                      ///< of grains and of pore water [kg]
  double kinetic = 0, potential = 0, elastic = 0;  ///< of both; potential: -Σ m g·x
  Vec<D> momentum{}, centre{};                     ///< [kg m/s], centre of mass [m]
  int points = 0;
};
template <int D>
Totals<D> sum_points(const Body<D>& body, const std::type_identity_t<Vec<D>>& gravity);

}  // namespace talus::mpm
