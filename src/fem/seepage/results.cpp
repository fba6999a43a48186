// SPDX-License-Identifier: MIT
// Pressures, velocities, discharges, wet faces and the water table of a solution.
#include "fem/seepage/newton.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"

namespace talus::fem {

// Contour of zero pressure, followed through the triangles that it crosses.

namespace {

using Edge = std::pair<int, int>;
using Point = std::array<double, 2>;

struct Crossings {
  const mesh::Mesh<2>& mesh;
  const std::vector<double>& pressure;

  bool is_wet(int node) const { return pressure[static_cast<std::size_t>(node)] <= 0; }
  Point find_point(const Edge& edge) const {
    const auto a = static_cast<std::size_t>(edge.first), b = static_cast<std::size_t>(edge.second);
    const double t = pressure[a] / (pressure[a] - pressure[b]);
    return {mesh.nodes[a][0] + t * (mesh.nodes[b][0] - mesh.nodes[a][0]),
            mesh.nodes[a][1] + t * (mesh.nodes[b][1] - mesh.nodes[a][1])};
  }
};

void append(std::vector<Point>& line, const Point& p) {
  if (line.empty() || std::hypot(p[0] - line.back()[0], p[1] - line.back()[1]) > 1e-12) line.push_back(p);
}

}  // namespace

std::vector<std::vector<Point>> find_water_table(const mesh::Mesh<2>& mesh, const std::vector<double>& pressure) {
  const Crossings crossings{mesh, pressure};
  std::map<Edge, std::vector<Edge>> next;  // the one or two edges with which the line continues from an edge
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    std::vector<Edge> crossed;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = mesh.elements[e][k], b = mesh.elements[e][(k + 1) % 3];
      if (crossings.is_wet(a) != crossings.is_wet(b)) crossed.emplace_back(std::min(a, b), std::max(a, b));
    }
    if (crossed.size() != 2) continue;
    next[crossed[0]].push_back(crossed[1]);
    next[crossed[1]].push_back(crossed[0]);
  }
  std::vector<std::vector<Point>> lines;
  std::map<Edge, bool> used;
  const auto follow = [&](Edge edge) {
    std::vector<Point> line;
    const Edge first = edge;
    for (bool more = true; more;) {
      used[edge] = true;
      append(line, crossings.find_point(edge));
      more = false;
      for (const Edge& other : next[edge]) {
        if (used[other]) continue;
        edge = other;
        more = true;
        break;
      }
    }
    const auto& ends = next[edge];
    if (edge != first && ends.size() == 2 && next[first].size() == 2 &&
        std::find(ends.begin(), ends.end(), first) != ends.end())
      line.push_back(line.front());
    if (line.size() > 1 && line.front()[0] > line.back()[0]) std::reverse(line.begin(), line.end());
    if (line.size() > 1) lines.push_back(line);
  };
  for (const auto& [edge, others] : next) {
    if (others.size() == 1 && !used[edge]) follow(edge);
  }
  for (const auto& [edge, others] : next) {
    if (!used[edge]) follow(edge);
  }
  return lines;
}

