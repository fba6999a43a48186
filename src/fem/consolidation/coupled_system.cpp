// SPDX-License-Identifier: MIT
// Equilibrium and continuity of pore water as one symmetric system (T26.5), where the soil is saturated and elastic.
#include "fem/consolidation/coupled_system.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "fem/solid/softening.hpp"
#include "material/every_law.hpp"

namespace talus::fem {
namespace {

constexpr double rounding = 1e-14;  ///< of the water in the soil

}  // namespace

template <int D>
CoupledSystem<D>::CoupledSystem(const ConsolidationModel<D>& model, int threads)
    : model_(model),
      solid_(*model.solid),
      flow_(*model.flow),
      assembly_(solid_, make_laws(*model.solid, model.strength_factor), threads,
                {model.strength_factor, model.is_jacking}),
      constant_pore_(solid_.pore) {
  if (model.flow->mesh->elements.size() != model.solid->mesh->elements.size())
    throw Error(ExitCode::internal_error, "consolidation needs the same elements for soil and water");
  couple();
  if constexpr (D == 2) couple_joints();
  add_drains();
  make_pattern();
  solver_.emplace(column_start_, row_, threads);
}

/// Integrates N_A div N_i over the elements with soil and water; quadratic, so that the points of the solid are exact.
template <int D>
void CoupledSystem<D>::couple() {
  std::vector<int> flow_element(model_.flow->mesh->elements.size(), -1);
  for (std::size_t f = 0; f < flow_.elements.size(); ++f)
    flow_element[static_cast<std::size_t>(flow_.elements[f])] = static_cast<int>(f);
  for (std::size_t k = 0; k < solid_.mesh.elements.size(); ++k) {
    const auto e = static_cast<std::size_t>(solid_.mesh.linear_element[k]);
    if (flow_element[e] < 0) continue;
    Couple& c = couples_.emplace_back();
    c.solid = k;
    c.flow = static_cast<std::size_t>(flow_element[e]);
    for (std::size_t a = 0; a < corners; ++a)
      c.node[a] = flow_.unknown_of_node[static_cast<std::size_t>(model_.flow->mesh->elements[e][a])];
    for (std::size_t a = 0; a < Quadratic<D>::nodes; ++a)
      for (std::size_t d = 0; d < D; ++d)
        c.unknown[a * D + d] = solid_.nodes[static_cast<std::size_t>(solid_.mesh.elements[k][a])].unknown[d];
    for (std::size_t q = 0; q < Quadratic<D>::points; ++q) {
      const auto l = find_barycentric<D>(q);
      const auto g = find_gradients<D>(l, solid_.gradients[k]);
      const double w = solid_.mesh.weights[k * Quadratic<D>::points + q];
      for (std::size_t a = 0; a < Quadratic<D>::nodes; ++a) {
        const auto& axes = solid_.nodes[static_cast<std::size_t>(solid_.mesh.elements[k][a])].axes;
        for (std::size_t d = 0; d < D; ++d)
          for (std::size_t i = 0; i < corners; ++i) c.rate[i][a * D + d] += w * l[i] * dot(g[a], axes[d]);
      }
    }
  }
}

/// The water in a joint has the pressure of the soil beside it: N_A at the joint, and the volume of its opening.
template <int D>
void CoupledSystem<D>::couple_joints() {
  if constexpr (D == 2) {
    const auto& wet = *model_.flow->mesh;
    for (const Joint& joint : solid_.springs.joints) {
      if (joint.is_section) continue;
      const auto k = static_cast<std::size_t>(joint.element);
      const auto e = static_cast<std::size_t>(solid_.mesh.linear_element[k]);
      if (wet.element_region[e] == mesh::empty_region) continue;
      const auto& nodes = solid_.mesh.elements[k];
      const auto local = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), joint.node) - nodes.begin());
      std::array<std::size_t, 2> ends{local, local};
      if (local >= corners)
        for (std::size_t i = 0; i < 2; ++i) ends[i] = static_cast<std::size_t>(Quadratic<2>::edges[local - corners][i]);
      JointCouple& c = joints_.emplace_back();
      c.region = wet.element_region[e];
      c.weight = local < corners ? std::array{1.0, 0.0} : std::array{0.5, 0.5};
      for (std::size_t a = 0; a < 2; ++a)
        c.node[a] = flow_.unknown_of_node[static_cast<std::size_t>(wet.elements[e][ends[a]])];
      c.unknown = joint.unknown;
      for (const double opening : joint.opening) c.rate.push_back(joint.weight * opening);
    }
    joint_pressure_.resize(joints_.size());
  }
}

