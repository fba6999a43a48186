// SPDX-License-Identifier: MIT
#pragma once
// Plain constitutive law of one point: linear elasticity and Mohr–Coulomb with a tension cut-off, whose return tries
// every set of yield planes. It is slow, and independent of the closed-form return that is tested against it.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace talus::reference {

using Vector3 = Eigen::Vector3d;
using Tensor = Eigen::Matrix3d;  ///< a symmetric tensor, all nine components stored

/// Stress is positive in tension, angles are in radians.
struct Material {
  double young_modulus = 0;     ///< E [Pa]
  double poisson_ratio = 0;     ///< ν [-]
  bool plastic = false;         ///< false: linear elastic, nothing below is used
  double cohesion = 0;          ///< c [Pa]
  double friction_angle = 0;    ///< φ [rad]
  double dilatancy_angle = 0;   ///< ψ [rad]
  double tensile_strength = 0;  ///< σ_t [Pa]; without effect from c/tanφ (the apex of the cone) upwards
};

struct StressUpdate {
  Tensor sigma;                     ///< [Pa]
  double plastic_strain = 0;        ///< sqrt(2/3 e^p:e^p) of the deviatoric plastic strain of this increment [-]
  Tensor plastic = Tensor::Zero();  ///< Δε^p = C⁻¹:(σ_trial − σ) [-]
  double opened = 0;                ///< growth of the gap in separating soil, negative where it closed [-]
};

/// A linear yield function of the ordered principal stresses: f = normal·σ − strength, flow along `flow`.
struct Plane {
  Vector3 normal, flow;
  double strength;  ///< [Pa]
};

/// The planes that can be active while σ1 ≥ σ2 ≥ σ3: Mohr–Coulomb f = (σa−σb) + (σa+σb) sinφ − 2c cosφ for the pairs
/// (1,3), (1,2), (2,3), whose flow has ψ for φ; and Rankine f = σa − σ_t with associated flow. The Rankine planes are
/// left out where the cone's apex lies below them.
std::vector<Plane> list_planes(const Material& m);

/// Relation of principal stresses to principal elastic strains [Pa].
Tensor principal_stiffness(const Material& m);

/// Every stress that some set of `count` active planes returns the ordered principal `trial` [Pa] to:
/// σ = σ_trial − Σ λ_j D m_j with f = 0 on the set, λ_j ≥ 0, no plane violated and σ1 ≥ σ2 ≥ σ3 kept.
std::vector<Vector3> find_returns(const Material& m, const Vector3& trial, int count);

/// Principal stresses after the return, of the ordered (σ1 ≥ σ2 ≥ σ3) trial ones [Pa]. The smallest number of active
/// planes is preferred: it is the regular return, and the sets that it leaves out hold only where they agree with it.
/// Where no set returns the point (ψ = 0 cannot reduce the mean stress beyond the apex) it goes to the apex c/tanφ.
Vector3 return_principal(const Material& m, const Vector3& trial);

/// Elastic increment and, for a plastic material, the return to the yield surface. Plane strain passes the same
/// three-dimensional tensors with ε_zz = 0.
StressUpdate update_stress(const Material& m, const Tensor& sigma, const Tensor& strain_increment);

/// The same for soil with a gap, with `dimensions` in-plane directions. Compression first removes tension, elastically,
/// then closes the gap, and only then causes stress. The gap opens by the plastic strain where the soil bears no more
/// tension in any of these directions.
StressUpdate update_separating(const Material& m, const Tensor& sigma, const Tensor& strain_increment, double gap,
                               int dimensions);

}  // namespace talus::reference
