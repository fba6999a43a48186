// SPDX-License-Identifier: MIT
#pragma once
// Differences by field between a body of the MPM step and the same body of the plain two-velocity step.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mpm/solver/observe.hpp"
#include "reference/plain_two_phase.hpp"

namespace talus::golden {

/// The largest difference of a field, and the largest value that it is measured by.
struct FieldDifference {
  std::string name;
  double difference = 0, scale = 0;
  int where = -1;  ///< point, or number of the surface condition

  void add(double plain, double fast, int number) {
    scale = std::max(scale, std::abs(plain));
    const double d = std::abs(plain - fast);
    if (!(d <= difference) && !std::isnan(difference)) difference = d, where = number;  // a NaN counts, and stays
  }
  double relative() const { return difference / scale; }
};

/// Differences of all points that are left. Fields that are about zero in a body without failure have a least scale.
template <int D>
std::vector<FieldDifference> compare_points(const reference::WetBody<D>& plain, const mpm::Body<D>& body) {
  constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  enum { element, position, solid, water, stress, strain, plastic, volume, pressure, mass, saturation, fields };
  std::vector<FieldDifference> r(fields);
  const char* const names[] = {"element",        "position", "velocity", "water velocity", "stress",    "strain",
                               "plastic strain", "volume",   "pressure", "water mass",     "saturation"};
  for (std::size_t f = 0; f < fields; ++f) r[f].name = names[f];
  r[element].scale = r[position].scale = 1;
  r[strain].scale = r[plastic].scale = r[saturation].scale = 1;
  for (const reference::WetPoint<D>& p : plain.points) {
    r[element].add(0, p.element == reference::at(body.points.element, p.id) ? 0 : 1, p.id);
    if (!mpm::is_present(body, p.id)) continue;
    const auto q = mpm::view_point(body, p.id);
    for (int d = 0; d < D; ++d) {
      r[position].add(p.x[d], q.position[d], p.id);
      r[solid].add(p.v[d], q.velocity[d], p.id);
    }
    for (std::size_t i = 0; i < q.stress.size(); ++i) {
      r[stress].add(p.sigma(row[i], column[i]), q.stress[i], p.id);
      r[strain].add(p.strain(row[i], column[i]) * (i < 3 ? 1 : 2), q.strain[i], p.id);
    }
    r[plastic].add(p.plastic_strain, q.plastic_strain, p.id);
    r[volume].add(p.volume, q.volume, p.id);
    const reference::Soil& soil = reference::soil_of(plain, p);
    if (soil.wet != q.wet) r[water].add(0, NAN, p.id);
    for (int d = 0; d < D && soil.wet; ++d) r[water].add(p.w[d], q.water_velocity[d], p.id);
    r[pressure].add(p.pressure, q.pressure, p.id);
    r[mass].add(p.water_mass, q.water_mass, p.id);
    r[saturation].add(soil.wet ? soil.water.saturation(p.pressure) : 0.0, q.saturation, p.id);
  }
  return r;
}

/// Differences of the water's budgets, condition by condition, relative to the largest of all.
template <int D>
std::vector<FieldDifference> compare_budgets(const reference::WetBody<D>& plain, const mpm::Body<D>& body) {
  std::vector<reference::WaterBudget> sums(body.water.surfaces.size());
  for (std::size_t i = 0; i < plain.node_budgets.size(); ++i)
    reference::at(sums, body.water.surface_of_node[i]) += plain.node_budgets[i];
  std::vector<FieldDifference> r(5);
  const char* const names[] = {"entered", "left", "supplied", "runoff", "lost between"};
  for (std::size_t f = 0; f < 5; ++f) r[f].name = names[f];
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const mpm::SurfaceBudget& b = body.water.budgets[c];
    const int number = static_cast<int>(c);
    r[0].add(sums[c].entered, b.entered, number);
    r[1].add(sums[c].left, b.left, number);
    r[2].add(sums[c].supplied, b.supplied, number);
    r[3].add(sums[c].runoff, b.runoff, number);
  }
  r[4].add(plain.budget.lost_between, body.water.lost_between, -1);
  double scale = 0;
  for (const FieldDifference& f : r) scale = std::max(scale, f.scale);
  for (FieldDifference& f : r) f.scale = scale;
  return r;
}

}  // namespace talus::golden
