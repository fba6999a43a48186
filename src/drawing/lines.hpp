// SPDX-License-Identifier: MIT
#pragma once
// Lines of a drawing or a survey: joined where they meet, thinned out, compared in height.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/planar.hpp"

namespace talus::drawing {

/// Lines of one layer that meet, as one.
struct Chain {
  std::string layer, handle;
  bool closed = false;
  mesh::Polyline points;
  std::string soil = {};  ///< given by an attribute
};

/// Points of a section; more are thinned out, since the checks of a section are of quadratic cost.
inline constexpr std::size_t most_corners = 2000;
/// Distance below which lines of a drawing meet, and the largest by which a line moves, as fractions of its extent.
inline constexpr double meeting_distance = 1e-5, largest_move = 1e-3;

/// Throws Error (wrong_input) unless the base [m] lies below all of these lines.
void check_base(double base, const std::vector<mesh::Polyline>& lines);

/// Returns true for finite coordinates below 1e9 m.
bool is_a_place(const mesh::Point2& p);

/// Returns the larger side of the box around the lines [m].
double measure_extent(const std::vector<Chain>& chains);

/// Removes points within `tolerance` [m] of the point before.
void drop_repeated(mesh::Polyline& points, double tolerance);

/// Joins lines of a layer at points in which exactly two of them end, to `tolerance` [m].
std::vector<Chain> join_lines(const std::vector<Chain>& lines, double tolerance);

/// Removes points that are nearly on the line between others while there are more than `most_corners`, with a remark.
/// Throws Error (wrong_input) if more remain after moves by `largest_move`. `tolerance` is that of the smallest move,
/// `what` is named in the error: "the drawing".
void thin_out(std::vector<Chain>& chains, double tolerance, const std::string& what, std::vector<std::string>& remarks);

/// Returns the mean height of a line over another one where both are; NaN where they have no common x.
double compare_levels(const mesh::Polyline& a, const mesh::Polyline& b);

/// Returns a point at which one of two lines from left to right crosses from above the other to below it, by more than
/// `tolerance` [m] on both sides.
std::optional<mesh::Point2> find_crossing(const mesh::Polyline& a, const mesh::Polyline& b, double tolerance);

/// Splits an outline into the line above and the line below, both from left to right.
std::pair<mesh::Polyline, mesh::Polyline> split_outline(const mesh::Polyline& outline);

/// Sorts lines from the top down.
void sort_down(std::vector<Chain>& lines);

}  // namespace talus::drawing
