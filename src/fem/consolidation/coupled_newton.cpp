// SPDX-License-Identifier: MIT
#include "fem/consolidation/coupled_newton.hpp"

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "fem/solid/creep.hpp"

namespace talus::fem {
namespace {

constexpr double slow = 0.3;          ///< ratio of out-of-balance forces above which factors are renewed
constexpr double hopeless = 1e4;      ///< growth of the out-of-balance force at which the iteration is abandoned
constexpr double water_error = 1e-8;  ///< imbalance of water over the sum of its terms
constexpr int most_face_changes = 30;
/// Fractions of the elastic stiffness that are added to the tangent, one after the other.
constexpr std::array viscosities{0.0, 0.02, 0.2};
constexpr int patience = 4;  ///< times as many linear systems with them
/// Fall of the out-of-balance force over so many iterations below which they are given up.
constexpr std::size_t watched = 10;
constexpr double least_fall = 0.5;
constexpr int most_creep_solves = 400;
constexpr double steady_force = 10;  ///< smallest out-of-balance force of steady flow, over the tolerance

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
                                         std::vector<double>& q, CoupledPlace<D>& place, double viscosity) {
  CoupledOutcome out;
  const int most = viscosity > 0 ? patience * schedule_.most_iterations : schedule_.most_iterations;
  std::vector<double> change;
  double first = -1, last = -1;
  std::vector<double> faults;
  for (;;) {
    throw_if_interrupted();
    system_.evaluate(start, q, target, false, place);
    out.residual = place.fault / force_scale_;
    if (!std::isfinite(place.fault) || !std::isfinite(place.leak)) return out;
    if (out.iterations > 0 && is_at_rest(place)) {
      out.converged = true;
      return out;
    }
    if (out.iterations >= most) return out;
    faults.push_back(place.fault);
    if (faults.size() > watched && place.fault > least_fall * faults[faults.size() - 1 - watched]) return out;
    if (first < 0) first = std::max(place.fault, force_scale_ * schedule_.force_tolerance);
    // After the first correction forces of prescribed heads have appeared; growth counts from there.
    if (out.iterations > 1 && place.fault > hopeless * std::max(first, last)) return out;
    if (!is_kept(target, viscosity) || (out.iterations > 1 && place.fault > slow * last)) {
      system_.evaluate(start, q, target, true, place);
      has_factors_ = system_.factorise(target, place, viscosity);
      if (!has_factors_) return out;
      dt_ = target.dt;
      viscosity_ = viscosity;
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
bool CoupledNewton<D>::is_at_rest(const CoupledPlace<D>& place) const {
  return place.fault / force_scale_ <= schedule_.force_tolerance &&
         place.leak <= water_error * place.volume + place.rounding;
}

/// One implicit step of creep from the motion `q` at `place`, which has the matrix of its tangent: f_int(q) +
/// β K_el Δq = f, to a fraction of the out-of-balance force. Returns false if it does not converge.
template <int D>
bool CoupledNewton<D>::creep_once(const CoupledPlace<D>& start, const CoupledTarget& target, double viscosity,
                                  std::vector<double>& q, CoupledPlace<D>& place, int& solves) {
  const double fault = place.fault;
  std::vector<double> moved(q.size(), 0), change;
  double lack = fault;
  for (int i = 1; i <= creep::most_solves; ++i) {
    throw_if_interrupted();
    if (!system_.factorise(target, place, viscosity) || !system_.solve(place, target.fixed, change)) return false;
    ++solves;
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += change[k], moved[k] += change[k];
    for (std::size_t u = 0; u < place.head.size(); ++u) place.head[u] += change[q.size() + u];
    system_.evaluate(start, q, target, true, place);
    const double last = lack;
    system_.resist(viscosity, place, moved, place.force);
    lack = creep::find_norm(place.force);
    if (lack <= creep::good_share * fault) return true;
    if (creep::is_hopeless(lack, last, fault, i)) break;
  }
  return viscosity >= creep::most_viscosity && lack < fault;
}

/// Lets the soil creep from `q` to rest, with the elastic stiffness as viscosity. Only equilibrium counts: viscous
/// forces are those of the way to it.
template <int D>
CoupledOutcome CoupledNewton<D>::creep(const CoupledPlace<D>& start, const CoupledTarget& target,
                                       std::vector<double>& q, CoupledPlace<D>& place) {
  CoupledOutcome out;
  has_factors_ = false;
  double viscosity = creep::first_viscosity;
  creep::Way way;
  bool went = false;
  const std::vector<double> first = q;
  for (;;) {
    system_.evaluate(start, q, target, true, place);
    out.residual = place.fault / force_scale_;
    if (!std::isfinite(place.fault) || !std::isfinite(place.leak)) return out;
    out.converged = is_at_rest(place);
    if (out.converged || out.iterations >= most_creep_solves) return out;
    if (elastic_motion_ < 0) elastic_motion_ = system_.find_elastic_motion(target, place);
    const std::vector<double> last_q = q, last_head = place.head;
    int solves = 0;
    const bool arrived = creep_once(start, target, viscosity, q, place, solves);
    out.iterations += solves;
    if (!arrived) {
      if (viscosity >= creep::most_viscosity) return out;
      q = last_q, place.head = last_head;
      viscosity = creep::stiffen(viscosity, went);
      continue;
    }
    went = true;
    double motion = 0;
    for (std::size_t i = 0; i < q.size(); ++i) motion = std::max(motion, std::abs(q[i] - first[i]));
    if (schedule_.most_displacement > 0 && motion > schedule_.most_displacement) return out;
    const double least = steady_force * schedule_.force_tolerance * force_scale_;
    const bool flows = way.is_steady(motion, place.fault, elastic_motion_, least);
    if (elastic_motion_ > 0 && flows) return out;
    viscosity = creep::relax(viscosity, solves);
  }
}

/// Tries the consistent tangent, then tangents with ever more of the elastic stiffness, then creep. Soil at its tensile
/// strength, such as placed soil without stress, has no tangent of its own.
template <int D>
CoupledOutcome CoupledNewton<D>::balance_somehow(const CoupledPlace<D>& start, const CoupledTarget& target,
                                                 std::vector<double>& q, CoupledPlace<D>& place) {
  const std::vector<double> first_q = q, first_head = place.head;
  CoupledOutcome all;
  // A tangent that was needed before is tried first, and a smaller one after it has served.
  const std::size_t from = needed_;
  // In a stage with a duration a shorter step costs less than creep.
  const std::size_t ways = viscosities.size() + (schedule_.duration > 0 ? 0 : 1);
  for (std::size_t v = std::min(from, ways - 1); v < ways; ++v) {
    q = first_q;
    place.head = first_head;
    CoupledOutcome out =
        v < viscosities.size() ? balance(start, target, q, place, viscosities[v]) : creep(start, target, q, place);
    out.iterations += all.iterations;
    all = out;
    if (all.converged) {
      needed_ = v == from && v > 0 ? v - 1 : v;
      return all;
    }
    has_factors_ = false;  // they are those of a place that is no solution
  }
  return all;
}

template <int D>
CoupledOutcome CoupledNewton<D>::solve(const CoupledPlace<D>& start, const CoupledConditions& conditions,
                                       std::vector<FaceState>& face, std::vector<double>& q, CoupledPlace<D>& place) {
  CoupledOutcome all;
  for (int i = 0; i < most_face_changes; ++i) {
    const CoupledTarget target = make_target(conditions, face, place);
    CoupledOutcome out = balance_somehow(start, target, q, place);
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
