// SPDX-License-Identifier: MIT
#pragma once
// Headings of the columns of a survey, and what they mean.

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/case/text_table.hpp"

namespace talus::drawing {

/// Meaning of a column.
enum class Role {
  hole,          ///< name of a borehole
  chainage,      ///< distance along the section
  x,             ///< easting; position along the section in a table without chainage and northing
  northing,      ///< second coordinate in plan
  elevation,     ///< of a point or of the top of a borehole
  top,           ///< depth of the upper boundary of a layer
  bottom,        ///< depth of its lower boundary
  bottom_level,  ///< elevation of its lower boundary
  thickness,
  end,    ///< depth of the end of a borehole
  soil,   ///< name of a layer
  order,  ///< number of a point along its line
  count,
};

/// Headings of a role, as their letters and digits in lower case; the first that a table has is taken.
struct Headings {
  Role role;
  std::initializer_list<const char*> names;
};

std::span<const Headings> get_known_headings();
/// Returns headings of eastings and northings that belong together.
std::span<const std::pair<const char*, const char*>> get_coordinate_pairs();

/// A heading without its unit.
struct Heading {
  std::string name, key, unit;
};

/// Splits "Elevation (ft)", "Depth_m" and "x [m]".
Heading read_heading(const input::TextTable::Heading& heading);
/// Returns the letters and digits of a heading in lower case.
std::string find_key(std::string_view name);
/// Returns the unit of length that a word names; empty if it names none: "ft" for "feet", "m" for "mAOD".
std::string find_length_unit(std::string_view text);
/// Returns true if headings have the names of a position and an elevation, or of a borehole and its depths.
bool are_known(const std::vector<input::TextTable::Heading>& headings);
bool is_latitude(const std::string& key);
bool is_longitude(const std::string& key);

}  // namespace talus::drawing
