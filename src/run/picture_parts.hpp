// SPDX-License-Identifier: MIT
#pragma once
// The parts of the picture of a case: its mesh, its conditions and loads, and its searches.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "input/sketch.hpp"
#include "output/plots/case_picture.hpp"

namespace talus::run {

/// Origin of a picture: the case without conditions, loads and points that could not be read.
struct PictureSource {
  using Polyline = std::vector<results::Point>;

  const input::Sketch& sketch;
  input::Case data;
  bool is_faulty = false;                        ///< `talus check` reports errors
  Polyline ground;                               ///< empty if it is not unique
  std::map<std::string, Polyline> mesh_sides{};  ///< of a ready mesh

  /// Returns the side or the line of that name; empty if there is none.
  Polyline find_line(const std::string& name) const;
  /// Returns the ground between two x, with both ends; empty without ground.
  Polyline cut_ground(double from, double to) const;
};

/// Removes the points of the list at `path` that could not be read: these are at the origin.
void drop_unread(std::vector<results::Point>& points, const std::string& path, const input::Sketch& sketch);

/// Adds the soils and sides of a ready mesh, or the elements of the plan if they are made in a moment, and notes on the
/// elements of each method.
void add_meshes(PictureSource& source, output::CasePicture& picture);
/// Adds supports, water, loads and roots, and the named lines of the section.
void add_conditions(const PictureSource& source, output::CasePicture& picture);
/// Adds the ranges of the search for slip surfaces, and given surfaces.
void add_search(const PictureSource& source, output::CasePicture& picture);

}  // namespace talus::run
