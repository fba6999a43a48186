// SPDX-License-Identifier: MIT
#include "input/case/support_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/ground.hpp"

namespace talus::input {

double measure_width(const mesh::Polyline& ground) {
  return ground.back()[0] - ground.front()[0];
}

std::optional<std::array<double, 2>> find_levels(const mesh::Polyline& ground, double x) {
  std::optional<std::array<double, 2>> levels;
  const double slack = 1e-9 * measure_width(ground);
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const PlanePoint &a = ground[i - 1], &b = ground[i];
    if (x < a[0] - slack || x > b[0] + slack) continue;
    const bool is_step = b[0] - a[0] <= slack;
    const double t = is_step ? 0 : std::clamp((x - a[0]) / (b[0] - a[0]), 0.0, 1.0);
    const double first = is_step ? a[1] : a[1] + t * (b[1] - a[1]), second = is_step ? b[1] : first;
    if (!levels) levels = {first, first};
    for (const double y : {first, second}) *levels = {std::min((*levels)[0], y), std::max((*levels)[1], y)};
  }
  return levels;
}

namespace {

/// Returns 1 if the ground rises towards larger x at a point of it, -1 if it falls, 0 where it is level.
int find_rise(const mesh::Polyline& ground, const PlanePoint& p) {
  const double near = near_ground * measure_width(ground);
  int rise = 0;
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const PlanePoint &a = ground[i - 1], &b = ground[i];
    const double dy = b[1] - a[1];
    if (mesh::compute_distance(p, a, b) > near || std::abs(dy) < 1e-9 * measure_width(ground)) continue;
    const int own = dy > 0 ? 1 : -1;
    if (rise != 0 && rise != own) return 0;
    rise = own;
  }
  return rise;
}

/// Returns the place on the ground that is `distance` further down the slope; nullopt beyond its end.
std::optional<PlanePoint> step_down(const mesh::Polyline& ground, const PlanePoint& from, double distance,
                                    RowSpacing along) {
  const int rise = find_rise(ground, from);
  if (rise == 0) return std::nullopt;
  const double near = near_ground * measure_width(ground);
  // The walk begins on the last piece near the point.
  const auto size = static_cast<int>(ground.size());
  const auto corner = [&](int i) { return ground[static_cast<std::size_t>(rise > 0 ? size - 1 - i : i)]; };
  int piece = -1;
  for (int i = 1; i < size; ++i)
    if (mesh::compute_distance(from, corner(i - 1), corner(i)) <= near) piece = i;
  if (piece < 0) return std::nullopt;
  int last = piece;  // level ground below it is the foot
  for (int i = piece; i < size; ++i)
    if (corner(i - 1)[1] - corner(i)[1] > 1e-9 * measure_width(ground)) last = i;
  PlanePoint at = from;
  double left = distance;
  for (int i = piece; i <= last; ++i) {
    const PlanePoint& to = corner(i);
    const double dx = to[0] - at[0], dy = to[1] - at[1];
    const double step = along == RowSpacing::face ? std::hypot(dx, dy) : std::max(0.0, -dy);
    if (step >= left * (1 - 1e-12) && step > 0) return PlanePoint{at[0] + dx * left / step, at[1] + dy * left / step};
    left -= step;
    at = to;
  }
  return std::nullopt;
}

}  // namespace

double BarLine::length() const {
  return std::hypot(end[0] - head[0], end[1] - head[1]);
}

namespace {

/// Lists the heads of a support, from the top of its pattern.
std::vector<PlanePoint> list_heads(const Support& support, const mesh::Polyline& ground, const ShownUnit& unit,
                                   BarLayout& out) {
  if (!support.heads.empty()) return support.heads;
  std::vector<PlanePoint> heads;
  for (const double x : support.x) {
    const auto levels = find_levels(ground, x);
    if (!levels) {
      out.fault =
          fmt::format("x = {} is not on the ground, which goes from x = {} to x = {}", format_coordinate(x, unit),
                      format_coordinate(ground.front()[0], unit), format_coordinate(ground.back()[0], unit));
      out.key = "x";
      return {};
    }
    heads.push_back({x, (*levels)[1]});
  }
  if (!support.first) return heads;
  heads.push_back(*support.first);
  for (int row = 2; row <= support.rows; ++row) {
    const auto next =
        step_down(ground, heads.front(), (row - 1) * support.row_spacing.value_or(0), support.spacing_along);
    if (!next) {
      out.fault = fmt::format(
          "row {} of {} lies beyond the foot of the slope below `first`, {}: fewer rows, or a smaller 'row_spacing'",
          row, support.rows, format_point(*support.first, unit));
      out.key = "rows";
      return {};
    }
    heads.push_back(*next);
  }
  return heads;
}

}  // namespace

