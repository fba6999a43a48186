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
template <int D>
struct SolidModel;

enum class SpringKind { axial, shear, bending, bond, lateral, plate, anchorage, strut };

/// An elastic, perfectly plastic spring. Its force is stiffness times elastic deformation, which is its state.
struct Spring {
  int bar = 0;  ///< or wall, counted after the bars
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

/// Two deformations with a common strength. A point of the interface between a wall and the soil on one of its sides:
/// opening and slip, with Mohr–Coulomb friction and no tension (T19.15). Or a section of a wall: axial strain and
/// curvature, with N_p and M_p (T19.16); `opening` and `slip` stand for these then.
struct Joint {
  int wall = 0;
  bool is_section = false;
  double axial = 0, moment = 0;  ///< N_p [N] and M_p [N m] of a section
  int side = 0;                  ///< 0: soil at the left of the way from head to toe, 1: at the right
  double place = 0;              ///< distance from the head [m]
  double weight = 0;             ///< length that it stands for [m]
  double normal_stiffness = 0, tangential_stiffness = 0;  ///< of a section E A and E I
  int node = -1;                                          ///< of the soil, in the quadratic mesh
  int element = -1;                                       ///< of the soil, there
  Vec<2> normal{};                                        ///< from the wall to the soil
  bool is_rough = false;                                  ///< no limit of the shear stress
  double adhesion = 0, friction = 0;
  double compression = 0;                 ///< initial effective stress [Pa]
  std::vector<int> unknown{};             ///< unknowns of the deformations, each once
  std::vector<double> opening{}, slip{};  ///< derivatives by each of them
  std::vector<int> slots{};               ///< index of each pair of unknowns in the global matrix
};

/// Returns the kind of a joint among those of KnownSpring.
inline int find_joint_kind(const Joint& joint) {
  return joint.is_section ? -3 : -1 - joint.side;
}

struct JointAnswer {
  std::array<double, 2> elastic{}, force{};  ///< opening and slip, the state of the joint; tension and shear [Pa]
  std::array<double, 4> tangent{};           ///< by rows
  bool yields = false;                       ///< slips, or a section yields
};

struct SpringSet {
  std::vector<Spring> list;
  std::vector<Joint> joints;
  int unknowns = 0;                           ///< of the bars
  std::vector<std::pair<int, double>> loads;  ///< on the bars: unknown and force [N]
  std::vector<int> heads;                     ///< of each bar: unknown of the displacement of its head along it
};

/// How springs respond in a step.
struct SpringStage {
  double factor = 1;       ///< of the trial
  bool is_jacked = false;  ///< loads are being applied: anchors keep their prestress
};

/// Returns the answer of a spring to a deformation since its elastic deformation was `start`.
SpringAnswer update_spring(const Spring& spring, const SpringStage& stage, double start, double deformation);

/// Returns the answer of a joint to an opening and a slip since its elastic deformations were `start`.
JointAnswer update_joint(const Joint& joint, const SpringStage& stage, const std::array<double, 2>& start,
                         const std::array<double, 2>& deformation);

/// Adds springs, joints and loads of the walls of a model; their unknowns are numbered from `first`. Throws Error
/// (wrong_input) for a wall that has no stiffness or soil, or that is no line of the mesh.
void add_walls(const SolidModel<2>& model, const QuadraticMesh<2>& mesh, const std::vector<NodeUnknowns<2>>& nodes,
               int first, SpringSet& set);

/// Makes the springs of bars in a mesh; unknowns of the bars are numbered from `first`. Throws Error (wrong_input) for
/// a bar without length, stiffness or contact with the soil.
SpringSet make_springs(const std::vector<Bar>& bars, const QuadraticMesh<2>& mesh,
                       const std::vector<NodeUnknowns<2>>& nodes, int first);

/// Returns the forces of `count` bars and walls in a state of their springs and joints.
std::vector<BarForces> compute_bar_forces(std::size_t count, const SpringSet& springs, const std::vector<double>& state,
                                          double factor);

}  // namespace talus::fem
