// SPDX-License-Identifier: MIT
// Integration of loads over the sides of the ground, and the corners by which a mesh conforms to them.
#include "site/ground_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "site/mesh_sides.hpp"

namespace talus::site {

namespace {

/// Divisions of each edge of a triangle for the integration of its load.
constexpr int triangle_parts = 8;
/// Tolerance of the place on a side or of x, as a fraction of the length or of the section's width.
constexpr double same_place = 1e-9;
/// Depth of water below which the ground is dry, as a fraction of the section's width.
constexpr double same_level = 1e-6;

/// An integration point on a side: shape functions, and weight as a fraction of the side.
template <int D>
struct Sample {
  std::array<double, D> shape{};
  double weight = 0;
};

/// Returns Gauss's rule of two points on each part between `cuts` (places from 0 to 1 in ascending order), which is
/// exact for the moments of a load that is linear in each part.
std::vector<Sample<2>> sample_side(const std::vector<double>& cuts) {
  const double offset = 0.5 / std::numbers::sqrt3;
  std::vector<Sample<2>> samples;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double length = cuts[i + 1] - cuts[i];
    for (const double at : {0.5 - offset, 0.5 + offset}) {
      const double s = cuts[i] + at * length;
      samples.push_back({{1 - s, s}, 0.5 * length});
    }
  }
  return samples;
}

/// Returns Strang and Fix's rule of three points in each part of a triangle, exact for the moments of a linear load.
std::vector<Sample<3>> sample_triangle() {
  constexpr double n = triangle_parts;
  std::vector<Sample<3>> samples;
  const auto add = [&](const std::array<std::array<int, 2>, 3>& corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, 2> at{};
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t d = 0; d < 2; ++d) at[d] += (c == k ? 2.0 / 3 : 1.0 / 6) * corners[c][d] / n;
      samples.push_back({{at[0], at[1], 1 - at[0] - at[1]}, 1 / (3 * n * n)});
    }
  };
  for (int i = 0; i < triangle_parts; ++i)
    for (int j = 0; i + j < triangle_parts; ++j) {
      add({{{i, j}, {i + 1, j}, {i, j + 1}}});
      if (i + j + 1 < triangle_parts) add({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
    }
  return samples;
}

/// Returns the traction, linear on the side, with the forces and moments of `load`; nothing if it is zero. `cuts`: in
/// 2D the places between which the load is linear, see sample_side().
template <int D>
std::optional<std::array<Vec<D>, D>> fit_traction(const mesh::Mesh<D>& mesh, const std::array<int, D>& nodes,
                                                  const std::function<Vec<D>(const Vec<D>&)>& load,
                                                  [[maybe_unused]] const std::vector<double>& cuts) {
  std::vector<Sample<D>> samples;
  if constexpr (D == 2) {
    samples = sample_side(cuts);
  } else {
    static const auto of_triangle = sample_triangle();
    samples = of_triangle;
  }
  std::array<Vec<D>, D> moments{}, traction{};
  bool acts = false;
  for (const Sample<D>& sample : samples) {
    Vec<D> x{};
    for (std::size_t c = 0; c < D; ++c)
      for (std::size_t d = 0; d < D; ++d) x[d] += sample.shape[c] * mesh.nodes[nodes[c]][d];
    const Vec<D> t = load(x);
    for (std::size_t c = 0; c < D; ++c)
      for (std::size_t d = 0; d < D; ++d) moments[c][d] += sample.shape[c] * t[d] * sample.weight;
    acts = acts || norm(t) > 0;
  }
  if (!acts) return std::nullopt;
  // ∫ N_i N_j = (1 + δ_ij)/(D(D+1)) of the area of the side.
  for (std::size_t d = 0; d < D; ++d) {
    double sum = 0;
    for (std::size_t c = 0; c < D; ++c) sum += moments[c][d];
    for (std::size_t c = 0; c < D; ++c) traction[c][d] = D * (D + 1) * (moments[c][d] - sum / (D + 1));
  }
  return traction;
}

/// Calls visit(side) for each side of the soil without soil behind it.
template <int D, class Visit>
void visit_faces(const mesh::Mesh<D>& mesh, Visit visit) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    for (int k = 0; k <= D; ++k) {
      const int behind = mesh.neighbours[e][k];
      if (behind >= 0 && mesh.element_region[behind] != mesh::empty_region) continue;
      GroundSide<D> side;
      side.normal = find_outward_normal(mesh, e, k).first;
      std::size_t n = 0;
      for (int j = 0; j <= D; ++j)
        if (j != k) side.nodes[n++] = mesh.elements[e][j];
      visit(side);
    }
  }
}