template <int D>
void CoupledSystem<D>::add_drains() {
  if (model_.drains.empty()) return;
  const auto& mesh = *model_.flow->mesh;
  for (const int e : flow_.elements) {
    const DrainSink& drain = model_.drains[static_cast<std::size_t>(e)];
    if (drain.rate == 0) continue;
    for (const int node : mesh.elements[static_cast<std::size_t>(e)])
      drains_.push_back({static_cast<std::size_t>(flow_.unknown_of_node[static_cast<std::size_t>(node)]),
                         drain.rate * mesh.volumes[static_cast<std::size_t>(e)] / (D + 1), drain.head - flow_.datum});
  }
}

template <int D>
void CoupledSystem<D>::make_pattern() {
  const int first = solid_.unknowns;
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(unknowns()));
  const auto copy = [&](const std::vector<int>& start, const std::vector<int>& row, int offset) {
    for (std::size_t j = 0; j + 1 < start.size(); ++j)
      for (int k = start[j]; k < start[j + 1]; ++k)
        columns[j + static_cast<std::size_t>(offset)].push_back(row[static_cast<std::size_t>(k)] + offset);
  };
  copy(solid_.column_start, solid_.row, 0);
  copy(flow_.column_start, flow_.row, first);
  for (const Couple& c : couples_)
    for (const int node : c.node)
      for (const int u : c.unknown) {
        if (u < 0) continue;
        columns[static_cast<std::size_t>(first) + static_cast<std::size_t>(node)].push_back(u);
        columns[static_cast<std::size_t>(u)].push_back(first + node);
      }
  for (const JointCouple& c : joints_)
    for (const int node : c.node)
      for (const int u : c.unknown) {
        columns[static_cast<std::size_t>(first) + static_cast<std::size_t>(node)].push_back(u);
        columns[static_cast<std::size_t>(u)].push_back(first + node);
      }
  column_start_.assign(1, 0);
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    row_.insert(row_.end(), column.begin(), column.end());
    column_start_.push_back(static_cast<int>(row_.size()));
  }
  const auto find_slot = [&](int i, int j) {
    const auto begin = row_.begin() + column_start_[static_cast<std::size_t>(j)],
               end = row_.begin() + column_start_[static_cast<std::size_t>(j) + 1];
    return static_cast<int>(std::lower_bound(begin, end, i) - row_.begin());
  };
  const auto find_slots = [&](const std::vector<int>& start, const std::vector<int>& row, int offset) {
    std::vector<int> slots;
    for (std::size_t j = 0; j + 1 < start.size(); ++j)
      for (int k = start[j]; k < start[j + 1]; ++k)
        slots.push_back(find_slot(row[static_cast<std::size_t>(k)] + offset, static_cast<int>(j) + offset));
    return slots;
  };
  solid_slots_ = find_slots(solid_.column_start, solid_.row, 0);
  flow_slots_ = find_slots(flow_.column_start, flow_.row, first);
  for (int j = 0; j < flow_.size(); ++j) diagonal_.push_back(find_slot(first + j, first + j));
  for (Couple& c : couples_)
    for (std::size_t a = 0; a < corners; ++a)
      for (std::size_t i = 0; i < locals; ++i) {
        const int u = c.unknown[i];
        c.above[a * locals + i] = u < 0 ? -1 : find_slot(u, first + c.node[a]);
        c.below[a * locals + i] = u < 0 ? -1 : find_slot(first + c.node[a], u);
      }
  for (JointCouple& c : joints_)
    for (const int node : c.node)
      for (const int u : c.unknown) {
        c.above.push_back(find_slot(u, first + node));
        c.below.push_back(find_slot(first + node, u));
      }
}

