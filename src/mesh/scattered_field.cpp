// SPDX-License-Identifier: MIT
#include "mesh/scattered_field.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "base/error.hpp"
#include "mesh/locate.hpp"

namespace talus::mesh {

namespace {

using Point = std::array<double, 2>;
namespace bp = boost::polygon;

/// Distance of the frame from the middle of the points over their extent.
constexpr double frame = 10;
/// The diagram has coordinates of 32 bits.
constexpr double largest_coordinate = 1 << 30;
/// Twice the area over the square of the longest edge, below which a triangle is flat.
constexpr double flat = 1e-9;

double cross(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double measure_square(const Point& a, const Point& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// Returns the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Point> make_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  std::vector<Point> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= first + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double compute_area(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) twice += cross(polygon[0], polygon[i - 1], polygon[i]);
  return twice / 2;
}

/// Returns r² ln r of the square of a distance.
double compute_plate(double square) {
  return square > 0 ? 0.5 * square * std::log(square) : 0;
}

double dot(const Point& at, const Point& a, const Point& b) {
  return (a[0] - at[0]) * (b[0] - at[0]) + (a[1] - at[1]) * (b[1] - at[1]);
}

/// Returns true if c and d, on either side of the edge from a to b, lie on one circle with it: their angles over the
/// edge then sum to π. `rounding`: uncertainty of each coordinate [m].
bool are_on_circle(const Point& a, const Point& b, const Point& c, const Point& d, double rounding) {
  const double lengths[4] = {std::sqrt(measure_square(c, a)), std::sqrt(measure_square(c, b)),
                             std::sqrt(measure_square(d, a)), std::sqrt(measure_square(d, b))};
  const double sine = std::abs(cross(c, a, b)) * dot(d, a, b) + dot(c, a, b) * std::abs(cross(d, a, b));
  // Each of the four directions turns by the rounding of its two points over its length.
  const double tolerance = 8 * rounding / *std::min_element(lengths, lengths + 4);
  return std::abs(sine) <= tolerance * lengths[0] * lengths[1] * lengths[2] * lengths[3];
}

using Diagram = bp::voronoi_diagram<double>;

/// Sets the Voronoi diagram of the points, rounded to integers of 1/scale.
void make_diagram(const std::vector<Point>& nodes, const Point& middle, double scale, Diagram& diagram) {
  std::vector<bp::point_data<std::int32_t>> sites;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> places;
  for (const Point& p : nodes) {
    const auto x = static_cast<std::int32_t>(std::lround((p[0] - middle[0]) * scale));
    const auto y = static_cast<std::int32_t>(std::lround((p[1] - middle[1]) * scale));
    const auto [at, is_new] = places.try_emplace({x, y}, sites.size());
    if (!is_new)
      fail_input("points {} and {} lie at one place, x = {:.6g} m, y = {:.6g} m", at->second + 1, sites.size() + 1,
                 p[0], p[1]);
    sites.emplace_back(x, y);
  }
  bp::construct_voronoi(sites.begin(), sites.end(), &diagram);
}

/// Returns the Delaunay polygons of the points, counter-clockwise: triangles, and one polygon of all points that lie on
/// one empty circle, up to rounding. The vertices of the Voronoi diagram are the circumcentres.
std::vector<std::vector<int>> make_polygons(const std::vector<Point>& nodes, const Point& middle, double extent) {
  const double scale = largest_coordinate / (frame * extent);
  Diagram diagram;
  make_diagram(nodes, middle, scale, diagram);
  const auto get_node = [&](const auto* edge) -> const Point& { return nodes[edge->cell()->source_index()]; };
  std::vector<std::size_t> group(diagram.num_vertices());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto find_group = [&](const auto* vertex) {
    auto i = static_cast<std::size_t>(vertex - diagram.vertices().data());
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (const auto& edge : diagram.edges()) {
    if (!edge.is_finite() || &edge > edge.twin()) continue;
    if (are_on_circle(get_node(&edge), get_node(edge.twin()), get_node(edge.prev()->twin()),
                      get_node(edge.next()->twin()), 1 / scale))
      group[find_group(edge.vertex0())] = find_group(edge.vertex1());
  }
  std::vector<std::set<int>> members(diagram.num_vertices());
  for (const auto& vertex : diagram.vertices()) {
    const auto* edge = vertex.incident_edge();
    do {
      members[find_group(&vertex)].insert(static_cast<int>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
  }
  std::vector<std::vector<int>> polygons;
  for (const std::set<int>& own : members) {
    if (own.empty()) continue;
    Point centre{};
    for (const int i : own)
      for (std::size_t d = 0; d < 2; ++d)
        centre[d] += nodes[static_cast<std::size_t>(i)][d] / static_cast<double>(own.size());
    std::vector<std::pair<double, int>> around;
    for (const int i : own) {
      const Point& p = nodes[static_cast<std::size_t>(i)];
      around.emplace_back(std::atan2(p[1] - centre[1], p[0] - centre[0]), i);
    }
    std::sort(around.begin(), around.end());
    polygons.emplace_back();
    for (const auto& [angle, i] : around) polygons.back().push_back(i);
  }
  return polygons;
}

/// Returns the triangles of the points. Where more than three lie on one circle, as in a regular grid, no diagonal is
/// the right one: their mean becomes a node, so that the field of a mirrored or turned grid is mirrored or turned.
std::vector<Mesh<2>::Element> triangulate(std::vector<Point>& nodes, std::vector<double>& values, const Point& middle,
                                          double extent) {
  std::vector<Mesh<2>::Element> triangles;
  const auto add = [&](const Mesh<2>::Element& t) {
    const Point &a = nodes[static_cast<std::size_t>(t[0])], &b = nodes[static_cast<std::size_t>(t[1])],
                &c = nodes[static_cast<std::size_t>(t[2])];
    const double longest = std::max({measure_square(a, b), measure_square(b, c), measure_square(c, a)});
    if (!(std::abs(cross(a, b, c)) > flat * longest)) return;
    triangles.push_back(t);
    // From the leftmost corner, so that interpolation has one rounding whatever the order of the points.
    std::sort(triangles.back().begin(), triangles.back().end(),
              [&](int i, int j) { return nodes[static_cast<std::size_t>(i)] < nodes[static_cast<std::size_t>(j)]; });
  };
  for (const std::vector<int>& polygon : make_polygons(nodes, middle, extent)) {
    if (polygon.size() == 3) {
      add({polygon[0], polygon[1], polygon[2]});
      continue;
    }
    const auto average = [&](auto&& get) {
      std::vector<double> numbers;
      for (const int i : polygon) numbers.push_back(get(static_cast<std::size_t>(i)));
      std::sort(numbers.begin(), numbers.end());
      return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
    };
    const Point centre{average([&](std::size_t i) { return nodes[i][0]; }),
                       average([&](std::size_t i) { return nodes[i][1]; })};
    const double mean = average([&](std::size_t i) { return values[i]; });
    const int own = static_cast<int>(nodes.size());
    nodes.push_back(centre);
    values.push_back(mean);
    for (std::size_t i = 0; i < polygon.size(); ++i) add({own, polygon[i], polygon[(i + 1) % polygon.size()]});
  }
  return triangles;
}

}  // namespace

ScatteredField::ScatteredField(const std::vector<ScatteredValue>& values, Scatter kind) : kind_(kind) {
  if (values.size() < 3) fail_input("there are {} points; three are needed at least", values.size());
  if (kind == Scatter::thin_plate && values.size() > most_spline_points)
    fail_input("there are {} points; a thin plate takes at most {}, linear interpolation any number", values.size(),
               most_spline_points);
  Point low = values.front().at, high = low;
  std::vector<Point> points;
  for (const ScatteredValue& v : values) {
    for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], v.at[d]), high[d] = std::max(high[d], v.at[d]);
    points.push_back(v.at);
  }
  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  const Point middle{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
  hull_ = make_hull(points);
  if (!(compute_area(hull_) > 1e-6 * extent * extent))
    fail_input("the points lie on one line; a plane needs points beside it");
  mesh_.nodes = points;
  for (const ScatteredValue& v : values) values_.push_back(v.value);
  for (const Point& corner : {Point{-1, -1}, Point{1, -1}, Point{1, 1}, Point{-1, 1}}) {
    const Point at{middle[0] + frame * extent * corner[0], middle[1] + frame * extent * corner[1]};
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const Point& a, const Point& b) {
      return measure_square(a, at) < measure_square(b, at);
    });
    mesh_.nodes.push_back(at);
    values_.push_back(values_[static_cast<std::size_t>(nearest - points.begin())]);
  }
  mesh_.elements = triangulate(mesh_.nodes, values_, middle, extent);
  mesh_.element_region.assign(mesh_.elements.size(), 0);
  mesh_.region_names = {"points"};
  finish(mesh_, Order::as_given);
  if (kind != Scatter::thin_plate) return;
  origin_ = middle;
  scale_ = 1 / extent;
  make_plate(values);
}

// In extended precision, whose templates of Eigen do not replace those in Gmsh's library, compiled with other flags.
void ScatteredField::make_plate(const std::vector<ScatteredValue>& values) {
  using Number = long double;
  const auto n = static_cast<Eigen::Index>(values.size());
  for (const ScatteredValue& v : values)
    centres_.push_back({(v.at[0] - origin_[0]) * scale_, (v.at[1] - origin_[1]) * scale_});
  Eigen::MatrixX<Number> matrix = Eigen::MatrixX<Number>::Zero(n + 3, n + 3);
  Eigen::VectorX<Number> right = Eigen::VectorX<Number>::Zero(n + 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point& a = centres_[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < i; ++j)
      matrix(i, j) = matrix(j, i) = compute_plate(measure_square(a, centres_[static_cast<std::size_t>(j)]));
    matrix(i, n) = matrix(n, i) = 1;
    for (Eigen::Index d = 0; d < 2; ++d) matrix(i, n + 1 + d) = matrix(n + 1 + d, i) = a[static_cast<std::size_t>(d)];
    right(i) = values[static_cast<std::size_t>(i)].value;
  }
  const Eigen::VectorX<Number> found = matrix.partialPivLu().solve(right);
  for (const Number weight : found) weights_.push_back(static_cast<double>(weight));
}

double ScatteredField::find_on_plate(const std::array<double, 2>& x) const {
  const Point at{(x[0] - origin_[0]) * scale_, (x[1] - origin_[1]) * scale_};
  const std::size_t n = centres_.size();
  double sum = weights_[n] + weights_[n + 1] * at[0] + weights_[n + 2] * at[1];
  for (std::size_t i = 0; i < n; ++i) sum += weights_[i] * compute_plate(measure_square(at, centres_[i]));
  return sum;
}

double ScatteredField::find(const std::array<double, 2>& x) const {
  if (kind_ == Scatter::thin_plate) return find_on_plate(x);
  const int e = find_element(mesh_, x);
  if (e < 0) {  // beyond the frame
    const auto nearest = std::min_element(mesh_.nodes.begin(), mesh_.nodes.end(), [&](const Point& a, const Point& b) {
      return measure_square(a, x) < measure_square(b, x);
    });
    return values_[static_cast<std::size_t>(nearest - mesh_.nodes.begin())];
  }
  const auto xi = to_local(mesh_, e, x);
  const auto& t = mesh_.elements[static_cast<std::size_t>(e)];
  const auto value = [&](std::size_t i) { return values_[static_cast<std::size_t>(t[i])]; };
  return value(0) + xi[0] * (value(1) - value(0)) + xi[1] * (value(2) - value(0));
}

bool ScatteredField::covers(const std::array<double, 2>& x) const {
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const Point &a = hull_[i], &b = hull_[(i + 1) % hull_.size()];
    if (cross(a, b, x) < -1e-9 * measure_square(a, b)) return false;
  }
  return true;
}

}  // namespace talus::mesh