constexpr double steepest = 1e-6;

/// Returns the vertical steps of the ground, on which standing water acts too, without the ends of the section.
template <int D>
std::vector<GroundSide<D>> list_steps(const mesh::Mesh<D>& mesh, const Polyline& ground) {
  std::vector<GroundSide<D>> steps;
  const double least = same_place * (ground.back()[0] - ground.front()[0]);
  visit_faces(mesh, [&](const GroundSide<D>& side) {
    const double x = mesh.nodes[side.nodes[0]][0];
    const bool is_inside = x > ground.front()[0] + least && x < ground.back()[0] - least;
    if (is_inside && std::abs(side.normal[0]) > 1 - steepest) steps.push_back(side);
  });
  return steps;
}

/// Extent of the mesh along x [m].
template <int D>
double find_width(const mesh::Mesh<D>& mesh) {
  const auto by_x = [](const Vec<D>& a, const Vec<D>& b) { return a[0] < b[0]; };
  const auto [left, right] = std::minmax_element(mesh.nodes.begin(), mesh.nodes.end(), by_x);
  return (*right)[0] - (*left)[0];
}

/// Returns the heads and pressures of the case by the sides of the mesh that have them, nodes in increasing order.
template <int D>
std::map<std::array<int, D>, const input::Hydraulic*> map_prescribed_water(const input::Case& data,
                                                                           const mesh::Mesh<D>& mesh) {
  std::map<std::array<int, D>, const input::Hydraulic*> prescribed;
  for (const input::Hydraulic& h : data.hydraulics) {
    const auto sides = mesh.sides.find(h.on);
    const bool is_head = h.condition == input::WaterCondition::total_head;
    if (sides == mesh.sides.end() || (!is_head && h.condition != input::WaterCondition::pressure)) continue;
    for (std::array<int, D> nodes : sides->second) {
      std::sort(nodes.begin(), nodes.end());
      prescribed[nodes] = &h;
    }
  }
  return prescribed;
}

