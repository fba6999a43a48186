// SPDX-License-Identifier: MIT
#pragma once
// Criteria that give a factor of safety from a displacement–SRF curve.

#include <optional>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "results/trial.hpp"

namespace talus::run {

/// A point of the curve: largest displacement [m] at the end of the window of a trial.
struct CurvePoint {
  double factor = 0;
  double displacement = 0;
};

/// Bilinear construction of Feng and Xu (2021): lines through the first and the last branch, and their intersection.
struct Bilinear {
  results::Branch first, last;
  results::Criterion criterion;
};

/// Fits the two lines to the curve, which is sorted by factor. `first` and `last` give [from, to] of each branch. If
/// they are empty, the branches are the two runs of at least two points with the smallest weighted sum of squares; the
/// weight of a point is half the distance between its neighbours, so that refined stretches do not count more.
std::optional<Bilinear> construct_bilinear(const std::vector<CurvePoint>& curve, const std::vector<double>& first = {},
                                           const std::vector<double>& last = {});

/// Returns the factor at which the displacement reaches `displacement` [m], by linear interpolation; `length` is the
/// unit of its note.
results::Criterion find_displacement_criterion(const std::vector<CurvePoint>& curve, double displacement,
                                               const ShownUnit& length);

/// Returns the interval in which ln u grows fastest; displacements below `floor` [m] are elastic and disregarded.
results::Criterion find_jump_criterion(const std::vector<CurvePoint>& curve, double floor);

/// Returns what the three criteria make of a curve; none gives a factor if the slope has failed at the smallest one, by
/// a displacement of more than `displacement_ratio` times its height [m].
std::vector<results::Criterion> find_criteria(const std::vector<CurvePoint>& curve,
                                              const std::optional<Bilinear>& bilinear, double displacement_ratio,
                                              double slope_height, const ShownUnit& length);

/// Returns factors that halve the two intervals beside every point at which the curve bends noticeably (change of
/// slope times length, relative to the total rise). Intervals as short as `smallest` are not halved.
std::vector<double> choose_refinement(const std::vector<CurvePoint>& curve, double smallest);

}  // namespace talus::run
