// SPDX-License-Identifier: MIT
#pragma once
// Newton's method for the coupled equations, with the active set of the faces that water may leave. Internal to fem/.

#include "fem/consolidation/coupled_system.hpp"

namespace talus::fem {

/// Conditions of the flow at one time, and the load.
struct CoupledConditions {
  std::vector<double> force;        ///< external, per unknown of the solid [N]
  std::vector<NodeCondition> flow;  ///< per unknown of the flow
  std::vector<double> sink_rates;   ///< of roots [m/s]
  double dt = 0;                    ///< γΔt [s]; 0: none flows
  std::vector<double> entered;      ///< in the earlier part of the step, per unknown [m³]; empty: none
};

struct CoupledOutcome {
  bool converged = false;
  int iterations = 0;   ///< number of linear systems
  double residual = 0;  ///< out-of-balance force over `force_scale` [-]
};

template <int D>
class CoupledNewton {
 public:
  /// `force_scale`: force to which the tolerance refers [N].
  CoupledNewton(CoupledSystem<D>& system, const ConsolidationSchedule& schedule, double force_scale)
      : system_(system), schedule_(schedule), force_scale_(force_scale) {}

  /// Solves for the place at the end of a step from `start`. `q` and the heads of `place` are the first guess, and the
  /// solution; `face` holds the states of the faces, before and after.
  CoupledOutcome solve(const CoupledPlace<D>& start, const CoupledConditions& conditions, std::vector<FaceState>& face,
                       std::vector<double>& q, CoupledPlace<D>& place);

 private:
  CoupledTarget make_target(const CoupledConditions& conditions, std::vector<FaceState>& face,
                            CoupledPlace<D>& place) const;
  CoupledOutcome balance(const CoupledPlace<D>& start, const CoupledTarget& target, std::vector<double>& q,
                         CoupledPlace<D>& place, double viscosity);
  CoupledOutcome balance_somehow(const CoupledPlace<D>& start, const CoupledTarget& target, std::vector<double>& q,
                                 CoupledPlace<D>& place);
  CoupledOutcome creep(const CoupledPlace<D>& start, const CoupledTarget& target, std::vector<double>& q,
                       CoupledPlace<D>& place);
  bool creep_once(const CoupledPlace<D>& start, const CoupledTarget& target, double viscosity, std::vector<double>& q,
                  CoupledPlace<D>& place, int& solves);
  bool is_at_rest(const CoupledPlace<D>& place) const;
  bool switch_faces(const CoupledConditions& conditions, const CoupledPlace<D>& place,
                    std::vector<FaceState>& face) const;
  bool is_kept(const CoupledTarget& target, double viscosity) const {
    return has_factors_ && target.dt == dt_ && target.fixed == fixed_ && viscosity == viscosity_;
  }

  CoupledSystem<D>& system_;
  const ConsolidationSchedule& schedule_;
  double force_scale_;
  double elastic_motion_ = -1;  ///< of all loads [m]; -1: not computed yet
  std::size_t needed_ = 0;      ///< tangent that is tried first; behind the last one: creep
  bool has_factors_ = false;    ///< of a matrix with these:
  double dt_ = 0, viscosity_ = 0;
  std::vector<char> fixed_;
};

}  // namespace talus::fem
