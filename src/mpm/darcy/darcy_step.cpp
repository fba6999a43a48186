// SPDX-License-Identifier: MIT
// The step of the Darcy (u-p) formulation (theory 22): contents and coefficients, pressure solve between two grid
// solves, then the remap and the pass over the points of one phase.
#include "mpm/darcy/darcy_step.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/parallel.hpp"
#include "mpm/backend/chunk_pass.hpp"
#include "mpm/darcy/sweep.hpp"
#include "mpm/kernels/darcy_block.hpp"
#include "mpm/kernels/flow_kernels.hpp"
#include "mpm/pore_water/surface.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"

namespace talus::mpm {

// G2P and P2G: the pass over points with the mass of soil and water, with effective stresses, and with the water
// content that solve_pressures() computes.

namespace {

template <int D>
struct DarcyPass : OneVelocityPass<D> {
  template <class Law>
  using Block = DarcyBlock<DarcyPass, Law>;
  using OneVelocityPass<D>::OneVelocityPass;
  Pack pressed_in{0.0};  ///< added to Water::pressed_in [kg]

  TALUS_KERNEL void note_full(const BlockPlace<Body<D>>&, Mask) {}
  ChunkSums sum() const { return {sum_lanes(this->dissipated), sum_lanes(pressed_in)}; }
};

}  // namespace

template <int D>
MoverLists advance_points(Darcy, Body<D>& body, const StepOptions<D>& options) {
  return advance_blocks<DarcyPass<D>>(body, options);
}

template MoverLists advance_points<2>(Darcy, Body<2>&, const StepOptions<2>&);
template MoverLists advance_points<3>(Darcy, Body<3>&, const StepOptions<3>&);

// Contents of elements and nodes, and the pressures that the step starts from.

namespace {

template <int D>
void allocate(Body<D>& body) {
  DarcyWater<D>& m = body.water.darcy;
  const std::size_t nodes = body.mesh().nodes.size(), materials = body.water.laws.size(),
                    lanes = static_cast<std::size_t>(body.layout->blocks) * lane_width;
  if (!m.graph) m.graph = std::make_shared<const NodeGraph<D>>(make_node_graph(body.mesh()));
  if (m.pressure.size() != nodes) m.pressure.assign(nodes, NAN);
  if (m.ponded.size() != nodes) m.ponded.assign(nodes, 0);
  if (m.change.size() != nodes) m.change.assign(nodes, 0.0);
  m.pore_force.assign(nodes, {});
  if (m.node_water.size() == nodes) return;
  m.pores.assign(materials, AlignedVector<double>(lanes, 0.0));
  m.volume = m.pores;
  m.water.assign(lanes, 0.0);
  for (auto* field : {&m.share, &m.drawn, &m.saturated, &m.effective, &m.coupling, &m.conductive, &m.soft, &m.pressing})
    field->assign(lanes, 0.0);
  m.own_mass.assign(lanes * (D + 1), 0.0);
  for (auto& component : m.flux) component.assign(lanes, 0.0);
  m.node_pores.assign(materials, std::vector<double>(nodes, 0.0));
  for (auto* field : {&m.node_water, &m.out, &m.passed, &m.mobility}) field->assign(nodes, 0.0);
  m.velocity.assign(nodes, {});
  m.acceleration = m.area = m.velocity;
}

/// sum_element() for the elements of block `b`, whose points are all of soil `soil`. Returns whether an element lost
/// its last wet point or received its first one.
template <int D>
[[gnu::noinline]] bool sum_block(Body<D>& body, int b, int soil, bool mixed) {
  using P = PointFields<D>;
  Water<D>& water = body.water;
  DarcyWater<D>& m = water.darcy;
  const Points<D>& points = body.points;
  const WaterLaw& law = water.laws[static_cast<std::size_t>(soil)];
  const std::size_t first = static_cast<std::size_t>(b) * lane_width;
  const Pack count = load<Pack>(&points.count[first]);
  const Mask was = load<Pack>(&water.volume[first]) > Pack(0.0);
  Pack content(0.0), all(0.0), pores(0.0), pressure(0.0);
  for (int k = 0; k < points.block_used[b]; ++k) {
    const double* p = points.slot(points.block_start[b] + k);
    const Mask is_point = Pack(static_cast<double>(k)) < count;
    const auto field = [&](int f) { return select(is_point, load<Pack>(p + f * lane_width), Pack(0.0)); };
    const Pack volume = field(P::volume);
    all += volume;
    if (!law.wet) continue;
    const Pack here = find_pores(volume, field(P::mass) / law.grain_density);
    pores += here;
    pressure += here * field(water.first_field + WaterFields<D>::pressure);
    content += field(water.first_field + WaterFields<D>::mass) / law.density;
  }
  const Pack wet = law.wet ? all : Pack(0.0);
  const Mask full = Mask(mixed) && all > Pack(0.0) && all > load<Pack>(&body.elements.fill_limit[first]);
  const Pack whole = load<Pack>(&body.layout->volumes[first]), stretch = select(full, whole / all, Pack(1.0)),
             integrated = law.wet ? select(full, whole, all) : Pack(0.0);
  for (std::size_t k = 0; k < water.laws.size(); ++k) {
    const bool is_this = static_cast<int>(k) == soil;
    store(&m.pores[k][first], is_this ? pores : Pack(0.0));
    store(&m.volume[k][first], is_this ? integrated : Pack(0.0));
  }
  store(&m.water[first], content);
  store(&water.mean_pressure[first],
        select(pores > Pack(0.0), pressure / pores, load<Pack>(&water.mean_pressure[first])));
  store(&water.stretch[first], stretch);
  store(&water.volume[first], wet);
  return to_bits(wet > Pack(0.0)) != to_bits(was);
}

}  // namespace

template <int D>
void find_contents(Body<D>& body, const StepOptions<D>& o) {
  allocate(body);
  Water<D>& water = body.water;
  const Layout<D>& layout = *body.layout;
  const int elements = body.mesh().element_count();
  const std::size_t nodes = body.mesh().nodes.size();
  const bool first = water.darcy.own.size() != nodes;  // the same on all ranks
  if (first) water.darcy.own.assign(nodes, 0.0);
  DarcyWater<D>& m = water.darcy;
  std::vector<std::uint8_t> turned(static_cast<std::size_t>(layout.chunks), 0);
  for_chunks(body, o.threads, [&](int c) {
    bool any_turned = false;
    for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b) {
      const unsigned soils = body.points.block_materials[b];
      if (std::popcount(soils) == 1 && (b + 1) * lane_width <= elements) {
        any_turned = sum_block(body, b, std::countr_zero(soils), o.mixed) || any_turned;
        continue;
      }
      for (int e = b * lane_width; e < std::min(elements, (b + 1) * lane_width); ++e) {
        const bool was = water.volume[e] > 0;
        any_turned = sum_element(body, e, o.mixed) != was || any_turned;
      }
    }
    turned[static_cast<std::size_t>(c)] = any_turned;
  });
  if (std::any_of(turned.begin(), turned.end(), [](auto t) { return t != 0; })) water.surface_is_stale = true;
  update_elements(body, water.volume, water.mean_pressure, m.water);
  for (auto& pores : m.pores) update_elements(body, pores);
  for_slices_of_nodes(body, o.threads, [&]<class T>(int i) { start_nodes<T>(body, i, first); });
  update_nodes(body, m.pressure);
}

