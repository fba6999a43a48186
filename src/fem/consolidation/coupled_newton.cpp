// SPDX-License-Identifier: MIT
#include "fem/consolidation/coupled_newton.hpp"

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"

namespace talus::fem {
namespace {

constexpr double slow = 0.3;          ///< ratio of out-of-balance forces above which factors are renewed
constexpr double hopeless = 1e4;      ///< growth of the out-of-balance force at which the iteration is abandoned
constexpr double water_error = 1e-8;  ///< imbalance of water over the sum of its terms
constexpr int most_face_changes = 30;

}  // namespace

/// Sets prescribed heads, and those of wet and dry faces.
template <int D>
CoupledTarget CoupledNewton<D>::make_target(const CoupledConditions& conditions, std::vector<FaceState>& face,
                                            CoupledPlace<D>& place) const {
  CoupledTarget target{conditions.force, {}, {}, conditions.sink_rates, conditions.dt, conditions.entered};
  const SeepageSystem<D>& flow = system_.flow();
  target.supply.assign(conditions.flow.size(), 0);
  target.fixed.assign(conditions.flow.size(), 0);
  for (std::size_t u = 0; u < conditions.flow.size(); ++u) {
    const NodeCondition& c = conditions.flow[u];
    if (c.fixed) {
      target.fixed[u] = 1;
      place.head[u] = c.head;
      face[u] = FaceState::none;
      continue;
    }
    target.supply[u] = c.given;
    if (!c.face) {
      face[u] = FaceState::none;
      continue;
    }
    if (face[u] == FaceState::none) face[u] = flow.suction(u, place.head[u]) > 0 ? FaceState::open : FaceState::wet;
    if (face[u] == FaceState::open) target.supply[u] += c.offered;
    if (face[u] == FaceState::wet) place.head[u] = flow.elevation[u];
    if (face[u] == FaceState::dry) place.head[u] = flow.elevation[u] - c.suction_limit / flow.model.unit_weight;
    target.fixed[u] = face[u] != FaceState::open;
  }
  return target;
}

/// Changes the state of faces that violate their condition: a wet face that would draw more water than is offered, an
/// open one under pressure or beyond the limit of evaporation.
template <int D>
bool CoupledNewton<D>::switch_faces(const CoupledConditions& conditions, const CoupledPlace<D>& place,
                                    std::vector<FaceState>& face) const {
  const SeepageSystem<D>& flow = system_.flow();
  const double slack = water_error * place.volume + place.rounding;
  bool switched = false;
  for (std::size_t u = 0; u < face.size(); ++u) {
    if (face[u] == FaceState::none) continue;
    const NodeCondition& c = conditions.flow[u];
    const double s = flow.suction(u, place.head[u]), drawn = -place.water[u];  // beyond what is given [m³]
    FaceState next = face[u];
    if (face[u] == FaceState::wet && drawn > conditions.dt * c.offered + slack) next = FaceState::open;
    if (face[u] == FaceState::dry && drawn < conditions.dt * c.offered - slack) next = FaceState::open;
    if (face[u] == FaceState::open && s < 0) next = FaceState::wet;
    if (face[u] == FaceState::open && s > c.suction_limit) next = FaceState::dry;
    switched = switched || next != face[u];
    face[u] = next;
  }
  return switched;
}

template <int D>
CoupledOutcome CoupledNewton<D>::balance(const CoupledPlace<D>& start, const CoupledTarget& target,
                                         std::vector<double>& q, CoupledPlace<D>& place) {
  CoupledOutcome out;
  std::vector<double> change;
  double first = -1, last = -1;
  for (;;) {
    throw_if_interrupted();
    system_.evaluate(start, q, target, false, place);
    out.residual = place.fault / force_scale_;
    if (!std::isfinite(place.fault) || !std::isfinite(place.leak)) return out;
    if (out.iterations > 0 && out.residual <= schedule_.force_tolerance &&
        place.leak <= water_error * place.volume + place.rounding) {
      out.converged = true;
      return out;
    }
    if (out.iterations >= schedule_.most_iterations) return out;
    if (first < 0) first = std::max(place.fault, force_scale_ * schedule_.force_tolerance);
    // After the first correction forces of prescribed heads have appeared; growth counts from there.
    if (out.iterations > 1 && place.fault > hopeless * std::max(first, last)) return out;
    if (!is_kept(target) || (out.iterations > 1 && place.fault > slow * last)) {
      system_.evaluate(start, q, target, true, place);
      has_factors_ = system_.factorise(target, place);
      if (!has_factors_) return out;
      dt_ = target.dt;
      fixed_ = target.fixed;
    }
    if (!system_.solve(place, target.fixed, change)) {
      has_factors_ = false;
      return out;
    }
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += change[i];
    for (std::size_t u = 0; u < place.head.size(); ++u) place.head[u] += change[q.size() + u];
    if (out.iterations > 0) last = place.fault;
    ++out.iterations;
  }
}

template <int D>
CoupledOutcome CoupledNewton<D>::solve(const CoupledPlace<D>& start, const CoupledConditions& conditions,
                                       std::vector<FaceState>& face, std::vector<double>& q, CoupledPlace<D>& place) {
  CoupledOutcome all;
  for (int i = 0; i < most_face_changes; ++i) {
    const CoupledTarget target = make_target(conditions, face, place);
    CoupledOutcome out = balance(start, target, q, place);
    out.iterations += all.iterations;
    all = out;
    if (!all.converged || !switch_faces(conditions, place, face)) return all;
  }
  all.converged = false;
  return all;
}

template class CoupledNewton<2>;
template class CoupledNewton<3>;

}  // namespace talus::fem