/// Returns the x between which all loads on the ground are linear [m], except where a water level meets the ground.
std::vector<double> list_breaks(const Site& site, bool has_water) {
  std::vector<double> breaks;
  for (const input::Surcharge& s : site.data().surcharges) breaks.insert(breaks.end(), s.x.begin(), s.x.end());
  for (const input::Slurry& s : site.data().slurries) breaks.insert(breaks.end(), s.x.begin(), s.x.end());
  if (has_water) {
    for (const Pond& p : site.ponds()) breaks.push_back(p.from[0]), breaks.push_back(p.to[0]);
    for (const Point& x : site.water_table()) breaks.push_back(x[0]);
  }
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

/// Returns the places from 0 to 1 at which a side is cut: the breaks, and the zeros of the water `depth` between them.
std::vector<double> cut_side(const Point& a, const Point& b, const std::vector<double>& breaks,
                             const std::function<double(double)>& depth) {
  std::vector<double> cuts{0, 1};
  const double run = b[0] - a[0];
  for (const double x : breaks) {
    const double s = run != 0 ? (x - a[0]) / run : -1;
    if (s > same_place && s < 1 - same_place) cuts.push_back(s);
  }
  std::sort(cuts.begin(), cuts.end());
  if (!depth) return cuts;
  const std::size_t parts = cuts.size() - 1;
  for (std::size_t i = 0; i < parts; ++i) {
    // The depth is linear inside the part; at its ends the level may jump.
    const double length = cuts[i + 1] - cuts[i], p = depth(cuts[i] + length / 3), q = depth(cuts[i] + 2 * length / 3);
    const double at = p == q ? -1 : 1.0 / 3 + p / (3 * (p - q));
    if (at > same_place && at < 1 - same_place) cuts.push_back(cuts[i] + at * length);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/// Depth of a place on a side below the surface of a liquid [m]; negative above it.
template <int D>
using Depth = std::function<double(const GroundSide<D>&, const Vec<D>&)>;

/// Water or a slurry on the ground.
template <int D>
struct Liquid {
  std::string name;
  double weight = 0;  ///< [N/m³]
  Depth<D> depth;
};

/// Returns the x at which the table is read for a place of a vertical face: beside it, and beyond a step there.
double find_outside(const Polyline& table, double x, double normal, double near) {
  for (std::size_t i = 1; i < table.size(); ++i)
    if (is_step(table[i - 1], table[i]) && x >= table[i - 1][0] - near && x <= table[i][0] + near)
      return normal > 0 ? table[i][0] + near : table[i - 1][0] - near;
  return x + near * normal;
}

template <int D>
std::vector<Liquid<D>> list_liquids(const Site& site, const mesh::Mesh<D>& mesh, bool has_water) {
  std::vector<Liquid<D>> liquids;
  const auto step_aside = [&site](const GroundSide<D>& side,
                                  const Vec<D>& x) {  // a step is loaded by what is beside it
    const double beside = same_place * (site.ground().back()[0] - site.ground().front()[0]);
    return x[0] + (side.normal[1] <= steepest ? beside * side.normal[0] : 0);
  };
  for (const input::Slurry& slurry : site.data().slurries)
    liquids.push_back({slurry.name, slurry.unit_weight, [&slurry, step_aside](const auto& side, const Vec<D>& x) {
                         const double at = step_aside(side, x);
                         return at > slurry.x[0] && at < slurry.x[1] ? slurry.level - x[1] : -1.0;
                       }});
  if (!has_water) return liquids;
  // Below a water table that the ground rises above, the depth is negative and linear, so that its zero is found.
  liquids.push_back(
      {"standing water", site.water_weight(), [&site, &mesh, step_aside](const auto& side, const Vec<D>& x) {
         const double at = step_aside(side, x);
         std::optional<double> level = find_standing_level(site.ponds(), {}, site.ground(), at);
         if (const Polyline& table = site.water_table(); !table.empty()) {
           double middle = 0;
           for (const int node : side.nodes) middle += mesh.nodes[node][0] / D;
           const double near = same_place * (site.ground().back()[0] - site.ground().front()[0]);
           const double here =
               find_water_table(table, side.normal[1] <= steepest ? find_outside(table, x[0], side.normal[0], near)
                                                                  : leave_steps(table, at, middle));
           level = std::max(level.value_or(here), here);
         }
         return level ? *level - x[1] : -1.0;
       }});
  return liquids;
}

}  // namespace

template <int D>
std::vector<GroundSide<D>> find_ground_sides(const mesh::Mesh<D>& mesh) {
  std::vector<GroundSide<D>> ground;
  visit_faces(mesh, [&](const GroundSide<D>& side) {
    if (side.normal[1] > steepest) ground.push_back(side);
  });
  return ground;
}

template <int D>
void check_standing_water(const Site& site, const mesh::Mesh<D>& mesh, const ActingLoads& acting) {
  const input::Case& data = site.data();
  if (site.has_ground() || (site.water_table().empty() && data.hydraulics.empty())) return;
  const std::vector<GroundSide<D>> sides = find_ground_sides(mesh);
  const std::map<std::array<int, D>, const input::Hydraulic*> prescribed = map_prescribed_water(data, mesh);
  const double least = same_level * find_width(mesh), time = find_first_time(data);
  for (const GroundSide<D>& side : sides) {
    std::array<int, D> nodes = side.nodes;
    std::sort(nodes.begin(), nodes.end());
    const auto found = prescribed.find(nodes);
    const input::Hydraulic* given = found == prescribed.end() ? nullptr : found->second;
    if (given != nullptr && !acting.hydraulics) continue;
    for (const int node : nodes) {
      const Vec<D>& x = mesh.nodes[node];
      double depth =
          site.water_table().empty() || !acting.standing_water ? 0 : find_water_table(site.water_table(), x[0]) - x[1];
      if (given != nullptr)
        depth = given->condition == input::WaterCondition::total_head ? given->values().at(time) - x[1]
                                                                      : given->values().at(time) / site.water_weight();
      if (depth <= least) continue;
      const ShownUnit& length = data.units().length;
      throw Error(ExitCode::wrong_input,
                  fmt::format("water stands {} deep on the ground at {}, and its weight is applied only to a ground of "
                              "polygons or layers without overhangs: describe the section by these, or lower the water "
                              "to the ground",
                              format_value(depth, length, 3), format_point(Point{x[0], x[1]}, length)));
    }
  }
}

template <int D>
std::vector<fem::SurfaceLoad<D>> make_surface_loads(const Site& site, const mesh::Mesh<D>& mesh,
                                                    const ActingLoads& acting) {
  check_standing_water(site, mesh, acting);
  std::vector<fem::SurfaceLoad<D>> loads;
  const input::Case& data = site.data();
  std::vector<GroundSide<D>> sides = find_ground_sides(mesh);
  const bool has_water =
      acting.standing_water && site.has_ground() && !(site.ponds().empty() && site.water_table().empty());
  const std::vector<double> breaks = list_breaks(site, has_water);
  const auto add = [&](const char* name, const std::function<Vec<D>(const GroundSide<D>&, const Vec<D>&)>& find,
                       const Depth<D>& find_depth) {
    fem::SurfaceLoad<D> load;
    load.name = name;
    for (const GroundSide<D>& side : sides) {
      std::vector<double> cuts;
      if constexpr (D == 2) {
        const Vec<2>&a = mesh.nodes[side.nodes[0]], &b = mesh.nodes[side.nodes[1]];
        std::function<double(double)> depth;
        if (find_depth)
          depth = [&](double s) {
            return find_depth(side, Vec<2>{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])});
          };
        cuts = cut_side({a[0], a[1]}, {b[0], b[1]}, breaks, depth);
      }
      const auto t = fit_traction<D>(
          mesh, side.nodes, [&](const Vec<D>& x) { return find(side, x); }, cuts);
      if (!t) continue;
      load.sides.push_back(side.nodes);
      load.traction.push_back(*t);
    }
    if (!load.sides.empty()) loads.push_back(std::move(load));
  };
  if (!data.surcharges.empty())
    add("surcharges",
        [&](const GroundSide<D>& side, const Vec<D>& x) {
          Vec<D> t{};
          t[1] = -site.find_surcharge(x[0]) * side.normal[1];
          return t;
        },
        {});
  const std::vector<Liquid<D>> liquids = list_liquids<D>(site, mesh, has_water);
  if (!liquids.empty())
    for (const GroundSide<D>& step : list_steps(mesh, site.ground())) sides.push_back(step);
  for (const Liquid<D>& liquid : liquids)
    add(
        liquid.name.c_str(),
        [&](const GroundSide<D>& side, const Vec<D>& x) {
          Vec<D> t{};
          const double pressure = liquid.weight * std::max(0.0, liquid.depth(side, x));
          for (std::size_t d = 0; d < D; ++d) t[d] = -pressure * side.normal[d];
          return t;
        },
        liquid.depth);
  if (!acting.tractions) return loads;
  for (const input::Traction& traction : data.tractions) {
    fem::SurfaceLoad<D> load;
    load.name = traction.on;
    Vec<D> t;
    for (std::size_t d = 0; d < D; ++d) t[d] = traction.traction[d] * traction.factor.at(0);
    for (const auto& side : find_sides(mesh, traction.on)) {
      load.sides.push_back(side);
      load.traction.emplace_back();
      load.traction.back().fill(t);
    }
    loads.push_back(std::move(load));
  }
  return loads;
}

