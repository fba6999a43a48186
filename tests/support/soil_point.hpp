// SPDX-License-Identifier: MIT
#pragma once
// One point of Mohr–Coulomb soil, updated as in the MPM step, and the same soil for the plain return mapping.

#include <array>

#include "material/mohr_coulomb.hpp"
#include "reference/plain_material.hpp"

namespace talus::support {

template <int NS>
using Voigt = std::array<double, NS>;  ///< xx yy zz xy (yz zx)

struct Soil {
  double young_modulus = 20e6, poisson_ratio = 0.3;                          ///< [Pa], [-]
  double cohesion = 0, friction = 0, dilatancy = 0, tensile_strength = 1e9;  ///< [Pa], [rad], [rad], [Pa]

  material::LinearElastic elastic() const { return material::LinearElastic::from_young(young_modulus, poisson_ratio); }
  material::MohrCoulomb law() const { return {elastic(), {cohesion, friction, dilatancy, tensile_strength}}; }
  reference::Material plain() const {
    return {.young_modulus = young_modulus,
            .poisson_ratio = poisson_ratio,
            .plastic = true,
            .cohesion = cohesion,
            .friction_angle = friction,
            .dilatancy_angle = dilatancy,
            .tensile_strength = tensile_strength};
  }
};

/// Result of one increment at a point.
template <int NS>
struct Outcome {
  Voigt<NS> stress{};
  double plastic_strain = 0, plastic_dilation = 0, dissipation = 0;
  bool yielded = false;
};

/// Increment `d` from `stress`, with one double.
template <int NS>
Outcome<NS> drive(const material::MohrCoulomb& law, const Voigt<NS>& stress, const Voigt<NS>& d) {
  Outcome<NS> o;
  o.stress = stress;
  const auto r = law.update<NS>(o.stress.data(), d.data(), &o.plastic_strain, true);
  o.yielded = r.any_plastic;
  o.plastic_dilation = r.plastic_dilation;
  o.dissipation = r.dissipation;
  return o;
}

template <int NS>
reference::Tensor to_tensor(const Voigt<NS>& v, bool strain = false) {
  const double half = strain ? 0.5 : 1;
  reference::Tensor t = reference::Tensor::Zero();
  for (int d = 0; d < 3; ++d) t(d, d) = v[static_cast<std::size_t>(d)];
  t(0, 1) = t(1, 0) = half * v[3];
  if constexpr (NS == 6) {
    t(1, 2) = t(2, 1) = half * v[4];
    t(2, 0) = t(0, 2) = half * v[5];
  }
  return t;
}

template <int NS>
Voigt<NS> to_voigt(const reference::Tensor& t, bool strain = false) {
  const double twice = strain ? 2 : 1;
  Voigt<NS> v{t(0, 0), t(1, 1), t(2, 2), twice * t(0, 1)};
  if constexpr (NS == 6) {
    v[4] = twice * t(1, 2);
    v[5] = twice * t(2, 0);
  }
  return v;
}

/// Inelastic part of the strain increment `d` [-].
template <int NS>
reference::Tensor find_plastic_strain(const Soil& soil, const Voigt<NS>& before, const Voigt<NS>& d,
                                      const Voigt<NS>& after) {
  const reference::Tensor change = to_tensor<NS>(after) - to_tensor<NS>(before);
  const double e = soil.young_modulus, nu = soil.poisson_ratio;
  return to_tensor<NS>(d, true) - ((1 + nu) / e * change - nu / e * change.trace() * reference::Tensor::Identity());
}

}  // namespace talus::support