/// Sets χp at the integration points of the solid, and what its derivatives need at the corners.
template <int D>
void CoupledSystem<D>::set_pores(const std::vector<double>& head) {
  const auto& mesh = *model_.flow->mesh;
  symmetric_ = true;
  const auto find_acting = [&](int region, double s, const auto& water) {
    return s <= 0 ? material::CurvePoint<double>{s, 1}
           : !model_.suction_stress
               ? material::CurvePoint<double>{water.saturation * s, water.saturation + water.slope * s}
               : model_.suction_stress(region, s);
  };
  for (Couple& c : couples_) {
    const auto e = static_cast<std::size_t>(flow_.elements[c.flow]);
    const int region = mesh.element_region[e];
    std::array<double, corners> stress{};
    for (std::size_t a = 0; a < corners; ++a) {
      const auto u = static_cast<std::size_t>(c.node[a]);
      const double s = flow_.suction(u, head[u]);
      const auto water = material::find_water(model_.flow->soils[static_cast<std::size_t>(region)].retention, s);
      const material::CurvePoint<double> acts = find_acting(region, s, water);
      stress[a] = acts.value;
      c.bishop[a] = acts.slope;
      c.share[a] = water.saturation;
      c.slope[a] = water.slope;
      symmetric_ = symmetric_ && acts.slope == water.saturation;
    }
    for (std::size_t q = 0; q < Quadratic<D>::points; ++q) {
      const auto l = find_barycentric<D>(q);
      double sum = constant_pore_[c.solid][q];
      for (std::size_t a = 0; a < corners; ++a) sum += l[a] * stress[a];
      solid_.pore[c.solid][q] = sum;
    }
  }
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    JointCouple& c = joints_[j];
    joint_pressure_[j] = 0;
    for (std::size_t a = 0; a < c.node.size(); ++a) {
      const auto u = static_cast<std::size_t>(c.node[a]);
      const double s = flow_.suction(u, head[u]);
      const auto water = material::find_water(model_.flow->soils[static_cast<std::size_t>(c.region)].retention, s);
      const material::CurvePoint<double> acts = find_acting(c.region, s, water);
      joint_pressure_[j] += c.weight[a] * acts.value;
      c.bishop[a] = acts.slope;
      c.share[a] = water.saturation;
      c.slope[a] = water.slope;
      symmetric_ = symmetric_ && acts.slope == water.saturation;
    }
  }
}

template <int D>
void CoupledSystem<D>::add_joint_pores(std::vector<double>& force) const {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (std::size_t i = 0; i < joints_[j].unknown.size(); ++i)
      force[static_cast<std::size_t>(joints_[j].unknown[i])] += joint_pressure_[j] * joints_[j].rate[i];
}

template <int D>
double CoupledSystem<D>::find_pore_force(const std::vector<double>& head) {
  set_pores(head);
  std::vector<double> force(static_cast<std::size_t>(solid_.unknowns), 0);
  for (const Couple& c : couples_)
    for (std::size_t q = 0; q < Quadratic<D>::points; ++q) {
      const auto g = find_gradients<D>(find_barycentric<D>(q), solid_.gradients[c.solid]);
      const double w = solid_.mesh.weights[c.solid * Quadratic<D>::points + q] * solid_.pore[c.solid][q];
      for (std::size_t i = 0; i < locals; ++i)
        if (c.unknown[i] >= 0) {
          const auto& node = solid_.nodes[static_cast<std::size_t>(solid_.mesh.elements[c.solid][i / D])];
          force[static_cast<std::size_t>(c.unknown[i])] += w * dot(g[i / D], node.axes[i % D]);
        }
    }
  add_joint_pores(force);
  double sum = 0;
  for (const double f : force) sum += f * f;
  return std::sqrt(sum);
}

