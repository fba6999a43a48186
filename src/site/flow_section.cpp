// SPDX-License-Identifier: MIT
#include "site/flow_section.hpp"

#include <algorithm>
#include <cmath>

namespace talus::site {

namespace {

/// Distances below this, as a fraction of a side or a segment, are rounding.
constexpr double rounding = 1e-9;

double cross(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

Vec<2> subtract(const Vec<2>& a, const Vec<2>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

Vec<2> find_middle(const Vec<2>& a, const Vec<2>& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
}

Vec<2> find_centre(const mesh::Mesh<2>& mesh, int e) {
  Vec<2> centre{};
  for (const int node : mesh.elements[e])
    for (std::size_t d = 0; d < 2; ++d) centre[d] += mesh.nodes[node][d] / 3;
  return centre;
}

Vec<2> find_side_middle(const mesh::Mesh<2>& mesh, int e, int opposite) {
  const auto& nodes = mesh.elements[e];
  return find_middle(mesh.nodes[nodes[static_cast<std::size_t>((opposite + 1) % 3)]],
                     mesh.nodes[nodes[static_cast<std::size_t>((opposite + 2) % 3)]]);
}

int find_local(const mesh::Mesh<2>& mesh, int e, int node) {
  const auto& nodes = mesh.elements[e];
  return static_cast<int>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
}

void append(std::vector<FlowPart>& path, const std::vector<FlowPart>& more, double factor) {
  for (const FlowPart& p : more) path.push_back({p.element, {factor * p.normal[0], factor * p.normal[1]}});
}

}  // namespace

FlowSections::FlowSections(const fem::SeepageModel<2>& model) : model_(model) {
  for (const fem::HydraulicBoundary<2>& boundary : model.boundaries) {
    if (boundary.kind == fem::HydraulicKind::no_flow) continue;
    for (auto side : boundary.sides) {
      std::sort(side.begin(), side.end());
      open_.push_back(side);
    }
  }
  std::sort(open_.begin(), open_.end());
}

/// Returns the element with pore water across a side, or -1.
int FlowSections::find_next(int element, int opposite) const {
  const int next = model_.mesh->neighbours[element][static_cast<std::size_t>(opposite)];
  return next >= 0 && model_.mesh->element_region[next] != mesh::empty_region ? next : -1;
}

/// Returns the elements with pore water that a segment meets, with its range in each, by clipping at their sides.
std::map<int, FlowSections::Range> FlowSections::find_elements(const Vec<2>& a, const Vec<2>& b) const {
  const mesh::Mesh<2>& mesh = *model_.mesh;
  std::map<int, Range> met;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    double from = 0, to = 1;
    bool is_beside = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec<2>&p = mesh.nodes[mesh.elements[e][k]], &q = mesh.nodes[mesh.elements[e][(k + 1) % 3]];
      const Vec<2> side = subtract(q, p);
      const double at_a = cross(p, q, a), at_b = cross(p, q, b), near = rounding * dot(side, side);
      is_beside = is_beside || (at_a < -near && at_b < -near);
      if (std::abs(at_a - at_b) <= near) continue;  // along the side, inside it
      const double s = at_a / (at_a - at_b);
      if (at_a < at_b)
        from = std::max(from, s);
      else
        to = std::min(to, s);
    }
    if (!is_beside && from <= to + rounding) met[e] = {std::min(from, to), std::max(from, to)};
  }
  return met;
}

/// Returns the ranges that are left when those that meet are joined.
std::vector<FlowSections::Range> FlowSections::join(std::vector<Range> ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& p, const Range& q) { return p.from < q.from; });
  std::vector<Range> joined;
  for (const Range& r : ranges) {
    if (joined.empty() || r.from > joined.back().to + rounding)
      joined.push_back(r);
    else
      joined.back().to = std::max(joined.back().to, r.to);
  }
  return joined;
}

