// SPDX-License-Identifier: MIT
// Coefficients of the flow in a step, the forces of the pressures, and the motion that they predict.

#include "mpm/coupled/coupled_step.hpp"
#include "mpm/mixture/flow_lines.hpp"
#include "mpm/mixture/mixture_step.hpp"
#include "mpm/mixture/sweep.hpp"

namespace talus::mpm {
template <int D>
void find_flow(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  DarcyWater<D>& m = water.darcy;
  std::vector<std::vector<double>> relative(water.laws.size());
  for (std::size_t k = 0; k < water.laws.size(); ++k) {
    if (!water.laws[k].wet) continue;
    relative[k].resize(body.mesh().nodes.size());
    for_nodes(body, o.threads, [&, k](int i) { relative[k][i] = find_relative_at_node(body, k, i); });
    update_nodes(body, relative[k]);
  }
  for_elements(body, o.threads, [&](int e) { find_flow_through(body, o, relative, e); });
  update_elements(body, m.saturated, m.effective, m.coupling, m.conductive, m.soft);
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
  for_nodes(body, o.threads, [&](int i) { press_node(body, i); });
}

template <int D>
double find_pore_power(const Body<D>& body, const StepOptions<D>& o) {
  const Layout<D>& layout = *body.layout;
  const auto has_rows = [&](int i) { return layout.row_start[i] < layout.row_start[i + 1]; };
  return list_nodes(body, has_rows).sum(body, o.threads, [&](int i) { return find_pore_power_at(body, i); });
}

/// Whether walls are pressed on, at nodes that other ranks sum up.
template <int D>
void update_pressed(Body<D>& body) {
  Conditions<D>& conditions = body.conditions;
  if (!body.share || conditions.pressed.empty()) return;
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
  std::vector<std::array<double, D + 1>> own_mass(body.mesh().elements.size());
  for_elements(body, o.threads, [&](int e) { own_mass[e] = find_own_mass(body, e); });
  update_elements(body, own_mass);
  for_nodes(body, o.threads, [&](int i) { predict_node(body, o, own_mass, i); });
  update_nodes(body, m.velocity, m.acceleration, m.mobility);
  update_pressed(body);
}

#define TALUS_INSTANTIATE(D)                                                 \
  template void find_flow<D>(Body<D>&, const StepOptions<D>&);               \
  template void load_darcy<D>(Body<D>&, const StepOptions<D>&);            \
  template void press_nodes<D>(Body<D>&, const StepOptions<D>&);             \
  template double find_pore_power<D>(const Body<D>&, const StepOptions<D>&); \
  template void predict_motion<D>(Body<D>&, const StepOptions<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