bool do_cross(const BarLine& a, const BarLine& b) {
  const auto turn = [](const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  return turn(a.head, a.end, b.head) * turn(a.head, a.end, b.end) < 0 &&
         turn(b.head, b.end, a.head) * turn(b.head, b.end, a.end) < 0;
}

BarLayout lay_bars(const Support& support, const mesh::Polyline& ground, const ShownUnit& unit) {
  BarLayout out;
  for (std::size_t i = 0; i + 1 < support.line.size(); ++i) out.bars.push_back({support.line[i], support.line[i + 1]});
  if (!support.line.empty()) return out;
  const std::vector<PlanePoint> heads = list_heads(support, ground, unit, out);
  // A case that was checked has one length or end for each head, and a spacing of its rows.
  const bool has_lengths =
      support.lengths.empty() ? support.length.has_value() : support.lengths.size() == heads.size();
  if (out.fault.empty() && (support.ends.empty() ? !has_lengths : support.ends.size() != heads.size()))
    out.fault = "bars without a length";
  if (!out.fault.empty()) return out;
  const bool is_steep = support.kind == SupportKind::pile || support.kind == SupportKind::wall;
  const double dip = support.inclination.value_or(is_steep ? std::numbers::pi / 2 : 0);
  const bool is_upright = std::cos(dip) < 1e-9;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    BarLine bar{heads[i], {}, static_cast<int>(i) + 1};
    if (!support.ends.empty()) {
      bar.end = support.ends[i];
    } else {
      int rise = is_upright ? 1 : find_rise(ground, bar.head);
      if (rise == 0 && support.first) rise = find_rise(ground, *support.first);  // rows on a bench
      if (rise == 0) {
        out.fault = fmt::format(
            "the side on which soil lies is not known at the head {}: it is not on an inclined part of the ground. "
            "Give 'heads' and 'ends' instead of 'inclination' and 'length'",
            format_point(bar.head, unit));
        out.key = support.heads.empty() ? "first" : "heads";
        return out;
      }
      const double length = support.lengths.empty() ? *support.length : support.lengths[i];
      bar.end = {bar.head[0] + (is_upright ? 0 : rise * length * std::cos(dip)), bar.head[1] - length * std::sin(dip)};
    }
    out.bars.push_back(bar);
  }
  return out;
}

std::optional<mesh::Polyline> find_stage_ground(const Case& data, std::optional<std::size_t> number) {
  mesh::Plan plan = data.mesh;
  std::erase_if(plan.polygons, [&](const mesh::Polygon& polygon) {
    return !(number ? is_there(data, polygon.name, *number) : is_there_at_start(data, polygon.name));
  });
  try {
    return mesh::find_ground(plan);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Supports that no stage adds are there at the start.
std::optional<std::size_t> find_placing_stage(const Case& data, const std::string& name) {
  if (is_there_at_start(data, name)) return std::nullopt;
  for (std::size_t k = 0; k < data.construction.size(); ++k)
    if (is_there(data, name, k)) return k;
  return std::nullopt;
}

mesh::Polyline find_placing_ground(const Case& data, const std::string& name) {
  if (!data.construction.empty())
    if (auto ground = find_stage_ground(data, find_placing_stage(data, name))) return *ground;
  return mesh::find_ground(data.mesh);
}

BarLayout lay_bars(const Case& data, const std::string& name) {
  try {
    return lay_bars(data.supports.at(name), find_placing_ground(data, name), data.units().length);
  } catch (const Error& fault) {
    BarLayout none;
    none.fault = fault.what();
    return none;
  }
}

std::string name_strut(const std::string& wall, std::size_t index) {
  return fmt::format("{}.strut_{}", wall, index + 1);
}

Support fix_places(Support support, const BarLayout& layout) {
  if (!support.line.empty() || !layout.fault.empty()) return support;
  support.heads.clear(), support.ends.clear(), support.x.clear(), support.lengths.clear();
  support.first.reset(), support.row_spacing.reset(), support.inclination.reset(), support.length.reset();
  support.rows = 1;
  for (const BarLine& bar : layout.bars) support.heads.push_back(bar.head), support.ends.push_back(bar.end);
  return support;
}

}  // namespace talus::input
