// SPDX-License-Identifier: MIT
// Numbering, pattern, stores and sums of the nodal equations of seepage.
#include "fem/seepage/system.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "fem/seepage/seepage.hpp"

namespace talus::fem {

namespace {

template <int D>
void build_pattern(SeepageSystem<D>& s) {
  constexpr std::size_t n = D + 1;
  const auto& mesh = *s.model.mesh;
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(s.size()));
  const auto unknown = [&](int e, std::size_t k) {
    return s.unknown_of_node[static_cast<std::size_t>(mesh.elements[static_cast<std::size_t>(e)][k])];
  };
  for (int e : s.elements) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) columns[static_cast<std::size_t>(unknown(e, j))].push_back(unknown(e, i));
    }
  }
  s.column_start.assign(1, 0);
  for (auto& c : columns) {
    std::sort(c.begin(), c.end());
    c.erase(std::unique(c.begin(), c.end()), c.end());
    s.row.insert(s.row.end(), c.begin(), c.end());
    s.column_start.push_back(static_cast<int>(s.row.size()));
  }
  const auto find_slot = [&](int i, int j) {
    const auto first = s.row.begin() + s.column_start[static_cast<std::size_t>(j)];
    const auto last = s.row.begin() + s.column_start[static_cast<std::size_t>(j) + 1];
    return static_cast<int>(std::lower_bound(first, last, i) - s.row.begin());
  };
  for (int e : s.elements) {
    auto& slots = s.slots.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) slots[i * n + j] = find_slot(unknown(e, i), unknown(e, j));
    }
  }
  for (int i = 0; i < s.size(); ++i) s.diagonal.push_back(find_slot(i, i));
}

template <int D>
void build_stores(SeepageSystem<D>& s) {
  const auto& mesh = *s.model.mesh;
  std::map<std::pair<int, int>, double> volume;
  for (int e : s.elements) {
    const auto el = static_cast<std::size_t>(e);
    for (int node : mesh.elements[el])
      volume[{s.unknown_of_node[static_cast<std::size_t>(node)], mesh.element_region[el]}] +=
          mesh.volumes[el] / (D + 1);
  }
  for (const auto& [key, v] : volume) s.stores.push_back({key.first, key.second, v});
}

}  // namespace

template <int D>
SeepageSystem<D>::SeepageSystem(const SeepageModel<D>& m) : model(m) {
  check_model(m);
  const auto& mesh = *m.mesh;
  unknown_of_node.assign(mesh.nodes.size(), -1);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_region[static_cast<std::size_t>(e)] == mesh::empty_region) continue;
    elements.push_back(e);
    for (int node : mesh.elements[static_cast<std::size_t>(e)]) unknown_of_node[static_cast<std::size_t>(node)] = 0;
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (unknown_of_node[i] < 0) continue;
    unknown_of_node[i] = size();
    node_of_unknown.push_back(static_cast<int>(i));
    elevation.push_back(mesh.nodes[i][static_cast<std::size_t>(m.up)]);
  }
  if (!elevation.empty()) datum = *std::min_element(elevation.begin(), elevation.end());
  for (double& y : elevation) y -= datum;
  build_pattern(*this);
  build_stores(*this);
  build_shares(*this);
}

template <int D>
material::CurvePoint<double> SeepageSystem<D>::find_content(const HydraulicSoil<D>& soil, double s) const {
  const auto w = material::find_water(soil.retention, s);
  const double squeeze = 1 / soil.water_modulus;
  const double skeleton = s < 0 ? soil.skeleton_compressibility * w.saturation : 0;
  return {soil.porosity * w.saturation * (1 - s * squeeze) - skeleton * s,
          soil.porosity * (w.slope * (1 - s * squeeze) - w.saturation * squeeze) - skeleton};
}

