// SPDX-License-Identifier: MIT
#pragma once
// Elastic, perfectly plastic springs: the parts of a bar and its joints with the soil, in FEM and MPM.

namespace talus {

struct SpringLaw {
  double stiffness = 0;         ///< force per deformation
  double lower = 0, upper = 0;  ///< strengths
  bool slackens = false;        ///< below zero the force is zero and the deformation is elastic
};

struct SpringAnswer {
  double elastic = 0;  ///< deformation, which is the state of the spring
  double force = 0;
  double tangent = 0;
};

/// Returns the answer of a spring to a deformation since its elastic deformation was `start`.
inline SpringAnswer deform_spring(const SpringLaw& law, double start, double deformation) {
  const double trial = start + deformation, force = law.stiffness * trial;
  if (force > law.upper) return {law.upper / law.stiffness, law.upper, 0};
  if (force < 0 && law.slackens) return {trial, 0, 0};
  if (force < law.lower) return {law.lower / law.stiffness, law.lower, 0};
  return {trial, force, law.stiffness};
}

}  // namespace talus
