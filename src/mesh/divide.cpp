// SPDX-License-Identifier: MIT
#include "mesh/divide.hpp"

#include <algorithm>
#include <cmath>

namespace talus::mesh {
namespace {

/// Share of the soil that moved across that is a side of its own at least [-].
constexpr double least_side = 0.05;
/// Share of the smaller side that may lie on the wrong side of the divide [-].
constexpr double most_mixed = 0.25;

}  // namespace

std::optional<Divide> find_divide(std::vector<MovedSoil> soil, double threshold) {
  std::erase_if(soil, [&](const MovedSoil& s) { return !(std::abs(s.across) > threshold); });
  std::stable_sort(soil.begin(), soil.end(), [](const MovedSoil& a, const MovedSoil& b) { return a.x < b.x; });
  double to_left = 0, to_right = 0;
  for (const MovedSoil& s : soil) (s.across < 0 ? to_left : to_right) += s.amount;
  const double all = to_left + to_right, smaller = std::min(to_left, to_right);
  if (!(smaller > 0) || smaller < least_side * all) return std::nullopt;
  // Soil on the wrong side when that on the left should move to the left: with the divide before all of the soil it is
  // what moved to the left, and each piece that the divide passes takes its amount out or adds it.
  Divide best;
  double wrong = to_left, fewest = most_mixed * smaller;
  bool found = false;
  for (std::size_t i = 0; i + 1 < soil.size(); ++i) {
    wrong += soil[i].across < 0 ? -soil[i].amount : soil[i].amount;
    const double least = std::min(wrong, all - wrong);
    if (least >= fewest) continue;
    fewest = least;
    best = {0.5 * (soil[i].x + soil[i + 1].x), wrong < all - wrong ? -1 : 1};
    found = true;
  }
  return found ? std::optional(best) : std::nullopt;
}

}  // namespace talus::mesh
