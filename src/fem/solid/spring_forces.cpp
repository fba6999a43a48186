// SPDX-License-Identifier: MIT
// Forces of springs and joints, and the forces of bars and walls that consist of them.
#include <algorithm>
#include <cmath>

#include "fem/solid/springs.hpp"

namespace talus::fem {

namespace {
constexpr double faded_opening = 1e-3;  ///< of a joint, at which its adhesion is lost [m]
}

SpringAnswer update_spring(const Spring& spring, const SpringStage& stage, double start, double deformation) {
  if (spring.is_jacked && stage.is_jacked) return {spring.prestress / spring.stiffness, spring.prestress, 0};
  const double share = spring.is_reduced ? stage.factor : 1;
  return deform_spring({spring.stiffness, spring.lower / share, spring.upper / share, spring.slackens}, start,
                       deformation);
}

namespace {

/// Returns axial force and moment to the strength |N|/N_p + |M|/M_p ≤ 1 (T19.16): the nearest point of it in the norm
/// of the elastic energy.
JointAnswer update_section(const Joint& section, const std::array<double, 2>& elastic) {
  const std::array<double, 2> k{section.normal_stiffness, section.tangential_stiffness},
      strength{section.axial, section.moment};
  JointAnswer answer{elastic, {k[0] * elastic[0], k[1] * elastic[1]}, {k[0], 0, 0, k[1]}};
  const double excess = std::abs(answer.force[0]) / strength[0] + std::abs(answer.force[1]) / strength[1] - 1;
  if (excess <= 0) return answer;
  answer.yields = true;
  std::array<double, 2> flow{}, pushed{};  // a and D a
  double whole = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    flow[i] = (answer.force[i] < 0 ? -1 : 1) / strength[i];
    pushed[i] = k[i] * flow[i];
    whole += pushed[i] * flow[i];
  }
  const std::array<double, 2> trial = answer.force;
  for (std::size_t i = 0; i < 2; ++i) answer.force[i] -= excess / whole * pushed[i];
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) answer.tangent[2 * i + j] -= pushed[i] * pushed[j] / whole;
  // Beyond a corner the other force is the whole strength.
  for (std::size_t i = 0; i < 2; ++i)
    if (answer.force[i] * flow[i] < 0) {
      answer.force[i] = 0;
      answer.force[1 - i] = (trial[1 - i] < 0 ? -1 : 1) * strength[1 - i];
      answer.tangent.fill(0);
    }
  for (std::size_t i = 0; i < 2; ++i) answer.elastic[i] = answer.force[i] / k[i];
  return answer;
}

}  // namespace

JointAnswer update_joint(const Joint& joint, const SpringStage& stage, const std::array<double, 2>& start,
                         const std::array<double, 2>& deformation) {
  if (joint.is_section) return update_section(joint, {start[0] + deformation[0], start[1] + deformation[1]});
  const double kn = joint.normal_stiffness, kt = joint.tangential_stiffness;
  const double opening = start[0] + deformation[0], slip = start[1] + deformation[1];
  const double adhesion = joint.adhesion / stage.factor, friction = joint.friction / stage.factor;
  JointAnswer answer{{opening, slip}, {std::min(0.0, kn * opening), kt * slip}, {opening < 0 ? kn : 0, 0, 0, kt}};
  // An open joint has no friction, and its adhesion fades, so that the stress remains continuous.
  double limit = adhesion - friction * answer.force[0], slope = -friction * kn;
  if (opening > 0) {
    limit = adhesion * std::max(0.0, 1 - opening / faded_opening);
    slope = limit > 0 ? -adhesion / faded_opening : 0;
  }
  if (joint.is_rough && opening <= 0) return answer;
  if (joint.is_rough) limit = slope = 0;
  if (std::abs(answer.force[1]) <= limit) return answer;
  const double sign = slip > 0 ? 1 : -1;
  answer.force[1] = sign * limit;
  answer.elastic[1] = answer.force[1] / kt;
  answer.tangent[2] = sign * slope;
  answer.tangent[3] = 0;
  answer.yields = true;
  return answer;
}

namespace {

/// Adds axial force and moment of a section of a wall, with the strengths that the other of them leaves.
void add_section(const Joint& section, double axial, double moment, BarForces& forces) {
  forces.axial.place.push_back(section.place);
  forces.axial.value.push_back(axial);
  forces.axial.limit.push_back(section.axial);
  forces.moment.place.push_back(section.place);
  forces.moment.value.push_back(moment);
  forces.moment.limit.push_back(section.moment * std::max(1e-9, 1 - std::abs(axial) / section.axial));
  forces.energy += 0.5 * section.weight *
                   (axial * axial / section.normal_stiffness + moment * moment / section.tangential_stiffness);
}

}  // namespace

std::vector<BarForces> compute_bar_forces(std::size_t count, const SpringSet& springs, const std::vector<double>& state,
                                          double factor) {
  std::vector<BarForces> found(count);
  for (std::size_t i = 0; i < springs.list.size(); ++i) {
    const Spring& spring = springs.list[i];
    BarForces& forces = found[static_cast<std::size_t>(spring.bar)];
    const double force = spring.slackens ? std::max(0.0, spring.stiffness * state[i]) : spring.stiffness * state[i];
    if (spring.stiffness > 0) forces.energy += 0.5 * spring.weight * force * force / spring.stiffness;
    const auto add = [&](BarCurve& curve) {
      curve.place.push_back(spring.place);
      curve.value.push_back(force);
      curve.limit.push_back(spring.upper / (spring.is_reduced ? factor : 1));
    };
    switch (spring.kind) {
      case SpringKind::axial:
        add(forces.axial);
        break;
      case SpringKind::shear:
        add(forces.shear);
        break;
      case SpringKind::bending:
        add(forces.moment);
        break;
      case SpringKind::bond:
        add(forces.bond);
        break;
      case SpringKind::lateral:
        add(forces.lateral);
        break;
      case SpringKind::plate:
        forces.plate = force;
        forces.plate_limit = spring.upper;
        break;
      case SpringKind::anchorage:
        forces.anchorage = force;
        break;
      case SpringKind::strut:
        add(forces.strut);
        break;
    }
  }
  for (std::size_t j = 0; j < springs.joints.size(); ++j) {
    const Joint& joint = springs.joints[j];
    const std::size_t place = springs.list.size() + 2 * j;
    const auto [tension, shear] = update_joint(joint, {factor}, {state[place], state[place + 1]}, {0, 0}).force;
    BarForces& forces = found[static_cast<std::size_t>(joint.wall)];
    if (joint.is_section) {
      add_section(joint, tension, shear, forces);
      continue;
    }
    forces.face[static_cast<std::size_t>(joint.side)].push_back(
        {joint.place, -tension, shear,
         joint.is_rough ? unlimited : (joint.adhesion - joint.friction * tension) / factor});
  }
  return found;
}

}  // namespace talus::fem
