// SPDX-License-Identifier: MIT
#include "lem/section/uplift.hpp"

#include <algorithm>
#include <vector>

#include "lem/section/strips.hpp"

namespace talus::lem {
namespace {

constexpr int places = 200, levels = 40;
/// Least excess of u over σ_v: fraction of u, and of the pressure of water as high as the section.
constexpr double least_excess = 0.01, least_height = 0.002;

/// Returns the weight of standing water and loads on the ground of a strip [Pa].
double find_load(const Slope& slope, const Strip& strip, double dx) {
  const double depth = strip.water.at(dx) - strip.ground.at(dx);
  return strip.load.at(dx) + (strip.ponded ? std::max(0.0, depth) * slope.section().water_unit_weight : 0.0);
}

/// Returns the levels of a vertical, a little above and below each boundary of soils.
std::vector<double> list_levels(const Slope& slope, const Strip& strip, double dx) {
  const double ground = strip.ground.at(dx), base = slope.section().base, tiny = 1e-6 * (ground - base);
  std::vector<double> all;
  for (int i = 1; i <= levels; ++i) all.push_back(ground - (ground - base) * i / levels);
  for (int i = strip.first; i < strip.last; ++i)
    for (const double side : {-tiny, tiny}) all.push_back(slope.strips().layer(i).bottom.at(dx) + side);
  std::erase_if(all, [&](double y) { return y < base || y >= ground; });
  return all;
}

}  // namespace

std::optional<Uplift> find_uplift(const Slope& slope) {
  std::vector<double> along;
  for (int i = 0; i < places; ++i) along.push_back(slope.left() + (slope.right() - slope.left()) * (i + 0.5) / places);
  for (const Strip& strip : slope.strips().strips) along.push_back((strip.left + strip.right) / 2);
  double top = slope.section().base;
  for (const Point& p : slope.section().ground) top = std::max(top, p[1]);
  const double least = least_height * (top - slope.section().base) * slope.section().water_unit_weight;
  std::optional<Uplift> worst;
  for (const double x : along) {
    const Strip& strip = slope.strips().strip(slope.strips().find(x));
    const double dx = x - strip.left, load = find_load(slope, strip, dx);
    for (const double y : list_levels(slope, strip, dx)) {
      int soil = -1;
      const Uplift found{{x, y}, slope.weight_above(x, y, soil) + load, slope.pore_pressure({x, y})};
      if (soil < 0 || slope.section().soils[static_cast<std::size_t>(soil)].undrained) continue;
      const double excess = found.pressure - found.stress;
      if (excess < least || excess < least_excess * found.pressure) continue;
      if (!worst || excess > worst->pressure - worst->stress) worst = found;
    }
  }
  return worst;
}

}  // namespace talus::lem
