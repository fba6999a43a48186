// SPDX-License-Identifier: MIT
// Lines of a case at which strength or pore pressure of its soils bends or jumps, and what is curved between them.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "run/bounds/case_fields.hpp"
#include "run/bounds/soil_kinks.hpp"
#include "site/initial_water.hpp"
#include "site/weights.hpp"

namespace talus::run {

namespace {

using mesh::Polyline;

/// Returns the plan of the mesh; of a mesh from a file its box and its named lines, side by side.
mesh::Plan find_plan(const input::Case& data, const mesh::Mesh<2>& mesh) {
  if (data.mesh.file.empty()) return data.mesh;
  mesh::Plan plan = data.mesh;
  plan.box_min = plan.box_max = mesh.nodes.front();
  for (const Vec<2>& x : mesh.nodes)
    for (std::size_t d = 0; d < 2; ++d) {
      plan.box_min[d] = std::min(plan.box_min[d], x[d]);
      plan.box_max[d] = std::max(plan.box_max[d], x[d]);
    }
  for (const auto& [name, sides] : mesh.sides)
    for (const auto& side : sides)
      plan.lines.push_back(
          {name, {mesh.nodes[static_cast<std::size_t>(side[0])], mesh.nodes[static_cast<std::size_t>(side[1])]}});
  return plan;
}

/// Adds the line in each triangle on which values at the nodes are `value`.
void add_contour(const mesh::Mesh<2>& mesh, const std::vector<double>& nodal, double value,
                 std::vector<Polyline>& lines) {
  for (const auto& nodes : mesh.elements) {
    Polyline line;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(nodes[i]), b = static_cast<std::size_t>(nodes[(i + 1) % 3]);
      if ((nodal[a] > value) == (nodal[b] > value)) continue;
      const double s = (value - nodal[a]) / (nodal[b] - nodal[a]);
      line.push_back({mesh.nodes[a][0] + s * (mesh.nodes[b][0] - mesh.nodes[a][0]),
                      mesh.nodes[a][1] + s * (mesh.nodes[b][1] - mesh.nodes[a][1])});
    }
    if (line.size() == 2) lines.push_back(std::move(line));
  }
}

/// Adds the sides of triangles across which the gradient of values at the nodes changes, and those of one triangle.
void add_bends(const mesh::Mesh<2>& mesh, const std::vector<double>& nodal, std::vector<Polyline>& lines) {
  constexpr double same = 1e-9;
  const auto node = [&](int n) -> const Vec<2>& { return mesh.nodes[static_cast<std::size_t>(n)]; };
  const auto value = [&](int n) { return nodal[static_cast<std::size_t>(n)]; };
  std::map<std::pair<int, int>, std::vector<Vec<2>>> gradients;  // by side, of its triangles
  double steepest = 0;
  for (const auto& t : mesh.elements) {
    const Vec<2>&a = node(t[0]), &b = node(t[1]), &c = node(t[2]);
    const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - a[0], vy = c[1] - a[1], det = ux * vy - uy * vx,
                 du = value(t[1]) - value(t[0]), dv = value(t[2]) - value(t[0]);
    const Vec<2> gradient{(du * vy - dv * uy) / det, (dv * ux - du * vx) / det};
    steepest = std::max(steepest, norm(gradient));
    for (std::size_t i = 0; i < 3; ++i) gradients[std::minmax(t[i], t[(i + 1) % 3])].push_back(gradient);
  }
  for (const auto& [side, both] : gradients) {
    const bool is_straight = both.size() == 2 && std::abs(both[0][0] - both[1][0]) <= same * steepest &&
                             std::abs(both[0][1] - both[1][1]) <= same * steepest;
    if (!is_straight) lines.push_back({node(side.first), node(side.second)});
  }
}

/// Returns true if the effect of suction on the effective stress is not proportional to it.
bool has_curved_suction(const input::Material& soil) {
  constexpr double suction = 1e4;  // [Pa]
  const double once = site::find_suction_stress(soil, suction), twice = site::find_suction_stress(soil, 2 * suction);
  return std::abs(twice - 2 * once) > 1e-9 * suction;
}

}  // namespace

std::vector<Polyline> CaseFields::list_kinks() const {
  const mesh::Plan plan = find_plan(data_, mesh_);
  const input::InitialWater& water = data_.initial.water;
  std::vector<Polyline> lines;
  bool has_computed = false, has_given = false, takes_ratio = false, takes_overburden = false;
  for (const Soil& soil : soils_) {
    for (Polyline& line : run::list_kinks(site_, plan, soil.material, KinkDetail::every))
      lines.push_back(std::move(line));
    const site::PressureSource source = site::find_pressure_source(data_, soil.material);
    has_computed = has_computed || source == site::PressureSource::computed;
    has_given = has_given || source == site::PressureSource::given;
    takes_ratio = takes_ratio || soil.material.slices.pore_pressure_ratio != 0;
    takes_overburden = takes_overburden || material::needs<material::ShansepInput>(soil.material.model);
  }
  const auto add_vertical = [&](double x) { lines.push_back({{x, plan.box_min[1]}, {x, plan.box_max[1]}}); };
  if (takes_overburden) {
    for (const double x : columns_.list_breaks()) add_vertical(x);
    for (Polyline& line : columns_.list_water_lines()) lines.push_back(std::move(line));
  }
  if (has_computed && water.known) {
    add_bends(water.known->mesh, water.known->pressure, lines);
    add_contour(water.known->mesh, water.known->pressure, 0, lines);
  } else if (has_computed) {
    add_contour(cut_, nodal_, 0, lines);
  }
  if (has_given && site::has_pressure_field(data_) && water.field->kind() == mesh::Scatter::linear) {
    const mesh::Mesh<2>& triangles = water.field->triangles();
    std::vector<double> pressure;
    for (std::size_t i = 0; i < triangles.nodes.size(); ++i)
      pressure.push_back(site_.water_weight() * (triangles.nodes[i][1] - water.field->values()[i]));
    add_bends(triangles, pressure, lines);
    add_contour(triangles, pressure, 0, lines);
    if (std::isfinite(water.largest_suction)) add_contour(triangles, pressure, water.largest_suction, lines);
  }
  if (takes_ratio_grid() && !takes_spline()) {
    add_bends(water.field->triangles(), water.field->values(), lines);
    for (const double limit : {0.0, 1.0}) add_contour(water.field->triangles(), water.field->values(), limit, lines);
  }
  if (takes_ratio || takes_ratio_grid())
    for (const mesh::Polygon& polygon : plan.polygons)
      for (const auto& x : polygon.points) add_vertical(x[0]);
  return lines;
}

