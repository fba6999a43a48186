// SPDX-License-Identifier: MIT
#pragma once
// Search for polylines with a vertex in each of several windows, or along a path, between straight ends whose
// inclinations are searched.

#include <optional>
#include <vector>

#include "lem/search/search.hpp"

namespace talus::lem {

/// Family of polylines. Its parameters, each from 0 to 1, count from the lower end: inclination of that end, places in
/// the windows or along the path, inclination of the upper end. A mirrored section has the same polylines at the same
/// parameters.
class BlockFamily {
 public:
  BlockFamily(const Slope& slope, const BlockSearch& search, int direction);

  /// Number of parameters.
  std::size_t size() const { return 2 + places_; }
  /// Returns the polyline that falls to the left (or right); none if its vertices do not follow one another, an end
  /// does not meet the ground or lies outside its range, or the ground does not fall to that side.
  std::optional<Surface> make(const std::vector<double>& parameters, bool falls_left) const;
  /// Returns evenly spread parameters, about as many as the search asks for.
  std::vector<std::vector<double>> spread(int seed) const;
  /// Initial step of a minimiser.
  double step() const { return step_; }
  /// Returns true if polylines that fall to this side are searched.
  bool is_searched(bool falls_left) const { return direction_ == 0 || falls_left == (direction_ < 0); }
  const BlockSearch& search() const { return search_; }

 private:
  std::optional<std::vector<Point>> place_vertices(const std::vector<double>& parameters, bool falls_left) const;
  std::vector<Point> follow_path(const std::vector<double>& parameters, bool falls_left) const;
  std::optional<Point> find_end(const Point& from, int way, double angle) const;

  const Slope* slope_;
  BlockSearch search_;
  int direction_;
  std::size_t places_ = 0;  ///< parameters of windows or path
  double near_;             ///< distance that counts as none [m]
  double step_ = 0.1;
};

/// Fills trials, minima and critical polylines of a result. Throws as throw_if_search_is_interrupted().
void search_blocks(const Slope& slope, const SearchOptions& options, SearchResult& result);

}  // namespace talus::lem
