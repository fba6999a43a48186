// SPDX-License-Identifier: MIT
#pragma once
// A body as a frame of the results file.

#include <limits>
#include <string>
#include <vector>

#include "mpm/body/body.hpp"
#include "mpm/body/observe.hpp"
#include "output/files/frame.hpp"

namespace talus::run {

// The quantities that the laws of a body have beside stress, as fields over all its points.

/// Quantities of all laws, each once, and which values of which law they are.
class StateFields {
 public:
  explicit StateFields(const std::vector<material::Law>& laws);

  const std::vector<material::StateField>& list() const { return fields_; }
  /// Values of a point in the order of the list: NaN for what its soil does not have or what is not set yet, zero for
  /// roots in soil without any.
  template <int D>
  std::vector<double> read(const mpm::Body<D>& body, const mpm::PointView<D>& point) const {
    const auto law = static_cast<std::size_t>(point.material);
    return arrange(body.laws[law], law, point.state.data(), point.wet ? point.saturation : 1.0);
  }

 private:
  std::vector<double> arrange(const material::Law& law, std::size_t number, const double* state,
                              double saturation) const;
  std::vector<material::StateField> fields_;
  std::vector<std::vector<std::size_t>> places_;  ///< [law][its field] → place in the list
};

/// Invariants of a symmetric tensor given as xx yy zz xy (yz zx): mean p and deviatoric q = √(3/2 s:s).
struct Invariants {
  double mean = 0, deviatoric = 0;
};
/// Of a stress [Pa].
template <int N>
Invariants find_stress_invariants(const std::array<double, N>& stress);
/// Volumetric strain and deviatoric strain √(2/3 e:e) of a strain with engineering shear.
template <int N>
Invariants find_strain_invariants(const std::array<double, N>& strain);

/// All points that are on the grid, with displacement, velocity, stress, p, q, strains, plastic strain and volume;
/// with pore water also its pressure, positive in compression, saturation, porosity and the water's velocity; and
/// what the laws have beside stress (state_fields.hpp). Element and nodal fields on request.
template <int D>
output::Frame make_frame(const mpm::Body<D>& body, const std::string& stage, bool cells = false, bool nodes = false);

}  // namespace talus::run
