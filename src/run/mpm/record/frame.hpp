// SPDX-License-Identifier: MIT
#pragma once
// A body as a frame of the results file: its fields, invariants of stress and strain, and the state variables of its
// laws.

#include <limits>
#include <string>
#include <vector>

#include "mpm/solver/observe.hpp"
#include "mpm/state/body.hpp"
#include "output/files/frame.hpp"

namespace talus::run {

/// State variables of the laws of a body as fields over all its points. A field that several laws share is listed
/// once.
class StateFields {
 public:
  explicit StateFields(const std::vector<material::Law>& laws);

  const std::vector<material::StateField>& list() const { return fields_; }
  /// Returns the values of a point in the order of list(): NaN if its law does not have the quantity or it is not set
  /// yet, zero for roots in soil without roots.
  template <int D>
  std::vector<double> read(const mpm::Body<D>& body, const mpm::PointView<D>& point) const {
    const auto law = static_cast<std::size_t>(point.material);
    return arrange(body.laws[law], law, point.state.data(), point.wet ? point.saturation : 1.0);
  }

 private:
  std::vector<double> arrange(const material::Law& law, std::size_t number, const double* state,
                              double saturation) const;
  std::vector<material::StateField> fields_;
  std::vector<std::vector<std::size_t>> places_;  ///< [law][field of the law] → index in the list
};

struct Invariants {
  double mean = 0, deviatoric = 0;
};
/// Invariants of a stress [Pa].
template <int N>
Invariants find_stress_invariants(const std::array<double, N>& stress);
/// Volumetric strain and deviatoric strain √(2/3 e:e) of a strain with engineering shear.
template <int N>
Invariants find_strain_invariants(const std::array<double, N>& strain);

/// Makes a frame of all points on the grid with displacement, velocity, stress, p, q, strains, plastic strain and
/// volume; with pore water also pressure (positive in compression), saturation, porosity and water velocity; and the
/// state variables of the laws (StateFields). Element and nodal fields are optional.
template <int D>
output::Frame make_frame(const mpm::Body<D>& body, const std::string& stage, bool cells = false, bool nodes = false);

}  // namespace talus::run
