// SPDX-License-Identifier: MIT
#include "mpm/state/bars.hpp"

#include <algorithm>

#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"

namespace talus::mpm {
namespace {

/// Mass of a node over the largest of its element below which its share is reduced.
constexpr double light = 0.1;

std::array<double, 3> find_shape(const Vec<2>& xi) {
  return {1 - xi[0] - xi[1], xi[0], xi[1]};
}

double sum_mass(const Body<2>& body, int node) {
  const Layout<2>& layout = *body.layout;
  double mass = 0;
  sum_rows<1, sums_stride>(body.nodes.sums, &layout.node_rows[static_cast<std::size_t>(layout.row_start[node])],
                           layout.count_motion_rows(node), &mass);
  return mass;
}

void join(const Body<2>& body, SoilPlace& place) {
  place.is_joined = false;
  place.share = {};
  if (place.element < 0 || !(body.points.count[static_cast<std::size_t>(place.element)] > 0)) return;
  const auto shape = find_shape(place.xi);
  std::array<double, 3> mass;
  for (std::size_t k = 0; k < 3; ++k) mass[k] = sum_mass(body, body.mesh().elements[place.element][k]);
  const double enough = light * std::max({mass[0], mass[1], mass[2]});
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    place.share[k] = std::max(0.0, shape[k]) * std::min(1.0, mass[k] / enough);
    sum += place.share[k];
  }
  if (!(sum > 0)) return;
  for (double& share : place.share) share /= sum;
  place.is_joined = true;
}

/// Number of the places of a plate that press on soil.
long count_pressed(const BarPlate& plate) {
  return std::count_if(plate.places.begin(), plate.places.end(), [](const SoilPlace& p) { return p.is_joined; });
}

void add_force(Body<2>& body, const SoilPlace& place, const Vec<2>& force, double weight) {
  for (std::size_t k = 0; k < 3; ++k) {
    Vec<2>& load = body.nodes.load[static_cast<std::size_t>(body.mesh().elements[place.element][k])];
    for (std::size_t d = 0; d < 2; ++d) load[d] += weight * place.share[k] * force[d];
  }
}

/// Finds the shares of the nodes from the present nodal sums.
void join_bars(Body<2>& body) {
  for (Bar& bar : body.bars) {
    for (BarNode& node : bar.nodes) join(body, node.soil);
    for (SoilPlace& place : bar.plate.places) join(body, place);
  }
}

}  // namespace

std::vector<JoinedNodes> find_joined(const Bar& bar) {
  const int count = static_cast<int>(bar.nodes.size());
  std::vector<JoinedNodes> joined;
  int before = -1, next = 0;
  for (int i = 0; i < count; ++i) {
    const auto is_joined = [&](int k) { return bar.nodes[static_cast<std::size_t>(k)].soil.is_joined; };
    next = std::max(next, i);
    while (next < count && !is_joined(next)) ++next;
    if (next == i) before = i;
    if (before < 0 && next == count) return {};
    const int a = before < 0 ? next : before, b = next == count ? before : next;
    const auto at = [&](int k) { return bar.nodes[static_cast<std::size_t>(k)].place; };
    const double t = a == b ? 0 : (at(i) - at(a)) / (at(b) - at(a));
    joined.push_back({{a, b}, {1 - t, t}});
  }
  return joined;
}

void add_bar_forces(Body<2>& body) {
  join_bars(body);
  for (const Bar& bar : body.bars) {
    const std::vector<JoinedNodes> joined = find_joined(bar);
    for (std::size_t i = 0; i < joined.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        if (joined[i].weight[k] != 0)
          add_force(body, bar.nodes[static_cast<std::size_t>(joined[i].node[k])].soil, bar.nodes[i].force,
                    joined[i].weight[k]);
    const long presses = count_pressed(bar.plate);
    if (presses == 0 || joined.empty()) continue;
    for (const SoilPlace& place : bar.plate.places)
      if (place.is_joined) add_force(body, place, bar.plate.push, 1.0 / static_cast<double>(presses));
  }
}

Vec<2> move_place(const Body<2>& body, const SoilPlace& place) {
  Vec<2> v{};
  for (std::size_t k = 0; k < 3; ++k) {
    const int node = body.mesh().elements[place.element][k];
    const double* motion =
        &body.nodes.motion[static_cast<std::size_t>(body.layout->motion_row(node, 0)) * motion_stride<2>];
    for (std::size_t d = 0; d < 2; ++d) v[d] += place.share[k] * motion[2 + d];
  }
  return v;
}

double find_bar_rate(const Body<2>& body) {
  if (body.bars.empty()) return 0;
  std::vector<double> rates(body.mesh().nodes.size());
  const auto add = [&](const SoilPlace& place, double stiffness) {
    if (!place.is_joined) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const int node = body.mesh().elements[place.element][k];
      if (const double mass = sum_mass(body, node); mass > 0 && place.share[k] > 0)
        rates[static_cast<std::size_t>(node)] += place.share[k] * stiffness / mass;
    }
  };
  for (const Bar& bar : body.bars) {
    for (const BarNode& node : bar.nodes) add(node.soil, node.bond.stiffness);
    for (const SoilPlace& place : bar.plate.places)
      add(place, bar.plate.law.stiffness / static_cast<double>(std::max(1L, count_pressed(bar.plate))));
    add(bar.nodes.front().soil, bar.plate.law.stiffness);
  }
  return *std::max_element(rates.begin(), rates.end());
}

}  // namespace talus::mpm
