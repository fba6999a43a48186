#pragma once
// Reading a body: single points, sums, and the time step that it allows.

#include "mpm/step.hpp"

namespace talus::mpm {

/// One point as the outside world sees it.
template <int D>
struct PointView {
  int element = -1, material = 0;
  Vec<D> position{}, velocity{}, displacement{};          ///< [m], [m/s]; displacement from the reference [m]
  std::array<double, material::stress_size<D>> stress{};  ///< [Pa]
  std::array<double, material::stress_size<D>> strain{};  ///< summed increments, engineering shear [-]
  double mass = 0, volume = 0;                            ///< [kg], [m³]
  double plastic_strain = 0;                              ///< deviatoric, 0 for elastic models [-]
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
  double mass = 0, kinetic = 0, potential = 0, elastic = 0;  ///< potential: -Σ m g·x
  Vec<D> momentum{}, centre{};                               ///< [kg m/s], centre of mass [m]
  int points = 0;
};
template <int D>
Totals<D> sum_points(const Body<D>& body, const std::type_identity_t<Vec<D>>& gravity);

/// Largest stable step (2.84) [s] for Courant number 1 and mass scaling β: the smallest over the elements that hold
/// points and their neighbours of altitude / √(E_c/(βρ)), with the density of the points of the element.
struct CriticalStep {
  double dt = 0;
  int element = -1;
};
template <int D>
CriticalStep find_critical_step(const Body<D>& body, double mass_scaling);

}  // namespace talus::mpm
