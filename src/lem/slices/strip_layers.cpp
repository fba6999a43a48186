// SPDX-License-Identifier: MIT
// The layers of one strip: every line of a region or of the water table is a boundary.

#include "lem/slices/strip_layers.hpp"

#include <algorithm>

namespace talus::lem {

namespace {

/// The soil between two lines: that of the last region that holds the place.
int find_soil(const Section& section, const std::vector<std::vector<double>>& crossings, double y) {
  for (std::size_t r = section.regions.size(); r-- > 0;) {
    const auto above = std::count_if(crossings[r].begin(), crossings[r].end(), [&](double c) { return c > y; });
    if (above % 2 == 1) return section.regions[r].soil;
  }
  return -1;
}

/// Soil that holds its water through a drawdown weighs what it weighed before.
double find_weight(const Slope::Strips& strips, const Layer& layer) {
  const auto number = static_cast<std::size_t>(layer.soil);
  const Soil& soil = strips.section.soils[number];
  if (strips.before && holds_water(strips.section, soil)) {
    const Soil& before = strips.before->section().soils[number];
    return layer.was_wet ? before.saturated_unit_weight : before.unit_weight;
  }
  return layer.wet ? soil.saturated_unit_weight : soil.unit_weight;
}

}  // namespace

void stack_layers(Slope::Strips& strips, Strip& strip, const std::vector<Edge>& edges, double sliver) {
  const double middle = 0.5 * (strip.left + strip.right), half = middle - strip.left;
  const double ground = strip.ground.at(half), water = strip.water.at(half), base = strips.section.base;
  const double before = strip.water_before.at(half);
  std::vector<std::vector<double>> crossings(strips.section.regions.size());
  std::vector<StripLine> lines{strip.ground};
  const auto add = [&](const StripLine& line) {
    if (line.at(half) < ground - sliver && line.at(half) > base + sliver) lines.push_back(line);
  };
  for (const Edge& edge : edges) {
    if (edge.region < 0 || edge.a[0] > middle || edge.b[0] <= middle) continue;
    crossings[static_cast<std::size_t>(edge.region)].push_back(edge.at(middle));
    add(cut_edge(edge, strip.left));
  }
  if (water > no_water) add(strip.water);
  if (strips.before && before > no_water) add(strip.water_before);
  lines.push_back({base, 0});
  std::sort(lines.begin(), lines.end(),
            [&](const StripLine& a, const StripLine& b) { return a.at(half) > b.at(half); });
  strip.first = static_cast<int>(strips.layers.size());
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double top = lines[i - 1].at(half), bottom = lines[i].at(half);
    if (top - bottom <= sliver && i + 1 < lines.size()) {
      lines[i] = lines[i - 1];
      continue;
    }
    const double y = 0.5 * (top + bottom);
    Layer layer{lines[i - 1], lines[i], {}, 0, find_soil(strips.section, crossings, y), y < water, y < before};
    if (layer.soil >= 0) layer.unit_weight = find_weight(strips, layer);
    if (static_cast<int>(strips.layers.size()) > strip.first) {
      Layer& above = strips.layers.back();
      if (above.soil == layer.soil && above.wet == layer.wet && above.was_wet == layer.was_wet) {
        above.bottom = layer.bottom;
        continue;
      }
      layer.weight.y = above.weight.y + above.unit_weight * (above.top.y - above.bottom.y);
      layer.weight.slope = above.weight.slope + above.unit_weight * (above.top.slope - above.bottom.slope);
    }
    strips.layers.push_back(layer);
  }
  strip.last = static_cast<int>(strips.layers.size());
}

}  // namespace talus::lem
