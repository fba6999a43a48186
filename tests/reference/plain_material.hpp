// SPDX-License-Identifier: MIT
#pragma once
// One point of soil, written for reading: linear elasticity and Mohr–Coulomb with a tension cut-off by trying every
// set of yield planes. Slow, and independent of the engine's closed-form return, which is tested against it.

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
  Tensor sigma;                   ///< [Pa]
  double plastic_strain = 0;      ///< sqrt(2/3 e^p:e^p) of the deviatoric plastic strain of this increment [-]
  double mean_stress_change = 0;  ///< p(σ_returned) − p(σ_trial) [Pa], p = tr σ/3
};

/// A linear yield function of the ordered principal stresses: f = normal·σ − strength, flow along `flow`.
struct Plane {
  Vector3 normal, flow;
  double strength;  ///< [Pa]
};

/// The planes that can be active while σ1 ≥ σ2 ≥ σ3: Mohr–Coulomb f = (σa−σb) + (σa+σb) sinφ − 2c cosφ for the pairs
/// (1,3), (1,2), (2,3), whose flow has ψ for φ; and Rankine f = σa − σ_t with associated flow. The Rankine planes are
/// left out where the cone's apex lies below them.
inline std::vector<Plane> list_planes(const Material& m) {
  std::vector<Plane> planes;
  const double s = std::sin(m.friction_angle), s_flow = std::sin(m.dilatancy_angle), c = std::cos(m.friction_angle);
  for (auto [a, b] : {std::pair{0, 2}, {0, 1}, {1, 2}}) {
    Plane plane{Vector3::Zero(), Vector3::Zero(), 2 * m.cohesion * c};
    plane.normal[a] = 1 + s, plane.normal[b] = s - 1;
    plane.flow[a] = 1 + s_flow, plane.flow[b] = s_flow - 1;
    planes.push_back(plane);
  }
  if (m.tensile_strength * s < m.cohesion * c)
    for (int a = 0; a < 3; ++a) planes.push_back({Vector3::Unit(a), Vector3::Unit(a), m.tensile_strength});
  return planes;
}

/// Relation of principal stresses to principal elastic strains [Pa].
inline Tensor principal_stiffness(const Material& m) {
  const double lambda = m.young_modulus * m.poisson_ratio / ((1 + m.poisson_ratio) * (1 - 2 * m.poisson_ratio));
  const double shear = m.young_modulus / (2 * (1 + m.poisson_ratio));
  return lambda * Tensor::Ones() + 2 * shear * Tensor::Identity();
}

/// Every stress that some set of `count` active planes returns the ordered principal `trial` [Pa] to:
/// σ = σ_trial − Σ λ_j D m_j with f = 0 on the set, λ_j ≥ 0, no plane violated and σ1 ≥ σ2 ≥ σ3 kept.
inline std::vector<Vector3> find_returns(const Material& m, const Vector3& trial, int count) {
  const std::vector<Plane> planes = list_planes(m);
  const Tensor d = principal_stiffness(m);
  // Round-off of the linear solves; a stress outside by this share cannot be told from one on the surface.
  const double tolerance = 1e-11 * (trial.cwiseAbs().maxCoeff() + m.cohesion);
  std::vector<Vector3> found;
  for (unsigned set = 0; set < (1u << planes.size()); ++set) {
    if (std::popcount(set) != count) continue;
    std::vector<Plane> active;
    for (std::size_t i = 0; i < planes.size(); ++i)
      if (set >> i & 1u) active.push_back(planes[i]);

    Eigen::MatrixXd matrix(count, count);
    Eigen::VectorXd f(count), multipliers(count);
    for (int i = 0; i < count; ++i) {
      const Plane& plane = active[static_cast<std::size_t>(i)];
      f[i] = plane.normal.dot(trial) - plane.strength;
      for (int j = 0; j < count; ++j) matrix(i, j) = plane.normal.dot(d * active[static_cast<std::size_t>(j)].flow);
    }
    Vector3 sigma = trial;
    if (count > 0) {
      Eigen::FullPivLU<Eigen::MatrixXd> lu(matrix);
      lu.setThreshold(1e-10);  // planes that are dependent (ψ = 0: all three) but for round-off are no set of their own
      if (!lu.isInvertible()) continue;
      multipliers = lu.solve(f);
      if (multipliers.minCoeff() * m.young_modulus < -tolerance) continue;
      for (int j = 0; j < count; ++j) sigma -= multipliers[j] * d * active[static_cast<std::size_t>(j)].flow;
    }
    const bool ordered = sigma[0] >= sigma[1] - tolerance && sigma[1] >= sigma[2] - tolerance;
    const bool admissible = std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
      return plane.normal.dot(sigma) - plane.strength <= tolerance;
    });
    if (ordered && admissible) found.push_back(sigma);
  }
  return found;
}

/// Principal stresses after the return, of the ordered (σ1 ≥ σ2 ≥ σ3) trial ones [Pa]. The smallest number of active
/// planes is preferred: it is the regular return, and the sets that it leaves out hold only where they agree with it.
/// Where no set returns the point (ψ = 0 cannot reduce the mean stress beyond the apex) it goes to the apex c/tanφ.
inline Vector3 return_principal(const Material& m, const Vector3& trial) {
  for (int count = 0; count <= 3; ++count) {
    const std::vector<Vector3> found = find_returns(m, trial, count);
    if (!found.empty()) return found.front();
  }
  return Vector3::Constant(m.cohesion / std::tan(m.friction_angle));
}

/// Elastic increment and, for a plastic material, the return to the yield surface. Plane strain passes the same
/// three-dimensional tensors with ε_zz = 0.
inline StressUpdate update_stress(const Material& m, const Tensor& sigma, const Tensor& strain_increment) {
  const double shear = m.young_modulus / (2 * (1 + m.poisson_ratio));
  const double bulk = m.young_modulus / (3 * (1 - 2 * m.poisson_ratio));
  const double volumetric = strain_increment.trace();
  const Tensor deviatoric = strain_increment - volumetric / 3 * Tensor::Identity();
  const Tensor trial = sigma + 2 * shear * deviatoric + bulk * volumetric * Tensor::Identity();
  if (!m.plastic) return {trial};

  const Eigen::SelfAdjointEigenSolver<Tensor> solver(trial);
  const Vector3 ordered_trial = solver.eigenvalues().reverse();
  const Vector3 ordered = return_principal(m, ordered_trial);
  if (ordered == ordered_trial) return {trial};  // elastic: no round trip through the principal axes

  Tensor axes;  // column a belongs to σ_a
  for (int a = 0; a < 3; ++a) axes.col(a) = solver.eigenvectors().col(2 - a);
  const Vector3 plastic = principal_stiffness(m).inverse() * (ordered_trial - ordered);
  const Vector3 plastic_deviator = plastic - Vector3::Constant(plastic.mean());
  return {axes * ordered.asDiagonal() * axes.transpose(), std::sqrt(2.0 / 3) * plastic_deviator.norm(),
          ordered.mean() - ordered_trial.mean()};
}

}  // namespace talus::reference
