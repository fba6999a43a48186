// SPDX-License-Identifier: MIT
// Overlaps and gaps of polygons by Boost.Polygon, which is exact in integer arithmetic (docs/decisions/0027).
#include "mesh/cover.hpp"

#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <limits>

namespace talus::mesh {
namespace {

namespace bp = boost::polygon;
using Corner = bp::point_data<int>;
using Ring = bp::polygon_data<int>;
using HoledRing = bp::polygon_with_holes_data<int>;
using Area = bp::polygon_set_data<int>;
using namespace boost::polygon::operators;

/// Integer coordinates are below 2^29 in magnitude, so sums and differences fit in an int.
constexpr int grid_bits = 29;

/// The bounding rectangle of all polygons.
struct Extent {
  Point2 low, high;
  explicit Extent(const Plan& plan) {
    constexpr double far = std::numeric_limits<double>::infinity();
    low = {far, far};
    high = {-far, -far};
    for (const Polygon& polygon : plan.polygons) include(polygon.points);
  }
  explicit Extent(const Polyline& points) {
    low = high = points.front();
    include(points);
  }
  void include(const Polyline& points) {
    for (const Point2& p : points)
      for (std::size_t d = 0; d < 2; ++d) {
        low[d] = std::min(low[d], p[d]);
        high[d] = std::max(high[d], p[d]);
      }
  }
  bool meets(const Extent& other) const {
    for (std::size_t d = 0; d < 2; ++d)
      if (high[d] < other.low[d] || other.high[d] < low[d]) return false;
    return true;
  }
};

/// Conversion to integer coordinates. The step is a power of two, so that conversion back is exact.
class Grid {
 public:
  explicit Grid(const Extent& extent) {
    double side = 0;
    for (std::size_t d = 0; d < 2; ++d) {
      centre_[d] = (extent.low[d] + extent.high[d]) / 2;
      side = std::max(side, extent.high[d] - extent.low[d]);
    }
    step_ = std::ldexp(1.0, std::ilogb(side) + 1 - grid_bits);
    for (double& c : centre_) c = std::round(c / step_) * step_;
  }
  Corner enter(const Point2& p) const {
    const auto round = [&](std::size_t d) { return static_cast<int>(std::lround((p[d] - centre_[d]) / step_)); };
    return {round(0), round(1)};
  }
  Point2 leave(const Corner& c) const { return {centre_[0] + step_ * c.x(), centre_[1] + step_ * c.y()}; }

  Ring enter_ring(const Polyline& corners) const {
    std::vector<Corner> ring;
    for (const Point2& p : corners) ring.push_back(enter(p));
    return {ring.begin(), ring.end()};
  }
  Area enter_polygon(const Polyline& corners) const {
    Area area;
    area.insert(enter_ring(corners));
    return area;
  }

  Polyline leave_ring(const auto& ring) const {
    Polyline corners;
    for (auto c = ring.begin(); c != ring.end(); ++c) corners.push_back(leave(*c));
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    return corners;
  }

 private:
  Point2 centre_{};
  double step_ = 1;
};

double measure_outline(const Polyline& corners) {
  double length = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

/// Returns a point inside: the middle of the longest interior part of the vertical through the middle of the outline.
Point2 find_inside(const std::vector<Polyline>& rings) {
  const Extent extent(rings.front());
  const double x = (extent.low[0] + extent.high[0]) / 2;
  std::vector<double> levels;
  for (const Polyline& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a[0] > x) != (b[0] > x)) levels.push_back(a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]));
    }
  std::sort(levels.begin(), levels.end());
  Point2 place{x, (extent.low[1] + extent.high[1]) / 2};
  double longest = 0;
  for (std::size_t i = 0; i + 1 < levels.size(); i += 2)
    if (levels[i + 1] - levels[i] > longest) {
      longest = levels[i + 1] - levels[i];
      place[1] = (levels[i] + levels[i + 1]) / 2;
    }
  return place;
}