template void find_contents<2>(Body<2>&, const StepOptions<2>&);
template void find_contents<3>(Body<3>&, const StepOptions<3>&);

// Coefficients of the flow, forces of the pressures, and predicted motion.

template <int D>
void find_flow(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  DarcyWater<D>& m = water.darcy;
  std::vector<std::vector<double>> relative(water.laws.size());
  for (std::size_t k = 0; k < water.laws.size(); ++k) {
    if (!water.laws[k].wet) continue;
    relative[k].resize(body.mesh().nodes.size());
    const double full = find_relative_at(water.laws[k], 0.0);
    for_slices_of_nodes(body, o.threads, [&, k, full]<class T>(int i) {
      store_unaligned(&relative[k][static_cast<std::size_t>(i)], find_relative_at_node<T>(body, k, full, i));
    });
    update_nodes(body, relative[k]);
  }
  for_blocks_of_elements(body, o.threads, [&](int e) { find_flow_through<Pack>(body, o, relative, e); });
  update_elements(body, m.coupling, m.conductive, m.soft, m.pressing);
}

template <int D>
void load_darcy(Body<D>& body, const StepOptions<D>& o) {
  gather_loads(body);
  if (body.nodes.load.empty()) body.nodes.load.assign(body.mesh().nodes.size(), Vec<D>{});
  if (body.water.darcy_load.empty()) return;
  for_node_pieces(body, o.threads, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i)
      for (int d = 0; d < D; ++d) body.nodes.load[i][d] += body.water.darcy_load[i][d];
  });
}

