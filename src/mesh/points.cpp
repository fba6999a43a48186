// SPDX-License-Identifier: MIT
#include "mesh/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"

// With equal weights and full symmetry the first moments are exact. Second moments: the means of N_i² over a triangle
// and a tetrahedron are 1/6 and 1/10, which each construction below satisfies.

namespace talus::mesh {
namespace {

/// Adds all distinct permutations of the barycentric coordinates, as local coordinates.
template <int D>
void add_orbit(std::array<double, D + 1> barycentric, std::vector<std::array<double, D>>& points) {
  std::sort(barycentric.begin(), barycentric.end());
  do {
    std::array<double, D> xi;
    std::copy(barycentric.begin() + 1, barycentric.end(), xi.begin());
    points.push_back(xi);
  } while (std::next_permutation(barycentric.begin(), barycentric.end()));
}

/// Returns corners and edge midpoints, contracted towards the centroid by the factor `s`.
template <int D>
std::vector<std::array<double, D>> shrink_quadratic_nodes(double s) {
  std::vector<std::array<double, D>> points;
  std::array<double, D + 1> corner, middle;
  corner.fill((1 - s) / (D + 1));
  middle = corner;
  corner[0] += s;
  middle[0] += s / 2;
  middle[1] = middle[0];
  add_orbit<D>(corner, points);
  add_orbit<D>(middle, points);
  return points;
}

std::vector<std::array<double, 2>> place_three() {
  return {{1. / 6, 1. / 6}, {2. / 3, 1. / 6}, {1. / 6, 2. / 3}};
}

/// Returns the three-point rule in each of the four triangles between the edge midpoints.
std::vector<std::array<double, 2>> place_twelve() {
  std::vector<std::array<double, 2>> points;
  for (const auto& p : place_three()) {
    points.push_back({p[0] / 2, p[1] / 2});
    points.push_back({0.5 + p[0] / 2, p[1] / 2});
    points.push_back({p[0] / 2, 0.5 + p[1] / 2});
    points.push_back({0.5 - p[0] / 2, 0.5 - p[1] / 2});
  }
  return points;
}

/// Returns the standard four-point rule with (5-√5)/20 = 0.138 and (5+3√5)/20 = 0.585.
std::vector<std::array<double, 3>> place_four() {
  const double a = (5 - std::sqrt(5.)) / 20, b = (5 + 3 * std::sqrt(5.)) / 20;
  return {{a, a, a}, {b, a, a}, {a, b, a}, {a, a, b}};
}

/// Returns four points towards the corners and four towards the faces, at least a tenth of the altitude from a face:
/// among all such pairs of fours with exact second moments, the one farthest from the faces.
std::vector<std::array<double, 3>> place_eight() {
  std::vector<std::array<double, 3>> points;
  add_orbit<3>({0.7, 0.1, 0.1, 0.1}, points);
  add_orbit<3>({0.1, 0.3, 0.3, 0.3}, points);
  return points;
}

template <int D>
std::array<double, D> get_centroid() {
  std::array<double, D> xi;
  xi.fill(1. / (D + 1));
  return xi;
}

}  // namespace

template <int D>
std::vector<int> allowed_points() {
  if constexpr (D == 2)
    return {1, 3, 6, 12};
  else
    return {1, 4, 8, 10};
}

template <int D>
std::vector<std::array<double, D>> point_positions(int points_per_element) {
  if (points_per_element == 1) return {get_centroid<D>()};
  if constexpr (D == 2) {
    if (points_per_element == 3) return place_three();
    if (points_per_element == 6) return shrink_quadratic_nodes<2>(std::sqrt(0.4));
    if (points_per_element == 12) return place_twelve();
  } else {
    if (points_per_element == 4) return place_four();
    if (points_per_element == 8) return place_eight();
    if (points_per_element == 10) return shrink_quadratic_nodes<3>(std::numbers::inv_sqrt3);
  }
  std::string choice;
  for (int n : allowed_points<D>()) choice += fmt::format("{}{}", choice.empty() ? "" : ", ", n);
  fail_input("{} points per element is not possible in {}D: choose one of {}", points_per_element, D, choice);
}

template std::vector<int> allowed_points<2>();
template std::vector<int> allowed_points<3>();
template std::vector<std::array<double, 2>> point_positions<2>(int);
template std::vector<std::array<double, 3>> point_positions<3>(int);

}  // namespace talus::mesh