template <int D>
std::vector<double> SeepageSystem<D>::find_contents(const std::vector<double>& head) const {
  std::vector<double> contents;
  contents.reserve(stores.size());
  for (const Store& store : stores) {
    const auto u = static_cast<std::size_t>(store.unknown);
    contents.push_back(store.volume *
                       find_content(model.soils[static_cast<std::size_t>(store.soil)], suction(u, head[u])).value);
  }
  return contents;
}

template struct SeepageSystem<2>;
template struct SeepageSystem<3>;

// Sums over the elements: Darcy flow with the mean conductivity of an element, storage, and water uptake by roots
// (T13.3).

namespace {

/// Integration rule of second degree with D+1 equal weights: barycentric coordinate of the nearest node, and of the
/// others.
template <int D>
inline constexpr double near_weight = D == 2 ? 2.0 / 3 : 0.58541019662496845;
template <int D>
inline constexpr double far_weight = D == 2 ? 1.0 / 6 : 0.13819660112501051;

/// Returns the suctions at the points of that rule; point i is the one nearest to node i.
template <int D>
std::array<double, D + 1> find_suctions(const std::array<double, D + 1>& of_nodes) {
  double sum = 0;
  for (const double s : of_nodes) sum += s;
  std::array<double, D + 1> suctions;
  for (std::size_t g = 0; g <= D; ++g) suctions[g] = far_weight<D> * sum + (near_weight<D> - far_weight<D>)*of_nodes[g];
  return suctions;
}

template <int D>
void add_storage(const SeepageSystem<D>& system, const std::vector<double>& head, const StepInput& input,
                 NodalSums& sums) {
  for (std::size_t k = 0; k < system.stores.size(); ++k) {
    const auto& store = system.stores[k];
    const auto u = static_cast<std::size_t>(store.unknown);
    const auto content =
        system.find_content(system.model.soils[static_cast<std::size_t>(store.soil)], system.suction(u, head[u]));
    const double now = store.volume * content.value, old = (*input.old_contents)[k];
    sums.outflow[u] += (now - old) / input.dt;
    sums.storage_rate += (now - old) / input.dt;
    sums.rounding += (std::abs(now) + std::abs(old)) / input.dt;
    const double capacity = -store.volume * content.slope * system.model.unit_weight / input.dt;
    sums.weight[u] += capacity;
    if (!sums.jacobian.empty()) sums.jacobian[static_cast<std::size_t>(system.diagonal[u])] += capacity;
  }
}

/// Adds free drainage: outflow under a unit gradient.
template <int D>
void add_drainage(const SeepageSystem<D>& system, const std::vector<double>& head, const StepInput& input,
                  NodalSums& sums) {
  sums.drained.assign(system.shares.size(), 0);
  for (std::size_t b = 0; b < system.shares.size(); ++b) {
    if (system.model.boundaries[b].kind != HydraulicKind::free_drainage) continue;
    for (const BoundaryShare& share : system.shares[b]) {
      const auto u = static_cast<std::size_t>(share.unknown);
      const auto& soil = system.model.soils[static_cast<std::size_t>(share.soil)];
      const auto k = find_relative(soil, system.suction(u, head[u]), input);
      sums.outflow[u] += share.downward * k.value;
      sums.drained[b] += share.downward * k.value;
      sums.rounding += share.downward * k.value;
      if (!sums.jacobian.empty())
        sums.jacobian[static_cast<std::size_t>(system.diagonal[u])] -=
            share.downward * k.slope * system.model.unit_weight;
    }
  }
}

/// Adds the water uptake by roots (T16.2). Its slope by the head is negative where oxygen stress begins. Picard's
/// method leaves it out, since its matrix must stay positive definite.
template <int D>
void add_uptake(const SeepageSystem<D>& system, const std::vector<double>& head, const StepInput& input,
                NodalSums& sums) {
  sums.drawn.assign(system.model.sinks.size(), 0);
  for (std::size_t q = 0; q < system.model.sinks.size(); ++q) {
    const RootSink& sink = system.model.sinks[q];
    const double rate = input.sink_rates[q];
    if (rate == 0) continue;
    for (std::size_t u = 0; u < head.size(); ++u) {
      const double asked = rate * sink.weights[static_cast<std::size_t>(system.node_of_unknown[u])];
      if (asked == 0) continue;
      const double suction = system.suction(u, head[u]);
      auto share = sink.reduction.evaluate(suction);
      if (input.chord > 0)
        share.slope = (sink.reduction.evaluate(suction + input.chord).value -
                       sink.reduction.evaluate(suction - input.chord).value) /
                      (2 * input.chord);
      sums.outflow[u] += asked * share.value;
      sums.drawn[q] += asked * share.value;
      sums.rounding += asked * share.value;
      if (sums.jacobian.empty() || share.slope == 0) continue;
      if (input.hold_conductivity && share.slope > 0) continue;
      if (!input.hold_conductivity) sums.symmetric = false;
      sums.jacobian[static_cast<std::size_t>(system.diagonal[u])] -= asked * share.slope * system.model.unit_weight;
    }
  }
}

}  // namespace