/// Returns the pieces of an area that are wider than `least`.
std::vector<Piece> list_pieces(const Area& area, const Grid& grid, double least) {
  std::vector<HoledRing> found;
  area.get(found);
  std::vector<Piece> pieces;
  for (const HoledRing& ring : found) {
    std::vector<Polyline> rings{grid.leave_ring(ring)};
    for (auto hole = ring.begin_holes(); hole != ring.end_holes(); ++hole) rings.push_back(grid.leave_ring(*hole));
    if (rings.front().size() < 3) continue;
    Piece piece;
    double outline = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      piece.area += (i == 0 ? 1 : -1) * std::abs(compute_area(rings[i]));
      outline += measure_outline(rings[i]);
    }
    piece.width = 2 * piece.area / outline;
    if (!(piece.width > least)) continue;
    piece.place = find_inside(rings);
    const Extent extent(rings.front());
    piece.low = extent.low;
    piece.high = extent.high;
    pieces.push_back(piece);
  }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.area > b.area; });
  return pieces;
}

Misfit gather(Misfit::Kind kind, std::vector<int> polygons, const std::vector<Piece>& pieces) {
  Misfit misfit{kind, std::move(polygons), 0, static_cast<int>(pieces.size()), pieces.front()};
  for (const Piece& piece : pieces) misfit.area += piece.area;
  return misfit;
}

std::vector<Misfit> find_overlaps(const Plan& plan, const std::vector<Area>& areas, const Grid& grid, double least) {
  std::vector<Extent> extents;
  for (const Polygon& polygon : plan.polygons) extents.emplace_back(polygon.points);
  const auto is_within = [&](const Area& a, const Area& b) { return list_pieces(a - b, grid, least).empty(); };
  std::vector<Misfit> overlaps;
  for (std::size_t j = 0; j < areas.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      if (!extents[i].meets(extents[j])) continue;
      const std::vector<Piece> shared = list_pieces(areas[i] & areas[j], grid, least);
      if (shared.empty()) continue;
      const bool first_within = is_within(areas[i], areas[j]), second_within = is_within(areas[j], areas[i]);
      if (first_within != second_within) continue;  // a polygon inside another replaces it there
      overlaps.push_back(gather(first_within ? Misfit::Kind::same : Misfit::Kind::overlap,
                                {static_cast<int>(i), static_cast<int>(j)}, shared));
    }
  return overlaps;
}

/// Returns the area between the soil and the level y, above or below it.
Area cast_shadow(const Plan& plan, const Grid& grid, double y) {
  Area shadow;
  for (const Polygon& polygon : plan.polygons)
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const Point2 &a = polygon.points[i], &b = polygon.points[(i + 1) % polygon.points.size()];
      if (a[0] == b[0] || (a[1] == y && b[1] == y)) continue;
      shadow.insert(grid.enter_ring({a, b, {b[0], y}, {a[0], y}}));  // the union is computed on first use
    }
  return shadow;
}

std::vector<Misfit> find_gaps(const Plan& plan, const std::vector<Area>& areas, const Grid& grid, double least) {
  Area covered;
  for (const Area& area : areas) covered.insert(area);
  const Extent extent(plan);
  const Area between = cast_shadow(plan, grid, extent.low[1]) & cast_shadow(plan, grid, extent.high[1]);
  std::vector<Misfit> gaps;
  for (const Piece& piece : list_pieces(between - covered, grid, least)) {
    Misfit gap = gather(Misfit::Kind::gap, {}, {piece});
    // Find the soil vertically above and below the point.
    double above = std::numeric_limits<double>::infinity(), below = above;
    std::array<int, 2> beside{-1, -1};
    for (std::size_t p = 0; p < plan.polygons.size(); ++p)
      for (std::size_t i = 0; i < plan.polygons[p].points.size(); ++i) {
        const auto& points = plan.polygons[p].points;
        const Point2 &a = points[i], &b = points[(i + 1) % points.size()];
        if ((a[0] > piece.place[0]) == (b[0] > piece.place[0])) continue;
        const double rise = a[1] + (b[1] - a[1]) * (piece.place[0] - a[0]) / (b[0] - a[0]) - piece.place[1];
        if (rise > 0 && rise < above) above = rise, beside[0] = static_cast<int>(p);
        if (rise < 0 && -rise < below) below = -rise, beside[1] = static_cast<int>(p);
      }
    for (const int p : beside)
      if (p >= 0 && (gap.polygons.empty() || gap.polygons.front() != p)) gap.polygons.push_back(p);
    gaps.push_back(std::move(gap));
  }
  return gaps;
}

