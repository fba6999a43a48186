// SPDX-License-Identifier: MIT
#include "bounds/wall_motion.hpp"

#include <algorithm>
#include <cmath>

namespace talus::bounds {
namespace {

/// Weights of the pore pressure at both ends of an edge in its integral with the three Bernstein polynomials.
constexpr std::array<std::array<double, 2>, 3> bernstein{
    {{1.0 / 4, 1.0 / 12}, {1.0 / 6, 1.0 / 6}, {1.0 / 12, 1.0 / 4}}};
/// Coefficients of a quadratic's values at both ends and in the middle in its Bézier points.
constexpr std::array<std::array<double, 3>, 3> points{{{1, 0, 0}, {-0.5, 2, -0.5}, {0, 0, 1}}};

void add_direction(std::vector<Freedom>& freedoms, const Vec<2>& direction, int number) {
  for (Freedom& f : freedoms)
    if (f.number == number) {
      for (std::size_t d = 0; d < 2; ++d) f.direction[d] += direction[d];
      return;
    }
  freedoms.push_back({direction, number});
}

/// Returns the velocity nodes of a face from the upper to the lower end.
std::array<int, 3> find_face_nodes(const Velocities& v, const WallFace& face) {
  const auto& t = v.triangles[face.triangle];
  const auto [i, j] = face.corner;
  return {t[i], t[3 + ((i + 1) % 3 == j ? i : j)], t[j]};
}

/// Returns the velocity of the soil at an end of an edge, if that on both sides is the same; else nullptr.
const std::vector<Freedom>* find_common(const WallEdge& edge, const Velocities& v, std::size_t end) {
  std::array<const std::vector<Freedom>*, 2> of{};
  for (const std::size_t side : {0, 1}) {
    const auto& face = edge.face[side];
    if (!face) return nullptr;
    of[side] = &v.freedoms[static_cast<std::size_t>(find_face_nodes(v, *face)[2 * end])];
  }
  const auto is_same = [](const Freedom& a, const Freedom& b) { return a.number == b.number; };
  return std::equal(of[0]->begin(), of[0]->end(), of[1]->begin(), of[1]->end(), is_same) ? of[0] : nullptr;
}

/// Returns the freedoms of the toe: those of the soil if that of both sides is one or fixed, else translations of its
/// own.
std::vector<Freedom> start_at_toe(const WallEdge& last, Velocities& v) {
  if (const auto soil = find_common(last, v, 1)) return *soil;
  v.count += 2;
  return {{{1, 0}, v.count - 2}, {{0, 1}, v.count - 1}};
}

/// Returns the velocity of the upper end of an edge between rigid soil of one body; nullptr: the soil is another.
const std::vector<Freedom>* find_clamp(const Problem& problem, const WallEdge& edge, const Velocities& v,
                                       const Units& units) {
  for (const auto& face : edge.face)
    if (!face || !is_rigid(problem.strength[face->triangle], units)) return nullptr;
  return find_common(edge, v, 0);
}

}  // namespace

void separate_at_walls(const Problem& problem, const std::vector<Edge>& edges,
                       std::vector<std::array<int, 6>>& triangles, std::vector<Vec<2>>& nodes) {
  const WallKeys walls(problem);
  std::map<int, std::vector<int>> around;  // triangles at each node of a wall
  for (const Wall& wall : problem.walls)
    for (const int node : wall.nodes) around[node];
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (const int node : problem.triangles[e])
      if (const auto found = around.find(node); found != around.end()) found->second.push_back(static_cast<int>(e));
  std::map<int, std::vector<std::array<int, 2>>> joined;  // pairs of triangles that an edge at the node joins
  for (const Edge& edge : edges)
    if (edge.other >= 0 && !walls.contains(edge.from, edge.to))
      for (const int node : {edge.from, edge.to})
        if (around.contains(node)) joined[node].push_back({edge.triangle, edge.other});
  for (auto& [node, all] : around) {
    std::map<int, int> part;  // first triangle of the part of each
    for (const int e : all) part[e] = e;
    for (bool changes = true; changes;) {
      changes = false;
      for (const auto& [a, b] : joined[node]) {
        const int least = std::min(part[a], part[b]);
        changes = changes || part[a] != part[b];
        part[a] = part[b] = least;
      }
    }
    std::map<int, int> copy;
    for (const int e : all) {
      const auto [at, is_new] = copy.try_emplace(part[e], node);
      if (is_new && copy.size() > 1) {
        at->second = static_cast<int>(nodes.size());
        nodes.push_back(nodes[static_cast<std::size_t>(node)]);
      }
      triangles[static_cast<std::size_t>(e)][find_corner(problem.triangles[static_cast<std::size_t>(e)], node)] =
          at->second;
    }
  }
}

void number_walls(const Problem& problem, const Units& units, Velocities& v) {
  const auto edges = list_wall_edges(problem);
  for (std::size_t w = 0; w < problem.walls.size(); ++w) {
    const Wall& wall = problem.walls[w];
    WallMotion motion;
    motion.ends.resize(wall.size());
    motion.rotation.resize(wall.size());
    motion.jump.assign(wall.size(), {-1, -1});  // that of the first edge is never used
    std::vector<Freedom> at = start_at_toe(edges[w].back(), v);
    motion.free = wall.size();
    while (motion.free > 0 && find_clamp(problem, edges[w][motion.free - 1], v, units)) --motion.free;
    for (std::size_t i = wall.size(); i-- > 0;) {
      const WallEdge& edge = edges[w][i];
      motion.ends[i][1] = at;
      if (i >= motion.free) {
        motion.ends[i][0] = at = *find_clamp(problem, edge, v, units);
        const double share = units.length / edge.length;
        add_form(motion.rotation[i], find_component(motion.ends[i][1], edge.normal, share));
        add_form(motion.rotation[i], find_component(motion.ends[i][0], edge.normal, -share));
      } else {
        const bool goes_on = i + 1 < wall.size() && !std::isfinite(wall.moment);
        motion.rotation[i] = goes_on ? motion.rotation[i + 1] : MotionForm{{v.count++, 1}};
        const double arm = -edge.length / units.length;
        for (const auto& [number, value] : motion.rotation[i])
          add_direction(at, {arm * value * edge.normal[0], arm * value * edge.normal[1]}, number);
        motion.ends[i][0] = at;
      }
      if (i == 0 || i > motion.free) continue;
      const WallEdge& above = edges[w][i - 1];
      if (std::isfinite(wall.axial)) add_direction(at, above.along, motion.jump[i][0] = v.count++);
      if (std::isfinite(wall.shear)) add_direction(at, above.normal, motion.jump[i][1] = v.count++);
    }
    v.walls.push_back(std::move(motion));
  }
}

void add_form(MotionForm& sum, const MotionForm& form, double times) {
  for (const auto& [number, value] : form) sum.emplace_back(number, times * value);
  std::sort(sum.begin(), sum.end());
  MotionForm merged;
  for (const auto& [number, value] : sum) {
    if (merged.empty() || merged.back().first != number) {
      merged.emplace_back(number, value);
    } else {
      merged.back().second += value;
    }
  }
  std::erase_if(merged, [](const auto& entry) { return entry.second == 0; });
  sum = std::move(merged);
}

MotionForm find_component(const std::vector<Freedom>& freedoms, const Vec<2>& direction, double times) {
  MotionForm form;
  for (const Freedom& f : freedoms) form.emplace_back(f.number, times * dot(f.direction, direction));
  MotionForm sum;
  add_form(sum, form);
  return sum;
}

const std::vector<Freedom>& find_wall_velocity(const WallMotion& motion, std::size_t node) {
  return node < motion.ends.size() ? motion.ends[node][0] : motion.ends.back()[1];
}

std::vector<Contact> list_contacts(const Problem& problem, const Velocities& v) {
  std::vector<Contact> contacts;
  const auto edges = list_wall_edges(problem);
  for (std::size_t w = 0; w < problem.walls.size(); ++w)
    for (std::size_t i = 0; i < v.walls[w].free; ++i)
      for (const std::size_t side : {0, 1}) {
        const WallEdge& edge = edges[w][i];
        if (!edge.face[side]) continue;
        const std::array<int, 3> nodes = find_face_nodes(v, *edge.face[side]);
        const double sign = side == 0 ? 1 : -1;
        const Vec<2> outward{sign * edge.normal[0], sign * edge.normal[1]};
        const auto& ends = v.walls[w].ends[i];
        for (std::size_t k = 0; k < 3; ++k) {
          Contact contact{w, problem.walls[w].interface[i][side].find_largest(), edge.length / 3, 0, {}, {}};
          for (std::size_t p = 0; p < 2; ++p)
            contact.pressure +=
                3 * bernstein[k][p] * problem.pore_pressure[edge.face[side]->triangle][edge.face[side]->corner[p]];
          const auto add = [&](const std::vector<Freedom>& freedoms, double times) {
            if (times == 0) return;
            add_form(contact.opening, find_component(freedoms, outward, times));
            add_form(contact.slip, find_component(freedoms, edge.along, times));
          };
          for (std::size_t p = 0; p < 3; ++p) add(v.freedoms[static_cast<std::size_t>(nodes[p])], points[k][p]);
          add(ends[0], k == 0 ? -1 : k == 1 ? -0.5 : 0), add(ends[1], k == 2 ? -1 : k == 1 ? -0.5 : 0);
          if (!contact.opening.empty() || !contact.slip.empty()) contacts.push_back(std::move(contact));
        }
      }
  return contacts;
}

std::vector<MotionForm> list_shortenings(const Wall& wall, const WallMotion& motion) {
  std::vector<MotionForm> forms;
  for (const Strut& strut : wall.struts)
    forms.push_back(find_component(find_wall_velocity(motion, find_wall_node(wall, strut.node)), {strut.way, 0}));
  return forms;
}

std::vector<OpeningLimit> list_opening_limits(const Problem& problem, const Velocities& v) {
  std::vector<OpeningLimit> limits;
  for (Contact& c : list_contacts(problem, v))
    limits.push_back({std::move(c.opening), std::move(c.slip), c.strength.tan_friction});
  for (std::size_t w = 0; w < problem.walls.size(); ++w) {
    const auto shortenings = list_shortenings(problem.walls[w], v.walls[w]);
    for (std::size_t s = 0; s < shortenings.size(); ++s) {
      if (std::isfinite(problem.walls[w].struts[s].strength)) continue;
      OpeningLimit& limit = limits.emplace_back();
      add_form(limit.opening, shortenings[s], -1);
    }
  }
  return limits;
}

double evaluate(const MotionForm& form, const std::vector<double>& numbers) {
  double sum = 0;
  for (const auto& [number, value] : form) sum += value * numbers[static_cast<std::size_t>(number)];
  return sum;
}

}  // namespace talus::bounds