template <int D>
std::vector<double> find_sink_rates(const SeepageModel<D>& model, double time) {
  std::vector<double> rates;
  for (const RootSink& sink : model.sinks) rates.push_back(sink.rate.at(time));
  return rates;
}

template <int D>
material::CurvePoint<double> find_relative(const HydraulicSoil<D>& soil, double suction, const StepInput& input) {
  const auto at = [&](double s) {
    const auto water = material::find_water(soil.retention, input.stretch * s);
    auto k = material::find_relative_conductivity(soil.relative, water);
    k.slope *= input.stretch;
    if (k.value < input.smallest_conductivity) k = {input.smallest_conductivity, 0};
    return k;
  };
  auto k = at(suction);
  if (input.hold_conductivity)
    k.slope = 0;
  else if (input.chord > 0)
    k.slope = (at(suction + input.chord).value - at(suction - input.chord).value) / (2 * input.chord);
  return k;
}

template <int D>
MeanConductivity<D> find_mean_conductivity(const HydraulicSoil<D>& soil, const std::array<double, D + 1>& suction,
                                           const StepInput& input) {
  constexpr std::size_t n = D + 1;
  MeanConductivity<D> r;
  const auto suctions = find_suctions<D>(suction);
  for (std::size_t g = 0; g < n; ++g) {
    const auto k = find_relative(soil, suctions[g], input);
    r.relative += k.value / n;
    for (std::size_t j = 0; j < n; ++j) r.slope[j] += k.slope / n * (j == g ? near_weight<D> : far_weight<D>);
  }
  return r;
}

template <int D>
double find_mean_saturation(const HydraulicSoil<D>& soil, const std::array<double, D + 1>& suction) {
  double mean = 0;
  for (const double s : find_suctions<D>(suction)) mean += material::saturation(soil.retention, s) / (D + 1);
  return mean;
}

