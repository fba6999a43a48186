// SPDX-License-Identifier: MIT
#pragma once
// Bars as springs. Every part of a bar, at a point of integration, is a spring with one deformation that is linear in
// the unknowns: strain, shear strain and curvature of the bar, slip of the bond, motion of the plate. Internal to fem/.

#include <utility>
#include <vector>

#include "base/spring.hpp"
#include "fem/solid/bars.hpp"

namespace talus::fem {

template <int D>
struct QuadraticMesh;
template <int D>
struct NodeUnknowns;

enum class SpringKind { axial, shear, bending, bond, lateral, plate, anchorage };

/// An elastic, perfectly plastic spring. Its force is stiffness times elastic deformation, which is its state.
struct Spring {
  int bar = 0;
  SpringKind kind = SpringKind::axial;
  double place = 0;             ///< distance from the head of the bar [m]
  double weight = 1;            ///< length that it stands for [m]; 1 for plate and anchorage
  double stiffness = 0;         ///< force per deformation
  double lower = 0, upper = 0;  ///< strengths
  bool slackens = false;        ///< below zero its force is zero and its deformation is elastic
  bool is_jacked = false;       ///< keeps the prestress while the loads are applied
  double prestress = 0;
  bool is_reduced = false;     ///< its strengths are divided by the factor
  std::vector<int> unknown{};  ///< unknowns of its deformation, each once
  std::vector<double> rate{};  ///< derivative of the deformation by each of them
  std::vector<int> slots{};    ///< index of each pair of unknowns in the global matrix
};

struct SpringSet {
  std::vector<Spring> list;
  int unknowns = 0;                           ///< of the bars
  std::vector<std::pair<int, double>> loads;  ///< on the bars: unknown and force [N]
};

/// How springs respond in a step.
struct SpringStage {
  double factor = 1;       ///< of the trial
  bool is_jacked = false;  ///< loads are being applied: anchors keep their prestress
};

/// Returns the answer of a spring to a deformation since its elastic deformation was `start`.
SpringAnswer update_spring(const Spring& spring, const SpringStage& stage, double start, double deformation);

/// Makes the springs of bars in a mesh; unknowns of the bars are numbered from `first`. Throws Error (wrong_input) for
/// a bar without length, stiffness or contact with the soil.
SpringSet make_springs(const std::vector<Bar>& bars, const QuadraticMesh<2>& mesh,
                       const std::vector<NodeUnknowns<2>>& nodes, int first);

/// Returns the forces of each bar in a state of its springs.
std::vector<BarForces> compute_bar_forces(const std::vector<Bar>& bars, const std::vector<Spring>& springs,
                                          const std::vector<double>& state, double factor);

}  // namespace talus::fem
