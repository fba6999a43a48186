// SPDX-License-Identifier: MIT
#pragma once
// A body as a frame of the results file.

#include <string>

#include "mpm/body/body.hpp"
#include "output/files/frame.hpp"

namespace talus::run {

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