template <int D>
NodalSums sum_over_elements(const SeepageSystem<D>& system, const std::vector<double>& head, const StepInput& input,
                            bool with_jacobian) {
  constexpr std::size_t n = D + 1;
  const auto& mesh = *system.model.mesh;
  NodalSums sums;
  sums.outflow.assign(head.size(), 0);
  sums.weight.assign(head.size(), 0);
  if (with_jacobian) sums.jacobian.assign(system.row.size(), 0);
  for (std::size_t q = 0; q < system.elements.size(); ++q) {
    const auto e = static_cast<std::size_t>(system.elements[q]);
    const auto& soil = system.model.soils[static_cast<std::size_t>(mesh.element_region[e])];
    std::array<std::size_t, n> u;
    std::array<double, n> suction;
    for (std::size_t i = 0; i < n; ++i) {
      u[i] = static_cast<std::size_t>(system.unknown_of_node[static_cast<std::size_t>(mesh.elements[e][i])]);
      suction[i] = system.suction(u[i], head[u[i]]);
    }
    // ∇N of the nodes, and ∇H from differences, so that a constant head gives exactly zero
    std::array<std::array<double, D>, n> shape{};
    std::array<double, D> gradient{};
    for (std::size_t k = 1; k < n; ++k) {
      for (std::size_t d = 0; d < D; ++d) {
        shape[k][d] = mesh.gradients[e][(k - 1) * D + d];
        shape[0][d] -= shape[k][d];
        gradient[d] += shape[k][d] * (head[u[k]] - head[u[0]]);
      }
    }
    const auto conductivity = find_mean_conductivity<D>(soil, suction, input);
    std::array<double, n> flow;  // per unit of relative conductivity
    for (std::size_t i = 0; i < n; ++i) {
      flow[i] = 0;
      double magnitude = 0, diagonal = 0;
      for (std::size_t d = 0; d < D; ++d) {
        const double k = mesh.volumes[e] * soil.conductivity[d];
        flow[i] += k * shape[i][d] * gradient[d];
        magnitude += k * std::abs(shape[i][d] * gradient[d]);
        diagonal += k * shape[i][d] * shape[i][d];
      }
      if (soil.cross_conductivity != 0) {
        const double k = mesh.volumes[e] * soil.cross_conductivity;
        flow[i] += k * (shape[i][0] * gradient[1] + shape[i][1] * gradient[0]);
        magnitude += std::abs(k) * (std::abs(shape[i][0] * gradient[1]) + std::abs(shape[i][1] * gradient[0]));
        diagonal += 2 * k * shape[i][0] * shape[i][1];
      }
      sums.outflow[u[i]] += conductivity.relative * flow[i];
      sums.weight[u[i]] += conductivity.relative * diagonal;
      sums.rounding += conductivity.relative * (magnitude + diagonal * std::abs(head[u[i]]));
    }
    if (!with_jacobian) continue;
    for (std::size_t j = 0; j < n; ++j) {
      const double d_relative = -conductivity.slope[j] * system.model.unit_weight;  // derivative by the head of node j
      if (d_relative != 0) sums.symmetric = false;
      for (std::size_t i = 0; i < n; ++i) {
        double a = 0;
        for (std::size_t d = 0; d < D; ++d) a += soil.conductivity[d] * shape[i][d] * shape[j][d];
        a += soil.cross_conductivity * (shape[i][0] * shape[j][1] + shape[i][1] * shape[j][0]);
        sums.jacobian[static_cast<std::size_t>(system.slots[q][i * n + j])] +=
            conductivity.relative * mesh.volumes[e] * a + d_relative * flow[i];
      }
    }
  }
  add_drainage(system, head, input, sums);
  add_uptake(system, head, input, sums);
  if (input.dt > 0) add_storage(system, head, input, sums);
  return sums;
}

template std::vector<double> find_sink_rates<2>(const SeepageModel<2>&, double);
template std::vector<double> find_sink_rates<3>(const SeepageModel<3>&, double);
template MeanConductivity<2> find_mean_conductivity<2>(const HydraulicSoil<2>&, const std::array<double, 3>&,
                                                       const StepInput&);
template MeanConductivity<3> find_mean_conductivity<3>(const HydraulicSoil<3>&, const std::array<double, 4>&,
                                                       const StepInput&);
template double find_mean_saturation<2>(const HydraulicSoil<2>&, const std::array<double, 3>&);
template double find_mean_saturation<3>(const HydraulicSoil<3>&, const std::array<double, 4>&);
template NodalSums sum_over_elements<2>(const SeepageSystem<2>&, const std::vector<double>&, const StepInput&, bool);
template NodalSums sum_over_elements<3>(const SeepageSystem<3>&, const std::vector<double>&, const StepInput&, bool);

}  // namespace talus::fem