template <int D>
void press_nodes(Body<D>& body, const StepOptions<D>& o) {
  for_slices_of_nodes(body, o.threads, [&]<class T>(int i) { press_nodes_at<T>(body, i); });
}

template <int D>
double find_pore_power(const Body<D>& body, const StepOptions<D>& o) {
  const Layout<D>& layout = *body.layout;
  const auto has_rows = [&](int i) { return layout.row_start[i] < layout.row_start[i + 1]; };
  return list_nodes(body, has_rows).sum(body, o.threads, [&](int i) { return find_pore_power_at(body, i); });
}

/// Halo exchange of Conditions::pressed for nodes that other ranks sum.
template <int D>
void update_pressed(Body<D>& body) {
  Conditions<D>& conditions = body.conditions;
  if (!body.partition || conditions.pressed.empty()) return;
  std::vector<double> pressed(body.mesh().nodes.size(), 0.0);
  const auto for_constraints = [&](auto&& work) {
    for (std::size_t i = 0; i < pressed.size(); ++i)
      if (const int c = conditions.constraint_of_node[i]; c >= 0)
        work(pressed[i], conditions.pressed[static_cast<std::size_t>(c)]);
  };
  for_constraints([](double& of_node, std::uint8_t& of_wall) { of_node = of_wall; });
  update_nodes(body, pressed);
  for_constraints([](double& of_node, std::uint8_t& of_wall) { of_wall = of_node != 0; });
}

template <int D>
void predict_motion(Body<D>& body, const StepOptions<D>& o) {
  DarcyWater<D>& m = body.water.darcy;
  for_blocks_of_elements(body, o.threads, [&](int e) { find_own_mass<Pack>(body, e, m.own_mass); });
  if (body.partition) {
    std::vector<HaloArray> by_corner;
    for (int k = 0; k <= D; ++k) by_corner.push_back({&m.own_mass[m.graph->find_corner(0, k)], 1});
    body.partition->elements->update(by_corner);
  }
  for_slices_of_nodes(body, o.threads, [&]<class T>(int i) { predict_nodes<T>(body, o, m.own_mass, i); });
  update_nodes(body, m.velocity, m.acceleration, m.mobility);
  update_pressed(body);
}

#define TALUS_INSTANTIATE(D)                                                 \
  template void find_flow<D>(Body<D>&, const StepOptions<D>&);               \
  template void load_darcy<D>(Body<D>&, const StepOptions<D>&);              \
  template void press_nodes<D>(Body<D>&, const StepOptions<D>&);             \
  template double find_pore_power<D>(const Body<D>&, const StepOptions<D>&); \
  template void predict_motion<D>(Body<D>&, const StepOptions<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
