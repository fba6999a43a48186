// SPDX-License-Identifier: MIT
// Construction of the strips of a section. Every corner and every crossing of two of its lines is a break.
#include "lem/section/strips.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/planar.hpp"

namespace talus::lem {

// The layers of one strip. Every line of a region or of the water table is a boundary.

namespace {

/// Returns the soil between two lines, that of the last region that contains the place.
int find_soil(const Section& section, const std::vector<std::vector<double>>& crossings, double y) {
  for (std::size_t r = section.regions.size(); r-- > 0;) {
    const auto above = std::count_if(crossings[r].begin(), crossings[r].end(), [&](double c) { return c > y; });
    if (above % 2 == 1) return section.regions[r].soil;
  }
  return -1;
}

/// Returns the unit weight of a layer. Soil that does not drain during drawdown keeps its weight.
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
  const double ground = strip.ground.at(half), base = strips.section.base;
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
  if (strip.water.at(half) > no_water) add(strip.water);
  for (const StripLine& line : strip.piezometric) add(line);
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
    Layer layer{lines[i - 1], lines[i], {}, 0, find_soil(strips.section, crossings, y), y < strip.water.at(half),
                y < before};
    if (layer.soil >= 0) {
      const Soil& soil = strips.section.soils[static_cast<std::size_t>(layer.soil)];
      if (soil.piezometric_line >= 0) layer.wet = layer.was_wet = y < strip.find_water(soil).at(half);
      layer.unit_weight = find_weight(strips, layer);
    }
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

namespace {

/// Lengths below this fraction of the width of the section count as rounding.
constexpr double rounding = 1e-9;

void add_edge(std::vector<Edge>& edges, Point a, Point b, int region) {
  if (a[0] == b[0]) return;
  if (a[0] > b[0]) std::swap(a, b);
  edges.push_back({a, b, region});
}

/// Adds x of the crossing of two edges, if they cross inside both. Collinear edges give an arbitrary crossing.
void add_crossing(std::vector<double>& breaks, const Edge& e, const Edge& f, double nearest) {
  const double from = std::max(e.a[0], f.a[0]), to = std::min(e.b[0], f.b[0]);
  if (from >= to) return;
  const double left = e.at(from) - f.at(from), right = e.at(to) - f.at(to);
  if (std::max(std::abs(left), std::abs(right)) <= nearest) return;
  if ((left < 0 && right > 0) || (left > 0 && right < 0)) breaks.push_back(from + (to - from) * left / (left - right));
}

/// Adds x of the corners of a load.
void add_corners(std::vector<double>& breaks, const Surcharge& surcharge, double nearest) {
  double most = 0;
  for (const auto& row : surcharge.load) most = std::max(most, std::abs(row[1]));
  std::vector<Point> line;  // the load scaled to the width, for the collinearity tolerance
  for (const auto& row : surcharge.load) line.push_back({row[0], most > 0 ? row[1] * nearest / (rounding * most) : 0});
  for (const Point& p : mesh::drop_straight_points(line, false, nearest)) breaks.push_back(p[0]);
}

std::vector<double> find_breaks(const Section& section, const std::vector<Edge>& edges, double left, double right) {
  std::vector<double> breaks{left, right};
  const double nearest = rounding * (right - left);
  for (const Edge& edge : edges) {
    breaks.push_back(edge.a[0]);
    breaks.push_back(edge.b[0]);
  }
  for (const Surcharge& surcharge : section.surcharges) add_corners(breaks, surcharge, nearest);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) add_crossing(breaks, edges[i], edges[j], nearest);
  std::sort(breaks.begin(), breaks.end());
  // Breaks closer to each other than rounding are merged.
  std::vector<double> kept;
  for (const double x : breaks)
    if (x >= left && x <= right && (kept.empty() || x - kept.back() > nearest)) kept.push_back(x);
  kept.back() = right;
  return kept;
}

StripLine cut_line(const std::vector<Point>& line, double left, double right) {
  const double middle = 0.5 * (left + right);
  if (middle <= line.front()[0]) return {line.front()[1], 0};
  for (std::size_t i = 1; i < line.size(); ++i)
    if (middle < line[i][0]) return cut_edge({line[i - 1], line[i], -1}, left);
  return {line.back()[1], 0};
}

/// Sums the loads over a strip, or its variable ones. `part` 1: component downwards, 2: component towards larger x.
StripLine sum_loads(const Section& section, std::size_t part, double left, double right, bool variable_alone = false) {
  StripLine sum;
  const double middle = 0.5 * (left + right);
  for (const Surcharge& surcharge : section.surcharges)
    for (std::size_t i = 1; i < surcharge.load.size() && (surcharge.is_variable || !variable_alone); ++i) {
      const auto &a = surcharge.load[i - 1], &b = surcharge.load[i];
      if (middle < a[0] || middle >= b[0]) continue;
      const double slope = (b[part] - a[part]) / (b[0] - a[0]);
      sum.y += a[part] + slope * (left - a[0]);
      sum.slope += slope;
    }
  return sum;
}

/// Sets the lowest line that a surface may follow in a strip.
void find_floor(Slope::Strips& strips, Strip& strip) {
  const std::vector<int>& firm = strips.section.impenetrable;
  strip.floor = {strips.section.base, 0};
  for (int k = strip.first; k < strip.last; ++k) {
    const Layer& layer = strips.layer(k);
    if (std::find(firm.begin(), firm.end(), layer.soil) != firm.end()) {
      strip.floor = layer.top;
      strip.is_firm = strips.firm = true;
      return;
    }
    if (layer.soil < 0 && k > strip.first) {
      strip.floor = layer.top;
      strip.is_raised = strips.raised = true;
      return;
    }
  }
}

}  // namespace

double follow_line(const std::vector<Point>& line, double x) {
  if (x < line.front()[0]) return line.front()[1];
  for (std::size_t i = 1; i < line.size(); ++i)
    if (x < line[i][0]) {
      const Point &a = line[i - 1], &b = line[i];
      return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
    }
  return line.back()[1];
}

void build_strips(Slope::Strips& strips) {
  const Section& section = strips.section;
  const double left = section.ground.front()[0], right = section.ground.back()[0];
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < section.regions.size(); ++r) {
    // A point on a straight edge is left out: as a break it would change the division into slices.
    const auto polygon = mesh::drop_straight_points(section.regions[r].polygon, true, rounding * (right - left));
    for (std::size_t i = 0; i < polygon.size(); ++i)
      add_edge(edges, polygon[i], polygon[(i + 1) % polygon.size()], static_cast<int>(r));
  }
  for (std::size_t i = 1; i < section.ground.size(); ++i) add_edge(edges, section.ground[i - 1], section.ground[i], -1);
  const auto add_water = [&](std::vector<Point> water) {
    if (water.empty()) return water;
    // Level beyond its ends, also for the crossings with the other lines.
    if (water.front()[0] > left) water.insert(water.begin(), {left, water.front()[1]});
    if (water.back()[0] < right) water.push_back({right, water.back()[1]});
    water = mesh::drop_straight_points(water, false, rounding * (right - left));
    for (std::size_t i = 1; i < water.size(); ++i) add_edge(edges, water[i - 1], water[i], -1);
    return water;
  };
  const auto water = add_water(section.water_table);
  // Included so that no break of the water table before drawdown lies inside a slice.
  const auto before = strips.before ? add_water(strips.before->section().water_table) : water;
  std::vector<std::vector<Point>> piezometric;
  for (const std::vector<Point>& line : section.piezometric_lines) piezometric.push_back(add_water(line));
  const auto breaks = find_breaks(section, edges, left, right);
  double low = section.base, high = section.base;
  for (const Point& p : section.ground) high = std::max(high, p[1]);
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    Strip strip;
    strip.left = breaks[i - 1];
    strip.right = breaks[i];
    strip.ground = cut_line(section.ground, strip.left, strip.right);
    strip.water = water.empty() ? StripLine{no_water, 0} : cut_line(water, strip.left, strip.right);
    strip.water_before = before.empty() ? StripLine{no_water, 0} : cut_line(before, strip.left, strip.right);
    for (const std::vector<Point>& line : piezometric)
      strip.piezometric.push_back(line.empty() ? StripLine{no_water, 0} : cut_line(line, strip.left, strip.right));
    strip.load = sum_loads(section, 1, strip.left, strip.right);
    strip.variable_load = sum_loads(section, 1, strip.left, strip.right, true);
    strip.thrust = sum_loads(section, 2, strip.left, strip.right);
    const double half = 0.5 * (strip.right - strip.left);
    strip.ponded = strip.water.at(half) > strip.ground.at(half) + 1e-9 * (high - low);
    stack_layers(strips, strip, edges, 1e-6 * (high - low));
    find_floor(strips, strip);
    strips.strips.push_back(strip);
  }
  for (const Soil& soil : section.soils) {
    strips.tan_friction.push_back(std::tan(soil.friction_angle));
    strips.tan_phi_b.push_back(std::tan(soil.phi_b));
    strips.laws = strips.laws || soil.law;
    strips.unreduced = strips.unreduced || !soil.reduced;
    strips.curved_laws = strips.curved_laws || (soil.law && soil.law->is_curved);
  }
  strips.loads = !section.surcharges.empty();
  for (const RootCohesion& roots : section.roots)
    if (!roots.profile.empty()) {
      strips.roots = true;
      strips.deepest_roots = std::max(strips.deepest_roots, roots.profile.back()[0]);
    }
  if (section.pressure_grid) strips.pressure = PressureLocator(*section.pressure_grid);
  const int bins = std::max<int>(16, 4 * static_cast<int>(strips.strips.size()));
  strips.bin = (right - left) / bins;
  int at = 0;
  for (int i = 0; i <= bins; ++i) {
    const double x = left + i * strips.bin;
    while (at + 1 < static_cast<int>(strips.strips.size()) && strips.strip(at).right <= x) ++at;
    strips.at.push_back(at);
  }
}

int Slope::Strips::find(double x) const {
  const double place = (x - strips.front().left) / bin;
  if (!(place > 0)) return 0;
  auto i = at[std::min(static_cast<std::size_t>(place), at.size() - 1)];
  while (i > 0 && strip(i).left > x) --i;
  while (i + 1 < static_cast<int>(strips.size()) && strip(i).right <= x) ++i;
  return i;
}

}  // namespace talus::lem