/// Adds what the nodes store since the start of the step: S_w div u, and water in the pores.
template <int D>
void CoupledSystem<D>::add_storage(const CoupledPlace<D>& start, const std::vector<double>& q, CoupledPlace<D>& place) {
  const double weight = model_.flow->unit_weight;
  for (const Couple& c : couples_)
    for (std::size_t a = 0; a < corners; ++a) {
      double squeeze = 0;
      for (std::size_t i = 0; i < locals; ++i)
        if (c.unknown[i] >= 0) squeeze += c.rate[a][i] * q[static_cast<std::size_t>(c.unknown[i])];
      const auto u = static_cast<std::size_t>(c.node[a]);
      place.water[u] -= c.share[a] * squeeze;
      place.volume += std::abs(c.share[a] * squeeze);
      capacity_[u] -= weight * c.slope[a] * squeeze;
    }
  for (const JointCouple& c : joints_) {
    double opened = 0;
    for (std::size_t i = 0; i < c.unknown.size(); ++i) opened += c.rate[i] * q[static_cast<std::size_t>(c.unknown[i])];
    for (std::size_t a = 0; a < c.node.size(); ++a) {
      const auto u = static_cast<std::size_t>(c.node[a]);
      place.water[u] -= c.weight[a] * c.share[a] * opened;
      place.volume += std::abs(c.weight[a] * c.share[a] * opened);
      capacity_[u] -= weight * c.weight[a] * c.slope[a] * opened;
    }
  }
  for (const auto& store : flow_.stores) {
    const auto u = static_cast<std::size_t>(store.unknown);
    const auto& soil = model_.flow->soils[static_cast<std::size_t>(store.soil)];
    const auto now = flow_.find_content(soil, flow_.suction(u, place.head[u])),
               old = flow_.find_content(soil, flow_.suction(u, start.head[u]));
    place.water[u] -= store.volume * (now.value - old.value);
    place.volume += std::abs(store.volume * (now.value - old.value));
    place.rounding += rounding * store.volume * std::abs(now.value);
    capacity_[u] -= store.volume * now.slope * weight;
  }
}

template <int D>
void CoupledSystem<D>::add_flow(const CoupledTarget& target, bool with_matrix, CoupledPlace<D>& place) {
  StepInput input;
  input.sink_rates = target.sink_rates;
  NodalSums sums = sum_over_elements(flow_, place.head, input, with_matrix);
  for (const Drain& drain : drains_) {
    sums.outflow[drain.unknown] += drain.rate * (place.head[drain.unknown] - drain.head);
    if (with_matrix) sums.jacobian[static_cast<std::size_t>(flow_.diagonal[drain.unknown])] += drain.rate;
  }
  if (with_matrix) {
    flow_matrix_ = std::move(sums.jacobian);
    symmetric_ = symmetric_ && sums.symmetric;
  }
  for (std::size_t u = 0; u < place.head.size(); ++u) {
    place.inflow[u] = target.supply[u] - sums.outflow[u];
    place.water[u] += target.dt * place.inflow[u] + (target.entered.empty() ? 0 : target.entered[u]);
    place.volume += std::abs(target.dt * place.inflow[u]);
  }
}

template <int D>
void CoupledSystem<D>::evaluate(const CoupledPlace<D>& start, const std::vector<double>& q, const CoupledTarget& target,
                                bool with_matrix, CoupledPlace<D>& place) {
  set_pores(place.head);
  assembly_.evaluate(start.solid, q, with_matrix, place.solid, place.sums);
  add_joint_pores(place.sums.force);
  place.force.resize(q.size());
  place.fault = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    place.force[i] = target.force[i] - place.sums.force[i];
    place.fault += place.force[i] * place.force[i];
  }
  place.fault = std::sqrt(place.fault);
  place.water.assign(place.head.size(), 0);
  place.inflow.assign(place.head.size(), 0);
  capacity_.assign(place.head.size(), 0);
  place.leak = place.volume = place.rounding = 0;
  add_storage(start, q, place);
  if (target.dt > 0) add_flow(target, with_matrix, place);
  for (std::size_t u = 0; u < place.head.size(); ++u)
    if (!target.fixed[u]) place.leak += std::abs(place.water[u]);
}

template <int D>
const std::vector<double>& CoupledSystem<D>::find_elastic_matrix(const CoupledPlace<D>& place) {
  if (elastic_.empty()) assembly_.find_elastic_matrix(place.solid, elastic_);
  return elastic_;
}

template <int D>
void CoupledSystem<D>::resist(double viscosity, const CoupledPlace<D>& place, const std::vector<double>& q,
                              std::vector<double>& force) {
  const std::vector<double>& matrix = find_elastic_matrix(place);
  for (std::size_t j = 0; j < q.size(); ++j) {  // the matrix is symmetric
    double sum = 0;
    for (int k = solid_.column_start[j]; k < solid_.column_start[j + 1]; ++k)
      sum += matrix[static_cast<std::size_t>(k)] * q[static_cast<std::size_t>(solid_.row[static_cast<std::size_t>(k)])];
    force[j] -= viscosity * sum;
  }
}