/// Returns the flow through a side at a gradient of 1 [m³/s], 0 if it is closed. It divides that of a node.
double FlowSections::compute_passing(int element, int opposite) const {
  const mesh::Mesh<2>& mesh = *model_.mesh;
  const auto& nodes = mesh.elements[element];
  std::array<int, 2> side{nodes[static_cast<std::size_t>((opposite + 1) % 3)],
                          nodes[static_cast<std::size_t>((opposite + 2) % 3)]};
  const Vec<2> along = subtract(mesh.nodes[side[1]], mesh.nodes[side[0]]);
  std::sort(side.begin(), side.end());
  if (!std::binary_search(open_.begin(), open_.end(), side)) return 0;
  const fem::HydraulicSoil<2>& soil = model_.soils[static_cast<std::size_t>(mesh.element_region[element])];
  return (soil.conductivity[0] * along[1] * along[1] + soil.conductivity[1] * along[0] * along[0] -
          2 * soil.cross_conductivity * along[0] * along[1]) /
         norm(along);
}

/// A way around a node from the centre of an element, from side to side.
struct FlowSections::Walk {
  Path path;                        ///< to the side at which it ends
  std::vector<Path> to_node;        ///< from the centre of the first element to the node in each further element
  std::vector<double> resistances;  ///< 1/k of these elements [s/m]
  bool is_closed = false;           ///< it returns to its element
  double passing = 0;               ///< of the side at which it ends [m³/s]
};

FlowSections::Walk FlowSections::walk_around(int node, int element, bool forwards) const {
  const mesh::Mesh<2>& mesh = *model_.mesh;
  Walk walk;
  Vec<2> place = find_centre(mesh, element);
  int at = element;
  int opposite = (find_local(mesh, element, node) + (forwards ? 1 : 2)) % 3;
  while (true) {
    const Vec<2> middle = find_side_middle(mesh, at, opposite);
    walk.path.push_back({at, subtract(middle, place)});
    place = middle;
    const int next = find_next(at, opposite);
    if (next < 0) {
      walk.passing = compute_passing(at, opposite);
      return walk;
    }
    if (next == element) {
      walk.is_closed = true;
      return walk;
    }
    const int entry = 3 - find_local(mesh, at, node) - opposite;  // the other node of the side that is crossed
    opposite = find_local(mesh, next, mesh.elements[at][static_cast<std::size_t>(entry)]);
    at = next;
    walk.to_node.push_back(walk.path);
    walk.to_node.back().push_back({at, subtract(mesh.nodes[node], place)});
    const auto& k = model_.soils[static_cast<std::size_t>(mesh.element_region[at])].conductivity;
    walk.resistances.push_back(2 / (k[0] + k[1]));
  }
}

/// Returns the path from the centre of an element to one of its nodes. Inside the soil the stream function of a node is
/// the mean of those of the elements around it, which differ by the error of their gradients: it counts by 1/k. At the
/// boundary it follows from the flow between the middles of both sides, which is that of the node.
FlowSections::Path FlowSections::find_node_path(int node, int element) const {
  const mesh::Mesh<2>& mesh = *model_.mesh;
  const Walk one = walk_around(node, element, true);
  Path path;
  if (one.is_closed) {
    const auto& k = model_.soils[static_cast<std::size_t>(mesh.element_region[element])].conductivity;
    const double own = 2 / (k[0] + k[1]);
    double sum = own;
    for (const double r : one.resistances) sum += r;
    path.push_back({element, subtract(mesh.nodes[node], find_centre(mesh, element))});
    for (double& d : path.back().normal) d *= own / sum;
    for (std::size_t i = 0; i < one.to_node.size(); ++i) append(path, one.to_node[i], one.resistances[i] / sum);
    return path;
  }
  const Walk other = walk_around(node, element, false);
  const double passing = one.passing + other.passing;
  const double fraction = passing > 0 ? one.passing / passing : 0.5;  // of the node's flow, through the first side
  append(path, one.path, 1 - fraction);
  append(path, other.path, fraction);
  return path;
}

