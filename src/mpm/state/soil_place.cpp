// SPDX-License-Identifier: MIT
#include "mpm/state/soil_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"

namespace talus::mpm {
namespace {

/// Mass of a node over the largest of its element below which the element is at the edge of the soil.
constexpr double light = 0.1;
/// Distance outside its element, in shape functions, up to which a place counts as inside (round-off of a head on the
/// ground).
constexpr double beside = 1e-3;
/// Volume of the points of an element over its own from which soil is everywhere in it.
constexpr double full = 0.9;
/// Radius around a place of the points that it follows, over the size √V of the nearest one, and over its distance
/// where that is larger. With regular points at least three are within it.
constexpr double radius_of_points = 2, radius_of_distance = 1.5;
/// Distance of the nearest point, over its size √V, within which a place touches soil: with regular points it is at
/// most 0.88 for places on the ground.
constexpr double touching = 1;
/// Radius of the search for points over the size of elements.
constexpr double search_radius = 2;
/// Largest change of the weight of a point by which a linear field is followed, over that of a point of its mass at the
/// place itself.
constexpr double most_correction = 2;
/// Sum of the weights of points on the grid below which a place has lost its soil.
constexpr double fewest_left = 0.5;

/// A point next to a place.
struct NearPoint {
  int id = -1;
  Vec<2> x{};
  double mass = 0, size = 0, distance = 0;  ///< [kg], [m], [m]
};

bool is_two_velocity(const Body<2>& body) {
  return body.water.is_wet() && !body.water.darcy.is_used;
}

Vec<2> subtract(const Vec<2>& a, const Vec<2>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

void add_share(SoilPlace& place, int node, double weight) {
  const auto at = std::find_if(place.shares.begin(), place.shares.end(),
                               [&](const NodeShare& share) { return share.node == node; });
  if (at == place.shares.end())
    place.shares.push_back({node, weight});
  else
    at->weight += weight;
}

bool is_inside(const SoilPlace& place) {
  return std::min({1 - place.xi[0] - place.xi[1], place.xi[0], place.xi[1]}) > -beside;
}

/// Volume of the points of an element over its own.
double compute_filling(const Body<2>& body, int e) {
  const auto at = static_cast<std::size_t>(e);
  const double* first = body.points.slot(body.points.block_start[at / lane_width]) + at % lane_width;
  double volume = 0;
  for (int k = 0; k < static_cast<int>(body.points.count[at]); ++k)
    volume += first[(k * body.points.fields + Points<2>::volume) * lane_width];
  return volume / body.mesh().volumes[at];
}

/// Joins a place in an element with points by shape functions; returns false at the edge of the soil.
bool join_to_element(const Body<2>& body, SoilPlace& place) {
  const auto& nodes = body.mesh().elements[static_cast<std::size_t>(place.element)];
  std::array<double, 3> shape{1 - place.xi[0] - place.xi[1], place.xi[0], place.xi[1]}, mass;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    mass[k] = sum_node_mass(body, nodes[k]);
    sum += shape[k] = std::max(0.0, shape[k]);
  }
  const auto [least, most] = std::minmax_element(mass.begin(), mass.end());
  if (*least < light * *most) return false;
  for (std::size_t k = 0; k < 3; ++k) place.shares.push_back({nodes[k], shape[k] / sum});
  place.is_joined = true;
  return true;
}

/// Returns the elements that may have points within `reach` of a place, from its own one on.
std::vector<int> find_elements(const mesh::Mesh<2>& mesh, const SoilPlace& place, double reach) {
  const auto is_near = [&](int e) {
    const Vec<2> centre = mesh::find_place(mesh, e, Vec<2>{1.0 / 3, 1.0 / 3});
    double radius = 0;
    for (const int node : mesh.elements[static_cast<std::size_t>(e)])
      radius = std::max(radius, norm(subtract(mesh.nodes[static_cast<std::size_t>(node)], centre)));
    return norm(subtract(centre, place.x)) <= reach + radius;
  };
  std::vector<int> found{place.element};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const int next : mesh.neighbours[static_cast<std::size_t>(found[i])])
      if (next >= 0 && std::find(found.begin(), found.end(), next) == found.end() && is_near(next))
        found.push_back(next);
  return found;
}

NearPoint view_near_point(const Body<2>& body, int e, int k, const Vec<2>& x) {
  using P = Points<2>;
  const std::int64_t slot = body.points.block_start[static_cast<std::size_t>(e / lane_width)] + k;
  const double* p = body.points.slot(slot) + e % lane_width;
  NearPoint point;
  point.id = body.points.id[static_cast<std::size_t>(slot * lane_width + e % lane_width)];
  point.x = mesh::find_place(body.mesh(), e, Vec<2>{p[P::xi * lane_width], p[(P::xi + 1) * lane_width]});
  point.mass = p[P::mass * lane_width];
  point.size = std::sqrt(p[P::volume * lane_width]);
  point.distance = norm(subtract(point.x, x));
  return point;
}

/// Returns the points around a place, the nearest one first; empty if there are none in reach, or if the nearest one is
/// farther than `limit` times its size.
std::vector<NearPoint> find_points(const Body<2>& body, const SoilPlace& place,
                                   double limit = std::numeric_limits<double>::infinity()) {
  const double area = body.mesh().volumes[static_cast<std::size_t>(place.element)],
               reach = search_radius * std::sqrt(4 / std::numbers::sqrt3 * area);
  std::vector<NearPoint> points;
  for (const int e : find_elements(body.mesh(), place, reach))
    for (int k = 0; k < static_cast<int>(body.points.count[static_cast<std::size_t>(e)]); ++k) {
      const NearPoint point = view_near_point(body, e, k, place.x);
      if (point.distance <= reach) points.push_back(point);
    }
  const auto nearest = std::min_element(points.begin(), points.end(),
                                        [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (nearest == points.end() || nearest->distance > limit * nearest->size) return {};
  std::iter_swap(points.begin(), nearest);
  return points;
}

/// Weights of points in a place (T25.2). `points`: the nearest one first.
std::vector<PointShare> weigh_points(const std::vector<NearPoint>& points, const Vec<2>& x) {
  const double radius = std::max(radius_of_points * points.front().size, radius_of_distance * points.front().distance);
  std::vector<double> weight, nearness;
  double sum = 0, xx = 0, xy = 0, yy = 0;
  Vec<2> mean{};
  for (const NearPoint& p : points) {
    const double inside = std::max(0.0, 1 - p.distance * p.distance / (radius * radius));
    nearness.push_back(inside * inside);
    weight.push_back(p.mass * nearness.back());
    sum += weight.back();
    for (std::size_t d = 0; d < 2; ++d) mean[d] += weight.back() * p.x[d];
  }
  for (double& m : mean) m /= sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec<2> r = subtract(points[i].x, mean);
    const double w = weight[i] /= sum;
    xx += w * r[0] * r[0], xy += w * r[0] * r[1], yy += w * r[1] * r[1];
  }
  const double least = 1e-9 * radius * radius;
  xx += least, yy += least;
  const Vec<2> offset = subtract(x, mean);
  const double det = xx * yy - xy * xy;
  const Vec<2> slope{(yy * offset[0] - xy * offset[1]) / det, (xx * offset[1] - xy * offset[0]) / det};
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    largest = std::max(largest, nearness[i] * std::abs(dot(slope, subtract(points[i].x, mean))));
  const double part = largest > most_correction ? most_correction / largest : 1;
  std::vector<PointShare> shares;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (weight[i] > 0)
      shares.push_back({points[i].id, weight[i] * (1 + part * dot(slope, subtract(points[i].x, mean)))});
  return shares;
}

/// Shares of the nodes from those of the points on the grid.
void share_among_nodes(const Body<2>& body, const std::vector<PointShare>& carriers, SoilPlace& place) {
  using P = Points<2>;
  double sum = 0;
  for (const PointShare& share : carriers)
    if (body.points.element[static_cast<std::size_t>(share.point)] >= 0) sum += share.weight;
  place.is_joined = sum > fewest_left;
  if (!place.is_joined) return;
  for (const PointShare& share : carriers) {
    const int e = body.points.element[static_cast<std::size_t>(share.point)];
    if (e < 0) continue;
    const std::int64_t at = body.points.place[static_cast<std::size_t>(share.point)];
    const double* p = body.points.slot(at / lane_width) + at % lane_width;
    const double a = p[P::xi * lane_width], b = p[(P::xi + 1) * lane_width], weight = share.weight / sum;
    const auto& nodes = body.mesh().elements[static_cast<std::size_t>(e)];
    add_share(place, nodes[0], weight * (1 - a - b));
    add_share(place, nodes[1], weight * a);
    add_share(place, nodes[2], weight * b);
  }
}

}  // namespace

double sum_node_mass(const Body<2>& body, int node) {
  const Layout<2>& layout = *body.layout;
  const int* rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[static_cast<std::size_t>(node)])];
  const int count = layout.count_motion_rows(node);
  double mass = 0;  // the first column of both
  if (is_two_velocity(body))
    sum_rows<1, wet_sums_stride<2>>(body.water.sums, rows, count, &mass);
  else
    sum_rows<1, sums_stride>(body.nodes.sums, rows, count, &mass);
  return mass;
}