namespace {

/// Adds the flow through each boundary. The residual of a node's equation is the flow through its boundaries: given
/// fluxes are assigned to theirs, infiltrating rain in proportion to what each boundary offers, and the rest to the
/// node's owner.
template <int D>
void add_discharges(const SeepageSystem<D>& system, const NodalSums& sums, const std::vector<NodeCondition>& conditions,
                    double time, SeepageResult<D>& result, const std::vector<FaceState>& face) {
  const auto& boundaries = system.model.boundaries;
  for (const auto& b : boundaries) result.discharges.emplace_back().name = b.name;
  const auto book = [&](std::size_t b, double into) {
    (into > 0 ? result.discharges[b].inflow : result.discharges[b].outflow) += std::abs(into);
  };
  for (std::size_t b = 0; b < boundaries.size(); ++b) {
    if (boundaries[b].kind == HydraulicKind::free_drainage) result.discharges[b].outflow += sums.drained[b];
    const bool rain = boundaries[b].kind == HydraulicKind::rain;
    if (!rain && boundaries[b].kind != HydraulicKind::flux) continue;
    const double value = boundaries[b].value_at(time);
    for (const BoundaryShare& share : system.shares[b]) {
      const auto u = static_cast<std::size_t>(share.unknown);
      const double flux =
          value * (boundaries[b].measure == FluxMeasure::vertical ? std::max(0.0, share.horizontal) : share.area);
      if (!rain) {
        book(b, flux);
        continue;
      }
      const NodeCondition& c = conditions[u];
      if (c.fixed) {  // under water: all rain runs off
        result.discharges[b].runoff += std::max(0.0, flux);
        continue;
      }
      const double enters = face[u] == FaceState::open ? c.offered : sums.outflow[u] - c.given;
      const bool shared = enters * c.offered > 0;  // otherwise water flows out during the rain
      const double own = shared ? flux * enters / c.offered : 0;
      book(b, own);
      if (flux > 0) result.discharges[b].runoff += flux - own;
    }
  }
  for (std::size_t u = 0; u < conditions.size(); ++u) {
    const NodeCondition& c = conditions[u];
    if (c.carried == 0 || c.owner < 0 || c.fixed) continue;
    const double enters = face[u] == FaceState::open ? c.offered : sums.outflow[u] - c.given;
    if (!(enters * c.offered > 0)) continue;
    const double own = c.carried * enters / c.offered;
    book(static_cast<std::size_t>(c.owner), own);
    result.discharges[static_cast<std::size_t>(c.owner)].runoff -= own;
  }
  for (std::size_t u = 0; u < conditions.size(); ++u) {
    const NodeCondition& c = conditions[u];
    const bool held = c.fixed || face[u] == FaceState::wet || face[u] == FaceState::dry;
    if (!held || c.owner < 0) continue;
    const double reaction = sums.outflow[u] - c.given;
    if (c.fixed || !(reaction * c.offered > 0)) book(static_cast<std::size_t>(c.owner), reaction);
  }
  for (const Discharge& d : result.discharges) {
    result.inflow += d.inflow;
    result.outflow += d.outflow;
  }
}

template <int D>
void add_exits(const SeepageSystem<D>& system, const std::vector<FaceState>& face, SeepageResult<D>& result) {
  const auto up = static_cast<std::size_t>(system.model.up);
  for (std::size_t b = 0; b < system.shares.size(); ++b) {
    const auto kind = system.model.boundaries[b].kind;
    if (kind != HydraulicKind::seepage_face && kind != HydraulicKind::rain && kind != HydraulicKind::reservoir)
      continue;
    FaceExtent<D> extent{system.model.boundaries[b].name, {}, {}};
    bool any = false;
    for (const BoundaryShare& share : system.shares[b]) {
      const auto u = static_cast<std::size_t>(share.unknown);
      if (face[u] != FaceState::wet) continue;
      const auto& x = system.model.mesh->nodes[static_cast<std::size_t>(system.node_of_unknown[u])];
      if (!any || x[up] > extent.highest[up]) extent.highest = x;
      if (!any || x[up] < extent.lowest[up]) extent.lowest = x;
      any = true;
    }
    if (any) result.exits.push_back(extent);
  }
}

}  // namespace

template <int D>
SeepageResult<D> make_flow_result(const SeepageSystem<D>& system, const SeepageState& state, const NodalSums& sums,
                                  const std::vector<NodeCondition>& conditions, double time, const StepInput& input) {
  SeepageResult<D> r;
  r.time = time;
  add_discharges(system, sums, conditions, time, r, state.face);
  for (std::size_t q = 0; q < sums.drawn.size(); ++q) {
    const RootSink& sink = system.model.sinks[q];
    double covered = 0;
    for (int node : system.node_of_unknown) covered += sink.weights[static_cast<std::size_t>(node)];
    r.uptakes.push_back({sink.name, covered * input.sink_rates[q], sums.drawn[q]});
    r.transpired += sums.drawn[q];
  }
  r.storage_rate = sums.storage_rate;
  r.balance_error = r.inflow - r.outflow - r.transpired - r.storage_rate;
  return r;
}