/// Returns the path from the centre of an element to a place in it, by the linear stream function between its nodes.
FlowSections::Path FlowSections::find_place_path(int element, const Vec<2>& x) const {
  const mesh::Mesh<2>& mesh = *model_.mesh;
  const Vec<2> xi = mesh::to_local(mesh, element, x);
  const std::array<double, 3> weights{1 - xi[0] - xi[1], xi[0], xi[1]};
  Path path;
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(weights[k]) > rounding) append(path, find_node_path(mesh.elements[element][k], element), weights[k]);
  return path;
}

/// Returns the path between the centres of two elements through the middles of sides; `elements`: sorted, which it may
/// pass. Empty if there is none, or for one element.
FlowSections::Path FlowSections::find_path(const std::vector<int>& elements, int start, int end) const {
  const mesh::Mesh<2>& mesh = *model_.mesh;
  std::map<int, std::pair<int, int>> from;  // element and side from which an element is reached
  std::vector<int> reached{start};
  for (std::size_t i = 0; i < reached.size() && !from.contains(end); ++i)
    for (int k = 0; k < 3; ++k) {
      const int next = find_next(reached[i], k);
      if (next < 0 || next == start || !std::binary_search(elements.begin(), elements.end(), next)) continue;
      if (from.try_emplace(next, reached[i], k).second) reached.push_back(next);
    }
  Path path;
  Vec<2> place = find_centre(mesh, end);
  for (int at = end; at != start;) {
    const auto [before, side] = from.at(at);
    const Vec<2> middle = find_side_middle(mesh, before, side);
    path.push_back({at, subtract(place, middle)});
    place = middle;
    at = before;
  }
  path.push_back({start, subtract(place, find_centre(mesh, start))});
  return path;
}

/// Divides the elements that a segment meets into bodies that sides join: a wall that water does not pass, or a gap,
/// lies between them.
std::vector<FlowSections::Body> FlowSections::find_bodies(const Vec<2>& a, const Vec<2>& b) const {
  std::map<int, Range> left = find_elements(a, b);
  std::vector<Body> bodies;
  while (!left.empty()) {
    Body& body = bodies.emplace_back();
    const auto take = [&](std::map<int, Range>::iterator at) {
      body.elements.push_back(at->first);
      body.ranges.push_back(at->second);
      left.erase(at);
    };
    take(left.begin());
    for (std::size_t j = 0; j < body.elements.size(); ++j)
      for (int k = 0; k < 3; ++k)
        if (const auto next = left.find(find_next(body.elements[j], k)); next != left.end()) take(next);
  }
  return bodies;
}

/// Adds the path of a segment through a body, of each part between two gaps.
void FlowSections::add_path(const Body& body, const Vec<2>& a, const Vec<2>& b, Path& path) const {
  std::vector<int> allowed = body.elements;
  std::sort(allowed.begin(), allowed.end());
  const auto find_element = [&](double s) {
    for (std::size_t j = 0; j < body.elements.size(); ++j)
      if (body.ranges[j].from <= s + rounding && body.ranges[j].to >= s - rounding) return body.elements[j];
    return body.elements.front();
  };
  const auto find_point = [&](double s) { return Vec<2>{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}; };
  for (const Range& range : join(body.ranges)) {
    if (range.to - range.from <= rounding) continue;
    const int start = find_element(range.from), end = find_element(range.to);
    append(path, find_place_path(start, find_point(range.from)), -1);
    append(path, find_path(allowed, start, end), 1);
    append(path, find_place_path(end, find_point(range.to)), 1);
  }
}

std::vector<FlowPart> FlowSections::find_parts(const std::vector<Vec<2>>& line) const {
  Path path;
  bool is_met = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (const Body& body : find_bodies(line[i], line[i + 1])) {
      is_met = true;
      add_path(body, line[i], line[i + 1], path);
    }
  std::map<int, Vec<2>> normals;  // the displacements, turned to the right
  for (const FlowPart& p : path) {
    Vec<2>& normal = normals[p.element];
    normal[0] += p.normal[1], normal[1] -= p.normal[0];
  }
  std::vector<FlowPart> parts;
  for (const auto& [element, normal] : normals) parts.push_back({element, normal});
  if (parts.empty() && is_met) parts.emplace_back();  // the line touches the soil at points only
  return parts;
}

}  // namespace talus::site
