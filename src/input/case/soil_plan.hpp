// SPDX-License-Identifier: MIT
#pragma once
// The soil of a section, at places and beside lines, for checks of a case before it has a mesh.

#include <utility>
#include <vector>

#include "mesh/planar.hpp"

namespace talus::input {

struct Case;

/// The soil on both sides of a line, somewhere along it.
struct Border {
  bool meets_air = false;   ///< soil on one side, empty part of the box on the other
  bool meets_soil = false;  ///< soil on at least one side
  bool is_surface = false;  ///< soil with pore water on one side only
  bool is_within = false;   ///< soil with pore water on both sides
};

class SoilPlan {
 public:
  /// `data` and `plan` must outlive this object. `plan`: that of the case, or of one of its stages.
  SoilPlan(const Case& data, const mesh::Plan& plan);

  Border look_along(const mesh::Polyline& line) const;
  /// Returns true if soil with pore water lies at the point or next to it.
  bool has_water_at(const mesh::Point2& x) const;
  /// Returns true if a line meets soil with pore water.
  bool meets_water(const mesh::Polyline& line) const;
  /// Returns the levels of the lowest and the highest soil [m].
  std::pair<double, double> find_levels() const;

 private:
  std::vector<mesh::Point2> list_places(const mesh::Point2& a, const mesh::Point2& b) const;
  int find_polygon(const mesh::Point2& x) const;
  bool has_soil(const mesh::Point2& x) const;
  bool has_water(const mesh::Point2& x) const;
  bool is_room(const mesh::Point2& x) const;

  const mesh::Plan& plan_;
  std::vector<char> wet_;  ///< per polygon
};

}  // namespace talus::input