void join_place(const Body<2>& body, SoilPlace& place) {
  place.shares.clear();
  place.is_joined = false;
  if (place.element < 0) return;
  const double filling = is_inside(place) ? compute_filling(body, place.element) : 0;
  if (filling >= full && join_to_element(body, place)) return;
  const std::vector<NearPoint> points = find_points(body, place, touching);
  if (points.empty() || (filling > 0 && join_to_element(body, place))) return;
  share_among_nodes(body, weigh_points(points, place.x), place);
}

void join_to_points(const Body<2>& body, SoilPlace& place) {
  place.shares.clear();
  place.is_joined = false;
  if (place.carried.empty() && place.element >= 0) {
    const std::vector<NearPoint> points = find_points(body, place);
    if (!points.empty()) place.carried = weigh_points(points, place.x);
  }
  share_among_nodes(body, place.carried, place);
}

Vec<2> move_place(const Body<2>& body, const SoilPlace& place) {
  const bool wet = is_two_velocity(body);
  const auto& motion = wet ? body.water.motion : body.nodes.motion;
  const std::size_t stride = wet ? wet_motion_stride<2> : motion_stride<2>, velocity = wet ? 4 : 2;
  Vec<2> v{};
  for (const NodeShare& share : place.shares) {
    const double* row = &motion[static_cast<std::size_t>(body.layout->motion_row(share.node, 0)) * stride + velocity];
    for (std::size_t d = 0; d < 2; ++d) v[d] += share.weight * row[d];
  }
  return v;
}

}  // namespace talus::mpm
