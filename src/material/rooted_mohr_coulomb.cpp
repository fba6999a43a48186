// SPDX-License-Identifier: MIT
#include "material/rooted_mohr_coulomb.hpp"

#include <algorithm>
#include <numbers>

namespace talus::material {

namespace {

double find_area(const RootClass& roots) {
  return 0.25 * std::numbers::pi * roots.diameter * roots.diameter;
}

/// Returns the tensile force at failure of one root [N].
double find_force(const RootClass& roots) {
  return roots.strength * find_area(roots);
}

}  // namespace

double find_wu_waldron_cohesion(const std::vector<RootClass>& roots, double orientation) {
  double sum = 0;
  for (const RootClass& r : roots) sum += r.strength * r.area_ratio;
  return orientation * sum;
}

double find_fibre_bundle_cohesion(std::vector<RootClass> roots, double orientation) {
  std::sort(roots.begin(), roots.end(),
            [](const RootClass& a, const RootClass& b) { return find_force(a) > find_force(b); });
  double number = 0, largest = 0;  // number per area of roots at least as strong [1/m²]; load per area [Pa]
  for (const RootClass& r : roots) {
    number += r.area_ratio / find_area(r);
    largest = std::max(largest, find_force(r) * number);
  }
  return orientation * largest;
}

}  // namespace talus::material
