// SPDX-License-Identifier: MIT
#pragma once
// Runs the MPM step and the plain two-velocity step side by side and compares them after every step.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "golden/wet_comparison.hpp"
#include "golden/wet_translation.hpp"
#include "reference/wet_slope.hpp"

namespace talus::golden {

inline constexpr double tolerance = 1e-10;

struct Variant {
  std::string name;
  reference::WetSettings settings;
  double conductivity_factor = 1;
  int chunks = 3;
};

/// Events on the way: a case without them tests nothing.
struct Seen {
  int changed = 0, left = 0, emptied = 0, occupied = 0;  ///< points; elements
  double largest_plastic = 0, entered = 0, left_water = 0;
};

template <int D>
std::vector<bool> find_active(const reference::WetBody<D>& body) {
  std::vector<bool> active(body.mesh.elements.size(), false);
  for (const auto& p : body.points) active[static_cast<std::size_t>(p.element)] = true;
  return active;
}

template <int D>
void count_changes(const reference::WetBody<D>& before, const reference::WetBody<D>& after, Seen& seen) {
  std::vector<int> element;
  for (const auto& p : before.points) {
    if (p.id >= static_cast<int>(element.size())) element.resize(static_cast<std::size_t>(p.id) + 1, -1);
    reference::at(element, p.id) = p.element;
  }
  for (const auto& p : after.points) {
    seen.changed += p.element != reference::at(element, p.id);
    seen.largest_plastic = std::max(seen.largest_plastic, p.plastic_strain);
  }
  const std::vector<bool> was = find_active(before), is = find_active(after);
  for (std::size_t e = 0; e < was.size(); ++e) {
    seen.emptied += was[e] && !is[e];
    seen.occupied += !was[e] && is[e];
  }
  seen.left = after.left;
  seen.entered = after.budget.entered;
  seen.left_water = after.budget.left;
}

/// The first field that differs by more than the tolerance of its largest value so far.
inline void expect_close(const std::vector<FieldDifference>& fields, std::vector<double>& scales,
                         const std::string& name, int step) {
  scales.resize(fields.size(), 0);
  for (std::size_t f = 0; f < fields.size(); ++f) {
    scales[f] = std::max(scales[f], fields[f].scale);
    ASSERT_LE(fields[f].difference, tolerance * scales[f])
        << name << ", step " << step << ": " << fields[f].name << " at " << fields[f].where << ", of " << scales[f];
  }
}

/// Steps both bodies and expects agreement after every step.
template <int D>
Seen expect_same(reference::WetBody<D> plain, const Variant& v, int steps,
                 const reference::Curves& curves = reference::wet_slope_curves()) {
  mpm::Body<D> body = translate(plain, curves, v.chunks);
  mpm::StepOptions<D> options = translate(v.settings, plain);
  options.conductivity_factor = v.conductivity_factor;
  for (reference::Soil& soil : plain.soils) soil.water.conductivity *= v.conductivity_factor;
  mpm::gather_nodal_sums(body, options);
  const reference::WetBody<D> start = plain;
  std::vector<double> point_scales, budget_scales;
  for (int s = 1; s <= steps && !testing::Test::HasFatalFailure(); ++s) {
    reference::step(plain, v.settings);
    mpm::step(body, options);
    // The engine stores the common water of the points of full elements; the reference averages it in the next step,
    // and doing so now changes nothing.
    reference::classify_wet_elements(plain, v.settings);
    for (const reference::WetCell& cell : plain.cells)
      if (cell.full && cell.wet) reference::average_water(plain, cell);
    expect_close(compare_points(plain, body), point_scales, v.name, s);
    expect_close(compare_budgets(plain, body), budget_scales, v.name, s);
    EXPECT_EQ(plain.left, static_cast<int>(body.lost.size())) << v.name << ", step " << s;
    if (s == steps / 2) mpm::gather_nodal_sums(body, options);  // as a new stage does; it changes nothing
  }
  Seen seen;
  count_changes(start, plain, seen);
  return seen;
}

}  // namespace talus::golden
