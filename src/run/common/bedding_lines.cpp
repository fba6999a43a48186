// SPDX-License-Identifier: MIT
#include "run/common/bedding_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "mesh/generate.hpp"
#include "mesh/planar.hpp"
#include "site/site.hpp"

namespace talus::run {

namespace {

/// Least distance of two lines, and length of a line, over the element size.
constexpr double closest = 0.1, shortest = 0.5;

/// A polygon in the axes of its bedding.
class BeddedPolygon {
 public:
  BeddedPolygon(const mesh::Polygon& polygon, double angle)
      : polygon_(polygon), along_{std::cos(angle), std::sin(angle)}, across_{-std::sin(angle), std::cos(angle)} {}

  /// Returns the levels across the bedding: those of the corners, and between them at even distances of at most
  /// `widest`.
  std::vector<double> list_levels(double size, double widest) const {
    std::vector<double> corners, levels;
    for (const Vec<2>& x : polygon_.points) corners.push_back(dot(x, across_));
    std::sort(corners.begin(), corners.end());
    for (const double level : corners) {
      if (levels.empty()) {
        levels.push_back(level);
        continue;
      }
      const double from = levels.back(), gap = level - from;
      if (gap < closest * size) continue;
      const int parts = static_cast<int>(std::ceil(gap / widest));
      for (int i = 1; i < parts; ++i) levels.push_back(from + gap * i / parts);
      levels.push_back(level);
    }
    return levels;
  }

  /// Returns the parts of the line at this level that lie inside.
  std::vector<std::array<Vec<2>, 2>> cut(double level, double size) const {
    const double rounding = 1e-9 * size;
    std::vector<double> places;
    const auto& points = polygon_.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec<2>&a = points[i], &b = points[(i + 1) % points.size()];
      const double above_a = dot(a, across_) - level, above_b = dot(b, across_) - level;
      if (std::abs(above_a) <= rounding) places.push_back(dot(a, along_));
      if (std::abs(above_a) <= rounding || std::abs(above_b) <= rounding || (above_a < 0) == (above_b < 0)) continue;
      const double share = above_a / (above_a - above_b);
      places.push_back((1 - share) * dot(a, along_) + share * dot(b, along_));
    }
    std::sort(places.begin(), places.end());
    std::vector<std::array<Vec<2>, 2>> parts;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double from = places[i - 1], to = places[i];
      if (to - from < shortest * size || !is_within(0.5 * (from + to), level, size)) continue;
      parts.push_back({find_place(from, level), find_place(to, level)});
    }
    return parts;
  }

 private:
  Vec<2> find_place(double s, double level) const {
    return {s * along_[0] + level * across_[0], s * along_[1] + level * across_[1]};
  }
  /// Returns true inside the polygon and away from its sides, along which there is a line already.
  bool is_within(double s, double level, double size) const {
    const double away = 0.5 * closest * size;
    return mesh::is_inside(find_place(s, level - away), polygon_.points) &&
           mesh::is_inside(find_place(s, level + away), polygon_.points);
  }

  const mesh::Polygon& polygon_;
  Vec<2> along_, across_;
};

std::optional<material::PlanesStrength> find_planes(const input::Material& soil) {
  if (!soil.traits().serves_slices) return std::nullopt;
  return site::find_plane_strength(soil).planes;
}

mesh::Plan conform_to_bedding(const input::Case& data, mesh::Plan plan, double spacing) {
  for (const mesh::Polygon& polygon : plan.polygons) {
    const auto region = data.regions.find(polygon.name);
    if (region == data.regions.end()) continue;
    const auto planes = find_planes(data.materials.at(region->second));
    if (!planes) continue;
    const BeddedPolygon bedded(polygon, planes->angle);
    for (const double level : bedded.list_levels(plan.size, spacing * plan.size))
      for (const auto& [from, to] : bedded.cut(level, plan.size))
        plan.lines.push_back({fmt::format("bedding {}", plan.lines.size() + 1), {from, to}});
  }
  return plan;
}

}  // namespace

bool has_bedding(const input::Case& data) {
  return std::any_of(data.regions.begin(), data.regions.end(),
                     [&](const auto& region) { return find_planes(data.materials.at(region.second)).has_value(); });
}

bool has_wide_bedding(const input::Material& soil) {
  return soil.model == material::model_of<material::Bedding> &&
         std::max(soil.bedding_range, soil.bedding_transition.value_or(0)) > 0;
}

mesh::Mesh<2> generate_with_bedding(const input::Case& data, const mesh::Plan& plan, double spacing,
                                    std::vector<std::string>& notes) {
  const auto note = [&](const char* why) {
    notes.push_back(
        fmt::format("the mesh has no lines along the bedding, because {}; slip along it strains the soil beside it "
                    "too, so that the "
                    "factor is too high unless the elements are small",
                    why));
  };
  if (!plan.file.empty()) {
    if (has_bedding(data)) note("it is that of a file");
    return mesh::generate<2>(plan);
  }
  const mesh::Plan bedded = conform_to_bedding(data, plan, spacing);
  if (bedded.lines.size() == plan.lines.size()) return mesh::generate<2>(plan);
  try {
    return mesh::generate<2>(bedded);
  } catch (const Error&) {
    mesh::Mesh<2> without = mesh::generate<2>(plan);  // throws for a fault of the plan itself
    note("they would nearly touch other lines");
    return without;
  }
}

template <>
mesh::Mesh<2> generate_along_bedding<2>(const input::Case& data, const mesh::Plan& plan,
                                        std::vector<std::string>& notes) {
  return generate_with_bedding(data, plan, 1, notes);
}

template <>
mesh::Mesh<3> generate_along_bedding<3>(const input::Case&, const mesh::Plan& plan, std::vector<std::string>&) {
  return mesh::generate<3>(plan);
}

}  // namespace talus::run
