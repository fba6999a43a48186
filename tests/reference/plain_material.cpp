// SPDX-License-Identifier: MIT
#include "reference/plain_material.hpp"

namespace talus::reference {

std::vector<Plane> list_planes(const Material& m) {
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

Tensor principal_stiffness(const Material& m) {
  const double lambda = m.young_modulus * m.poisson_ratio / ((1 + m.poisson_ratio) * (1 - 2 * m.poisson_ratio));
  const double shear = m.young_modulus / (2 * (1 + m.poisson_ratio));
  return lambda * Tensor::Ones() + 2 * shear * Tensor::Identity();
}

std::vector<Vector3> find_returns(const Material& m, const Vector3& trial, int count) {
  const std::vector<Plane> planes = list_planes(m);
  const Tensor d = principal_stiffness(m);
  // Round-off of the linear solves: a stress outside by less than this counts as on the surface.
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

Vector3 return_principal(const Material& m, const Vector3& trial) {
  for (int count = 0; count <= 3; ++count) {
    const std::vector<Vector3> found = find_returns(m, trial, count);
    if (!found.empty()) return found.front();
  }
  return Vector3::Constant(m.cohesion / std::tan(m.friction_angle));
}

StressUpdate update_stress(const Material& m, const Tensor& sigma, const Tensor& strain_increment) {
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
          axes * plastic.asDiagonal() * axes.transpose()};
}

StressUpdate update_separating(const Material& m, const Tensor& sigma, const Tensor& strain_increment, double gap,
                               int dimensions) {
  if (!m.plastic) return update_stress(m, sigma, strain_increment);
  const double shear = m.young_modulus / (2 * (1 + m.poisson_ratio));
  const double lambda = principal_stiffness(m)(0, 1);
  const double tension = std::max(0.0, sigma.diagonal().head(dimensions).mean());  // of the directions that move
  const double pressed = -strain_increment.trace() - tension / (lambda + 2 * shear / dimensions);
  const double closed = std::clamp(pressed, 0.0, gap);
  Tensor rest = strain_increment;
  rest.diagonal().head(dimensions).array() += closed / dimensions;
  StressUpdate update = update_stress(m, sigma, rest);
  // The soil separates where the stress equals the tensile strength in all in-plane directions.
  const double apex = m.friction_angle > 0 ? m.cohesion / std::tan(m.friction_angle) : INFINITY;
  const double limit = std::min(m.tensile_strength, apex);
  const double borne = update.sigma.diagonal().head(dimensions).sum();
  if (update.plastic.trace() > 0 && borne > dimensions * limit - 1e-12 * shear) update.opened = update.plastic.trace();
  update.opened -= closed;
  return update;
}

}  // namespace talus::reference
