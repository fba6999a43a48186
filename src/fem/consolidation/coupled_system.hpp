// SPDX-License-Identifier: MIT
#pragma once
// The coupled equations of one stage: unknowns are those of the solid, then the heads. Internal to fem/.

#include <optional>

#include "fem/consolidation/consolidation.hpp"
#include "fem/seepage/system.hpp"
#include "fem/solid/system.hpp"
#include "sparse/solver.hpp"

namespace talus::fem {

/// Loads and given values at the end of a step, or of one of its two parts (T26.4).
struct CoupledTarget {
  std::vector<double> force;       ///< external force per unknown of the solid [N]
  std::vector<double> supply;      ///< inflow that is given, per unknown of the flow [m³/s]
  std::vector<char> fixed;         ///< heads that are given, likewise
  std::vector<double> sink_rates;  ///< of roots
  double dt = 0;                   ///< γΔt, the weight of this part's flow [s]; 0: none flows
  std::vector<double> entered;     ///< water that entered each node in the earlier part [m³]
};

/// Values at a state, and their imbalance.
template <int D>
struct CoupledPlace {
  SolidState<D> solid;
  std::vector<double> head;  ///< per unknown of the flow
  SolidSums sums;
  std::vector<double> force;   ///< external less internal [N]
  std::vector<double> water;   ///< water that entered a node less what it stores [m³]
  std::vector<double> inflow;  ///< rate at which water enters each node [m³/s]
  double fault = 0;            ///< norm of `force` [N]
  double leak = 0;             ///< sum of |water| where no head is fixed [m³]
  double volume = 0;           ///< sum of the absolute terms of `water` [m³]
  double rounding = 0;         ///< of the water in the soil [m³]
};

template <int D>
class CoupledSystem {
 public:
  static constexpr std::size_t corners = D + 1, locals = SolidSystem<D>::locals;
  CoupledSystem(const ConsolidationModel<D>& model, int threads);

  const SolidSystem<D>& solid() const { return solid_; }
  const SeepageSystem<D>& flow() const { return flow_; }
  const SolidAssembly<D>& assembly() const { return assembly_; }
  int unknowns() const { return solid_.unknowns + flow_.size(); }
  int factorisations() const { return solver_->factorisations(); }

  /// Computes the place reached from `start` by the change `q` of the unknowns of the solid, with its heads.
  void evaluate(const CoupledPlace<D>& start, const std::vector<double>& q, const CoupledTarget& target,
                bool with_matrix, CoupledPlace<D>& place);
  /// Returns the norm of the nodal forces of the pore water alone [N].
  double find_pore_force(const std::vector<double>& head);
  /// Factorises the matrix of the last evaluate() with one, whose tangent is increased by `viscosity` times the elastic
  /// stiffness. Returns false if it is singular.
  bool factorise(const CoupledTarget& target, const CoupledPlace<D>& place, double viscosity);
  /// Subtracts the forces of an elastic viscosity that the motion `q` from `place` needs from those of the solid [N].
  void resist(double viscosity, const CoupledPlace<D>& place, const std::vector<double>& q, std::vector<double>& force);
  /// Returns the largest displacement of elastic soil under all loads, without flow from `place` [m]; 0 if it is not
  /// known.
  double find_elastic_motion(const CoupledTarget& target, const CoupledPlace<D>& place);
  /// Computes the change of all unknowns that removes the imbalance of `place` by the last factors. Returns false if
  /// it is not finite.
  bool solve(const CoupledPlace<D>& place, const std::vector<char>& fixed, std::vector<double>& change);

 private:
  void couple();
  void couple_joints();
  void add_drains();
  void make_pattern();
  void set_pores(const std::vector<double>& head);
  /// Adds the forces of the pore water in the joints, by the pressures of the last set_pores().
  void add_joint_pores(std::vector<double>& force) const;
  void add_storage(const CoupledPlace<D>& start, const std::vector<double>& q, CoupledPlace<D>& place);
  void add_flow(const CoupledTarget& target, bool with_matrix, CoupledPlace<D>& place);
  const std::vector<double>& find_elastic_matrix(const CoupledPlace<D>& place);

  const ConsolidationModel<D>& model_;
  SolidSystem<D> solid_;
  SeepageSystem<D> flow_;
  SolidAssembly<D> assembly_;
  /// An element with soil and water: its numbers among those of the solid and of the flow, and ∫ N_A div N_i.
  struct Couple {
    std::size_t solid = 0, flow = 0;
    std::array<std::array<double, locals>, corners> rate{};
    std::array<int, locals> unknown{};
    std::array<int, corners> node{};  ///< unknowns of the flow
    /// d(χp)/dp, S_w and dS_w/dp at the corners of the last place.
    std::array<double, corners> bishop{}, share{}, slope{};
    std::array<int, corners * locals> above{}, below{};  ///< in the matrix: rows of the solid, and of the flow
  };
  std::vector<Couple> couples_;
  /// A joint of a wall beside soil with water, whose pressure acts on both and enters the gap where it opens.
  struct JointCouple {
    int region = 0;                  ///< of the flow
    std::vector<int> unknown;        ///< of the solid
    std::vector<double> rate;        ///< derivative of the volume of the gap by each of them [m²]
    std::array<int, 2> node{};       ///< unknowns of the flow: the ends of the edge on which the joint lies
    std::array<double, 2> weight{};  ///< of the pressures of both at the joint [-]
    std::array<double, 2> bishop{}, share{}, slope{};  ///< as those of Couple
    std::vector<int> above, below;                     ///< in the matrix, node by node
  };
  std::vector<JointCouple> joints_;
  const std::vector<std::array<double, Quadratic<D>::points>> constant_pore_;  ///< of the solid, without flow [Pa]
  struct Drain {
    std::size_t unknown;
    double rate, head;  ///< [m²/s], [m] above the datum of the flow
  };
  std::vector<Drain> drains_;
  std::vector<double> joint_pressure_;  ///< of the water in each joint, positive in tension [Pa]
  std::vector<int> column_start_, row_;
  std::vector<int> solid_slots_, flow_slots_, diagonal_;  ///< of the entries of both matrices, and of their diagonal
  std::vector<double> flow_matrix_;                       ///< ∂outflow/∂head of the last place [m²/s]
  std::vector<double> capacity_;                          ///< ∂stored/∂head of the nodes there [m²]
  std::vector<double> matrix_, elastic_;                  ///< the latter: of the elastic soil, when it was needed
  bool symmetric_ = true;
  std::optional<sparse::SparseSolver<>> solver_;
};

}  // namespace talus::fem
