// SPDX-License-Identifier: MIT
#include "mpm/state/bars.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/state/body.hpp"

namespace talus::mpm {
namespace {

/// Number of the places of a plate that press on soil.
long count_pressed(const BarPlate& plate) {
  return std::count_if(plate.places.begin(), plate.places.end(), [](const SoilPlace& p) { return p.is_joined; });
}

void add_force(Body<2>& body, const SoilPlace& place, const Vec<2>& force, double weight) {
  for (const NodeShare& share : place.shares) {
    Vec<2>& load = body.nodes.load[static_cast<std::size_t>(share.node)];
    for (std::size_t d = 0; d < 2; ++d) load[d] += weight * share.weight * force[d];
  }
}

/// Joins the head of a bar to the ground under its plate.
void follow_plate(Bar& bar) {
  const long presses = count_pressed(bar.plate);
  if (presses == 0) return;
  SoilPlace& head = bar.nodes.front().soil;
  for (const SoilPlace& place : bar.plate.places)
    for (const NodeShare& share : place.shares)
      head.shares.push_back({share.node, share.weight / static_cast<double>(presses)});
  head.is_joined = true;
}

}  // namespace

void join_bars(Body<2>& body) {
  for (Bar& bar : body.bars) {
    for (BarNode& node : bar.nodes) join_place(body, node.soil);
    for (SoilPlace& place : bar.plate.places) join_to_points(body, place);
    if (!bar.nodes.front().soil.is_joined) follow_plate(bar);
  }
}

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

double find_bar_rate(const Body<2>& body) {
  if (body.bars.empty()) return 0;
  std::vector<double> rates(body.mesh().nodes.size());
  const auto add = [&](const SoilPlace& place, double stiffness) {
    double sum = 0;  // above 1 where weights are negative
    for (const NodeShare& share : place.shares) sum += std::abs(share.weight);
    for (const NodeShare& share : place.shares)
      if (const double mass = sum_node_mass(body, share.node); mass > 0)
        rates[static_cast<std::size_t>(share.node)] += sum * std::abs(share.weight) * stiffness / mass;
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
