// SPDX-License-Identifier: MIT
#pragma once
// Element tests on one point of Cam-clay, with given strains or with given strains and stresses.

#include <array>
#include <cmath>
#include <functional>

#include "material/cam_clay.hpp"

namespace talus::support {

inline constexpr double kpa = 1e3;

/// Stress and state of a point, stress positive in tension as the program has it.
template <int NS, bool Rooted>
struct ClayPoint {
  using Law = material::CamClay<Rooted>;
  std::array<double, NS> stress{};
  std::array<double, Law::state_size> state{};
  double saturation = 1;
  double plastic_dilation = 0, dissipation = 0;  ///< of the last step

  double p() const { return -(stress[0] + stress[1] + stress[2]) / 3; }
  double q() const {
    double s = 0;
    for (std::size_t i = 0; i < NS; ++i) s += i < 3 ? (stress[i] + p()) * (stress[i] + p()) : 2 * stress[i] * stress[i];
    return std::sqrt(1.5 * s);
  }
  void step(const Law& law, const std::array<double, NS>& d_epsilon) {
    const auto r = law.template update<NS>(stress.data(), d_epsilon.data(), state.data(), true,
                                           material::Surroundings<double>{saturation});
    plastic_dilation = r.plastic_dilation;
    dissipation = r.dissipation;
  }
};

/// At the isotropic stress p' [Pa] with p'_c of bare saturated soil `preconsolidation` [Pa], or what p' needs.
template <int NS, bool Rooted>
ClayPoint<NS, Rooted> start_isotropic(const material::CamClay<Rooted>& law, double p, double e, double preconsolidation,
                                      double content = 0, double saturation = 1) {
  ClayPoint<NS, Rooted> point;
  for (std::size_t i = 0; i < 3; ++i) point.stress[i] = -p;
  point.saturation = saturation;
  law.set_initial_state(point.stress.data(), e, content, preconsolidation, saturation, point.state.data());
  return point;
}

/// A step with axial strain `axial` [-] along y, compression positive, and the radial strain that leaves the radial
/// stress at `radial_stress` [Pa], compression positive. Returns the volumetric strain of the step.
template <bool Rooted>
double step_triaxial(const material::CamClay<Rooted>& law, ClayPoint<6, Rooted>& point, double axial,
                     double radial_stress) {
  const auto try_radial = [&](double radial) {
    auto next = point;
    next.step(law, {-radial, -axial, -radial, 0, 0, 0});
    return next;
  };
  double a = 0, b = -0.3 * axial;
  double at_a = -try_radial(a).stress[0] - radial_stress, at_b = -try_radial(b).stress[0] - radial_stress;
  for (int i = 0; i < 50 && std::abs(at_b) > 1e-9 * radial_stress && at_a != at_b; ++i) {
    const double c = b - at_b * (b - a) / (at_b - at_a);
    a = b;
    at_a = at_b;
    b = c;
    at_b = -try_radial(b).stress[0] - radial_stress;
  }
  point = try_radial(b);
  return axial + 2 * b;
}

}  // namespace talus::support