bool CaseFields::has_curved_strength(std::size_t triangle) const {
  const Soil& soil = get_soil(triangle);
  const input::Material& m = soil.material;
  if (!data_.roots.empty() && m.traits().roots == material::RootEffect::cohesion) return true;
  const StrengthLaw* law = soil.get_law();
  if (!law || law->is_curved) return false;
  // σ'_v bends on the sides of triangles that have pore pressures of their own.
  const bool has_own_pressures = site::needs_seepage(data_) || site::has_pressure_field(data_);
  if (has_own_pressures && material::needs<material::ShansepInput>(m.model)) return true;
  return m.profile_x.size() > 1 || !m.profile_ocr.empty() || !m.profile_preconsolidation.empty();
}

/// An interpolation between profiles is a product of x and the depth. With the difference Δg of the gradients of two
/// profiles it differs from a linear function by up to Δg/4 times the depth times the share of their distance.
double CaseFields::find_product_error(std::size_t triangle, const std::array<Vec<2>, 3>& corners) const {
  const input::Material& m = get_soil(triangle).material;
  const std::vector<double>& x = m.profile_x;
  const std::vector<double>& places = m.profile_levels.empty() ? m.profile_depths : m.profile_levels;
  if (x.size() < 2 || places.size() < 2 || m.profile_strengths.empty()) return 0;
  const auto [left, right] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
  const double height = m.profile_depths.empty() ? std::max({corners[0][1], corners[1][1], corners[2][1]}) -
                                                       std::min({corners[0][1], corners[1][1], corners[2][1]})
                                                 : find_reach(corners);
  double most = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double width = std::min(right, x[i]) - std::max(left, x[i - 1]), share = width / (x[i] - x[i - 1]);
    if (!(width > 0)) continue;
    for (std::size_t k = 1; k < places.size(); ++k) {
      const auto find_rise = [&](std::size_t profile) {
        const double* value = m.profile_strengths.data() + profile * places.size();
        return value[k] - value[k - 1];
      };
      most = std::max(
          most, 0.25 * share * height * std::abs((find_rise(i) - find_rise(i - 1)) / (places[k] - places[k - 1])));
    }
  }
  return most;
}

bool CaseFields::has_curved_pressure(std::size_t triangle) const {
  return has_curved_suction(get_soil(triangle).material) || takes_spline();
}

bool CaseFields::takes_ratio_grid() const {
  const input::InitialWater& water = data_.initial.water;
  return water.pressure == input::InitialPressure::grid && water.field && !site::has_pressure_field(data_);
}

/// A product of two linear functions differs from the linear one between the corners of a triangle by
/// Σ λ_i λ_j Δr Δσ ≤ Δr Δσ/3. The overburden grows with the depth, and sideways as the ground rises.
double CaseFields::find_ratio_error(std::size_t triangle, const std::array<Vec<2>, 3>& corners,
                                    const std::vector<Vec<2>>& places) const {
  if (!takes_ratio_grid() || takes_spline()) return 0;
  const Soil& soil = get_soil(triangle);
  double least = 1, most = 0, heaviest = 0;
  for (const Vec<2>& x : places) {
    const double ratio = site::find_pressure_ratio<2>(data_, soil.material, x);
    least = std::min(least, ratio), most = std::max(most, ratio);
  }
  for (const double weight : water_.unit_weight) heaviest = std::max(heaviest, weight);
  return std::max(0.0, most - least) * heaviest * find_reach(corners) / 3;
}

double CaseFields::find_reach(const std::array<Vec<2>, 3>& corners) const {
  const auto [left, right] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
  const auto [low, high] = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
  double steepest = 0;
  if (site_.has_ground())
    for (std::size_t i = 1; i < site_.ground().size(); ++i) {
      const auto &a = site_.ground()[i - 1], &b = site_.ground()[i];
      if (b[0] > left && a[0] < right && b[0] > a[0])
        steepest = std::max(steepest, std::abs((b[1] - a[1]) / (b[0] - a[0])));
    }
  return high - low + steepest * (right - left);
}

bool CaseFields::takes_spline() const {
  const input::InitialWater& water = data_.initial.water;
  return water.pressure == input::InitialPressure::grid && water.field &&
         water.field->kind() == mesh::Scatter::thin_plate;
}

}  // namespace talus::run