#define TALUS_INSTANTIATE(D)                                                                         \
  template std::vector<GroundSide<D>> find_ground_sides<D>(const mesh::Mesh<D>&);                    \
  template void check_standing_water<D>(const Site&, const mesh::Mesh<D>&, const ActingLoads&);      \
  template std::vector<fem::SurfaceLoad<D>> make_surface_loads<D>(const Site&, const mesh::Mesh<D>&, \
                                                                  const ActingLoads&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

namespace {

/// Distance from a corner below which a place coincides with it, as a fraction of the section's width.
constexpr double same_corner = 1e-7;

/// Adds the intersections of the water table with the ground, and its vertices above the ground.
void add_table(const Polyline& table, const Polyline& ground, std::vector<double>& places) {
  std::vector<double> breaks;
  for (const Point& x : table) breaks.push_back(x[0]);
  for (const Point& x : ground) breaks.push_back(x[0]);
  std::sort(breaks.begin(), breaks.end());
  const auto find_depth = [&](double x) { return find_water_table(table, x) - find_level(ground, x); };
  for (const Point& x : table)
    if (find_depth(x[0]) > 0) places.push_back(x[0]);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    // Both lines are straight between two breaks; at a step of the ground its level jumps.
    const double length = breaks[i + 1] - breaks[i];
    if (!(length > 0)) continue;
    const double from = breaks[i] + length / 3, to = breaks[i] + 2 * length / 3;
    if (is_step({from, find_water_table(table, from)}, {to, find_water_table(table, to)})) continue;
    const double p = find_depth(breaks[i] + length / 3), q = find_depth(breaks[i] + 2 * length / 3);
    const double at = p == q ? -1 : 1.0 / 3 + p / (3 * (p - q));
    if (at > 0 && at < 1) places.push_back(breaks[i] + at * length);
  }
}

std::vector<Point> list_places(const Site& site) {
  if (!needs_ground(site)) return {};
  const Polyline& ground = site.ground();
  std::vector<double> places;
  for (const input::Surcharge& s : site.data().surcharges) places.insert(places.end(), s.x.begin(), s.x.end());
  for (const Pond& p : site.ponds()) places.push_back(p.from[0]), places.push_back(p.to[0]);
  for (const input::Slurry& s : site.data().slurries) {
    places.insert(places.end(), s.x.begin(), s.x.end());
    std::vector<double> crossings;
    add_table({{s.x[0], s.level}}, ground, crossings);
    for (const double x : crossings)
      if (x > s.x[0] && x < s.x[1]) places.push_back(x);
  }
  if (!site.water_table().empty()) add_table(site.water_table(), ground, places);
  std::vector<Point> on_ground;
  for (const double x : places)
    if (x > ground.front()[0] && x < ground.back()[0]) on_ground.push_back({x, find_level(ground, x)});
  return on_ground;
}

/// Returns the corners of a polygon together with those of `places` that lie on its outline.
Polyline add_corners(const Polyline& corners, const std::vector<Point>& places, double least) {
  Polyline all;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    std::vector<double> along;
    for (const Point& x : places) {
      const double s = ((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / length,
                   off = ((x[0] - a[0]) * dy - (x[1] - a[1]) * dx) / length;
      if (s > least && s < length - least && std::abs(off) <= least) along.push_back(s / length);
    }
    std::sort(along.begin(), along.end());
    all.push_back(a);
    for (std::size_t k = 0; k < along.size(); ++k)
      if (k == 0 || (along[k] - along[k - 1]) * length > least)
        all.push_back({a[0] + along[k] * dx, a[1] + along[k] * dy});
  }
  return all;
}

}  // namespace

bool needs_ground(const Site& site) {
  const input::Case& data = site.data();
  return site.has_ground() || !data.surcharges.empty() || !data.slurries.empty() || !data.hydraulics.empty() ||
         data.initial.water.pressure != input::InitialPressure::zero || data.earthquake.horizontal != 0 ||
         data.earthquake.vertical != 0;
}

mesh::Plan add_corners(mesh::Plan plan, const std::vector<Point>& places, double tolerance) {
  for (mesh::Polygon& polygon : plan.polygons) polygon.points = add_corners(polygon.points, places, tolerance);
  return plan;
}

mesh::Plan conform_to_loads(const Site& site, mesh::Plan plan) {
  if (plan.dimension != 2 || !plan.file.empty() || plan.polygons.empty()) return plan;
  const std::vector<Point> places = list_places(site);
  if (places.empty()) return plan;
  const double least = same_corner * (site.ground().back()[0] - site.ground().front()[0]);
  return add_corners(std::move(plan), places, least);
}

}  // namespace talus::site
