// SPDX-License-Identifier: MIT
#pragma once
// Factors of safety read off a displacement–SRF curve.

#include <optional>
#include <string>
#include <vector>

#include "results/trial.hpp"

namespace talus::run {

/// A point of the curve: largest displacement [m] at the end of the window of a trial.
struct CurvePoint {
  double factor = 0;
  double displacement = 0;
};

/// The construction of Feng and Xu (2021): lines through the first and the last branch, and where they meet.
struct Bilinear {
  results::Branch first, last;
  results::Criterion criterion;
};

/// The two lines of the curve (sorted by factor). `first` and `last` give [from, to] of each branch; when empty the
/// branches are chosen from the data: the cut into two runs of at least two points with the smallest weighted sum of
/// squares, each point weighing half the distance of its neighbours, so that refined stretches do not count more.
std::optional<Bilinear> construct_bilinear(const std::vector<CurvePoint>& curve, const std::vector<double>& first = {},
                                           const std::vector<double>& last = {});

/// Where the displacement reaches `displacement` [m], by linear interpolation.
results::Criterion find_displacement_criterion(const std::vector<CurvePoint>& curve, double displacement);

/// The interval in which ln u grows fastest; displacements below `floor` [m] are elastic and not considered.
results::Criterion find_jump_criterion(const std::vector<CurvePoint>& curve, double floor);

/// Factors that halve the two intervals beside every point where the curve bends noticeably (change of slope times
/// length, against the whole rise). Nothing when those intervals are as short as `smallest`.
std::vector<double> choose_refinement(const std::vector<CurvePoint>& curve, double smallest);

}  // namespace talus::run