template <int D>
bool CoupledSystem<D>::factorise(const CoupledTarget& target, const CoupledPlace<D>& place, double viscosity) {
  const double weight = model_.flow->unit_weight;
  matrix_.assign(row_.size(), 0);
  for (std::size_t k = 0; k < solid_slots_.size(); ++k)
    matrix_[static_cast<std::size_t>(solid_slots_[k])] = place.sums.matrix[k];
  if (viscosity > 0) {
    const std::vector<double>& elastic = find_elastic_matrix(place);
    for (std::size_t k = 0; k < solid_slots_.size(); ++k)
      matrix_[static_cast<std::size_t>(solid_slots_[k])] += viscosity * elastic[k];
  }
  if (target.dt > 0)
    for (std::size_t k = 0; k < flow_slots_.size(); ++k)
      matrix_[static_cast<std::size_t>(flow_slots_[k])] = -weight * target.dt * flow_matrix_[k];
  for (const Couple& c : couples_)
    for (std::size_t a = 0; a < corners; ++a)
      for (std::size_t i = 0; i < locals; ++i) {
        if (c.unknown[i] < 0) continue;
        matrix_[static_cast<std::size_t>(c.above[a * locals + i])] -= weight * c.bishop[a] * c.rate[a][i];
        matrix_[static_cast<std::size_t>(c.below[a * locals + i])] -= weight * c.share[a] * c.rate[a][i];
      }
  for (const JointCouple& c : joints_)
    for (std::size_t a = 0; a < c.node.size(); ++a)
      for (std::size_t i = 0; i < c.unknown.size(); ++i) {
        const std::size_t at = a * c.unknown.size() + i;
        matrix_[static_cast<std::size_t>(c.above[at])] -= weight * c.weight[a] * c.bishop[a] * c.rate[i];
        matrix_[static_cast<std::size_t>(c.below[at])] -= weight * c.weight[a] * c.share[a] * c.rate[i];
      }
  const auto first = static_cast<std::size_t>(solid_.unknowns);
  for (std::size_t u = 0; u < diagonal_.size(); ++u)
    matrix_[static_cast<std::size_t>(diagonal_[u])] -= weight * capacity_[u];
  for (std::size_t j = 0; j + 1 < column_start_.size(); ++j) {
    const bool is_fixed = j >= first && target.fixed[j - first];
    for (int k = column_start_[j]; k < column_start_[j + 1]; ++k) {
      const auto i = static_cast<std::size_t>(row_[static_cast<std::size_t>(k)]);
      if (is_fixed || (i >= first && target.fixed[i - first])) matrix_[static_cast<std::size_t>(k)] = i == j ? -1 : 0;
    }
  }
  if (symmetric_ && place.sums.symmetric && solver_->factorise(matrix_, sparse::Factors::ldlt) &&
      solver_->negative_pivots() == flow_.size())
    return true;
  return solver_->factorise(matrix_, sparse::Factors::lu);
}

template <int D>
double CoupledSystem<D>::find_elastic_motion(const CoupledTarget& target, const CoupledPlace<D>& place) {
  CoupledPlace<D> elastic = place;
  elastic.sums.matrix = find_elastic_matrix(place);
  elastic.sums.symmetric = true;
  elastic.force = solid_.load;
  elastic.water.assign(place.head.size(), 0);
  std::vector<double> change;
  if (!factorise(target, elastic, 0) || !solve(elastic, target.fixed, change)) return 0;
  double largest = 0;
  for (std::size_t i = 0; i < elastic.force.size(); ++i) largest = std::max(largest, std::abs(change[i]));
  return largest;
}

template <int D>
bool CoupledSystem<D>::solve(const CoupledPlace<D>& place, const std::vector<char>& fixed,
                             std::vector<double>& change) {
  change = place.force;
  for (std::size_t u = 0; u < place.water.size(); ++u)
    change.push_back(fixed[u] ? 0 : -model_.flow->unit_weight * place.water[u]);
  return solver_->solve(change);
}

template class CoupledSystem<2>;
template class CoupledSystem<3>;

}  // namespace talus::fem
