// SPDX-License-Identifier: MIT
#include "laboratory/measured_match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "laboratory/point_path.hpp"

namespace talus::laboratory {
namespace {

/// Signs of the legs: +1 where what the test follows grows.
std::vector<int> list_directions(const input::PointTest& test) {
  const std::vector<double> turns = list_turns(test);
  std::vector<int> directions;
  for (std::size_t i = 1; i < turns.size(); ++i) directions.push_back(turns[i] >= turns[i - 1] ? 1 : -1);
  return directions;
}

/// The cheapest division of the points among the legs, and what it costs.
std::pair<std::vector<std::size_t>, double> divide(const std::vector<std::array<double, 2>>& points,
                                                   const std::vector<int>& directions, int sense) {
  const std::size_t n = points.size(), legs = directions.size();
  // least[i][k]: least way in the wrong direction up to point i, when it lies on leg k.
  std::vector<std::vector<double>> least(n, std::vector<double>(legs, 0));
  std::vector<std::vector<std::size_t>> from(n, std::vector<std::size_t>(legs, 0));
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t k = 0; k < legs; ++k) {
      least[i][k] = std::numeric_limits<double>::infinity();
      const double wrong = std::max(0.0, -sense * directions[k] * (points[i][0] - points[i - 1][0]));
      // The step to a point is one of the leg on which the point lies.
      for (std::size_t before = 0; before <= k; ++before)
        if (least[i - 1][before] + wrong < least[i][k]) {
          least[i][k] = least[i - 1][before] + wrong;
          from[i][k] = before;
        }
    }
  const auto best = std::min_element(least[n - 1].begin(), least[n - 1].end());
  std::vector<std::size_t> leg(n);
  leg[n - 1] = static_cast<std::size_t>(best - least[n - 1].begin());
  for (std::size_t i = n - 1; i > 0; --i) leg[i - 1] = from[i][leg[i]];
  return {leg, *best};
}

}  // namespace

std::vector<std::size_t> find_legs(const input::PointTest& test, const std::vector<std::array<double, 2>>& points) {
  const std::vector<int> directions = list_directions(test);
  if (directions.size() < 2 || points.empty()) return std::vector<std::size_t>(points.size(), 0);
  // Most abscissae grow with what the test follows; a void ratio or a saturation does not.
  const auto with = divide(points, directions, 1), against = divide(points, directions, -1);
  return against.second < with.second ? against.first : with.first;
}

Reading read_curve(const PointCurve& curve, std::size_t leg, const std::string& x_name, const std::string& y_name,
                   double x) {
  const std::vector<PointRow>& rows = curve.rows;
  const auto turn = [&](std::size_t k) { return k < curve.turns.size() ? curve.turns[k] : rows.size() - 1; };
  const std::size_t first = leg == 0 ? 0 : turn(leg - 1), last = turn(leg);
  double before = get_quantity(rows[first], x_name);
  Reading nearest{get_quantity(rows[first], y_name), std::abs(x - before)};
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double here = get_quantity(rows[i], x_name);
    if (std::min(before, here) <= x && x <= std::max(before, here)) {
      const double share = here == before ? 1 : (x - before) / (here - before);
      return {(1 - share) * get_quantity(rows[i - 1], y_name) + share * get_quantity(rows[i], y_name), 0};
    }
    if (std::abs(x - here) < nearest.missing) nearest = {get_quantity(rows[i], y_name), std::abs(x - here)};
    before = here;
  }
  return nearest;
}

}  // namespace talus::laboratory