template <int D>
void add_fields(const SeepageSystem<D>& system, const SeepageState& state, const StepInput& input,
                SeepageResult<D>& r) {
  const auto& mesh = *system.model.mesh;
  r.head = to_nodes(system, state.head);
  r.pressure.assign(mesh.nodes.size(), 0);
  r.face.assign(mesh.nodes.size(), FaceState::none);
  for (std::size_t u = 0; u < state.head.size(); ++u) {
    const auto node = static_cast<std::size_t>(system.node_of_unknown[u]);
    r.pressure[node] = system.suction(u, state.head[u]);
    r.face[node] = state.face[u];
  }
  r.saturation.assign(mesh.elements.size(), 0);
  r.velocity.assign(mesh.elements.size(), {});
  for (int element : system.elements) {
    const auto e = static_cast<std::size_t>(element);
    const auto& nodes = mesh.elements[e];
    const auto& soil = system.model.soils[static_cast<std::size_t>(mesh.element_region[e])];
    std::array<double, D + 1> suction;
    for (std::size_t k = 0; k <= D; ++k) suction[k] = r.pressure[static_cast<std::size_t>(nodes[k])];
    const double relative = find_mean_conductivity<D>(soil, suction, input).relative;
    r.saturation[e] = find_mean_saturation<D>(soil, suction);
    std::array<double, D> gradient{};
    for (std::size_t d = 0; d < D; ++d) {
      for (std::size_t k = 1; k <= D; ++k)
        gradient[d] += mesh.gradients[e][(k - 1) * D + d] *
                       (r.head[static_cast<std::size_t>(nodes[k])] - r.head[static_cast<std::size_t>(nodes[0])]);
      r.velocity[e][d] = -soil.conductivity[d] * relative * gradient[d];
    }
    r.velocity[e][0] -= soil.cross_conductivity * relative * gradient[1];
    r.velocity[e][1] -= soil.cross_conductivity * relative * gradient[0];
  }
  add_exits(system, state.face, r);
  if constexpr (D == 2) r.water_table = find_water_table(mesh, r.pressure);
}

template <int D>
std::vector<double> to_unknowns(const SeepageSystem<D>& system, const std::vector<double>& node_heads) {
  if (node_heads.size() != system.unknown_of_node.size())
    throw Error(ExitCode::internal_error, "The initial heads are not as many as the nodes of the mesh.");
  std::vector<double> heads;
  for (int node : system.node_of_unknown) heads.push_back(node_heads[static_cast<std::size_t>(node)] - system.datum);
  return heads;
}

template <int D>
std::vector<double> to_nodes(const SeepageSystem<D>& system, const std::vector<double>& heads) {
  std::vector<double> r;
  for (const auto& x : system.model.mesh->nodes) r.push_back(x[static_cast<std::size_t>(system.model.up)]);
  for (std::size_t u = 0; u < heads.size(); ++u)
    r[static_cast<std::size_t>(system.node_of_unknown[u])] = heads[u] + system.datum;
  return r;
}

#define TALUS_INSTANTIATE(D)                                                                                      \
  template SeepageResult<D> make_flow_result<D>(const SeepageSystem<D>&, const SeepageState&, const NodalSums&,   \
                                                const std::vector<NodeCondition>&, double, const StepInput&);     \
  template void add_fields<D>(const SeepageSystem<D>&, const SeepageState&, const StepInput&, SeepageResult<D>&); \
  template std::vector<double> to_unknowns<D>(const SeepageSystem<D>&, const std::vector<double>&);               \
  template std::vector<double> to_nodes<D>(const SeepageSystem<D>&, const std::vector<double>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::fem