/// Returns the target of a corner: a side of the box or a corner of `known`; std::nullopt if there is none.
std::optional<Point2> find_corner(const Point2& x, const Plan& plan, const Polyline& known, double least, double most) {
  Point2 moved = x;
  for (std::size_t d = 0; d < 2; ++d)
    for (const double wall : {plan.box_min[d], plan.box_max[d]})
      if (const double gap = std::abs(x[d] - wall); gap > least && gap <= most) moved[d] = wall;
  for (const Point2& k : known) {
    const double gap = std::hypot(moved[0] - k[0], moved[1] - k[1]);
    if (gap <= least) return moved == x ? std::nullopt : std::optional(moved);
    if (gap <= most) return k;
  }
  return moved == x ? std::nullopt : std::optional(moved);
}

/// Returns the foot of `x` on an edge of another polygon at a distance above `least` and up to `most`.
std::optional<Point2> find_foot(const Point2& x, const Plan& plan, const Polyline* own, double least, double most) {
  std::optional<Point2> foot;
  for (const Polygon& polygon : plan.polygons) {
    if (&polygon.points == own) continue;
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const Point2 &a = polygon.points[i], &b = polygon.points[(i + 1) % polygon.points.size()];
      const double gap = compute_distance(x, a, b);
      if (gap <= least) return std::nullopt;  // already on an edge
      if (gap > most || foot) continue;
      const double dx = b[0] - a[0], dy = b[1] - a[1];
      const double share = std::clamp(((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      foot = {a[0] + share * dx, a[1] + share * dy};
    }
  }
  return foot;
}

/// Removes corners that were moved onto their neighbours.
void drop_repeated(Polyline& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
}

double measure_box(const Plan& plan) {
  return std::max(plan.box_max[0] - plan.box_min[0], plan.box_max[1] - plan.box_min[1]);
}

}  // namespace

double get_section_tolerance(const Plan& plan) {
  return 1e-6 * measure_box(plan);
}

std::vector<Misfit> find_misfits(const Plan& plan) {
  if (plan.polygons.empty()) return {};
  const Grid grid{Extent(plan)};
  const double least = get_section_tolerance(plan) / 10;
  std::vector<Area> areas;
  for (const Polygon& polygon : plan.polygons) areas.push_back(grid.enter_polygon(polygon.points));
  std::vector<Misfit> misfits = find_overlaps(plan, areas, grid, least);
  for (Misfit& gap : find_gaps(plan, areas, grid, least)) misfits.push_back(std::move(gap));
  return misfits;
}

std::vector<Joined> join_corners(Plan& plan) {
  const double most = get_section_tolerance(plan), least = 1e-3 * most;
  std::vector<Joined> joined;
  Polyline known{plan.box_min, {plan.box_max[0], plan.box_min[1]}, plan.box_max, {plan.box_min[0], plan.box_max[1]}};
  const auto join = [&](const std::string& name, Point2& x, const std::optional<Point2>& place) {
    if (!place || *place == x) return;
    joined.push_back({name, x, *place});
    x = *place;
  };
  // Corners of the same polygon are not joined.
  const auto join_all = [&](const std::string& name, Polyline& points) {
    for (Point2& x : points) join(name, x, find_corner(x, plan, known, least, most));
    known.insert(known.end(), points.begin(), points.end());
  };
  for (Polygon& polygon : plan.polygons) join_all(polygon.name, polygon.points);
  for (Line& line : plan.lines) join_all(line.name, line.points);
  for (Polygon& polygon : plan.polygons)
    for (Point2& x : polygon.points) join(polygon.name, x, find_foot(x, plan, &polygon.points, least, most));
  for (Line& line : plan.lines)
    for (Point2& x : line.points) join(line.name, x, find_foot(x, plan, nullptr, least, most));
  if (!joined.empty())
    for (Polygon& polygon : plan.polygons) drop_repeated(polygon.points);
  return joined;
}

}  // namespace talus::mesh
