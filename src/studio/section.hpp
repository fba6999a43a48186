// SPDX-License-Identifier: MIT
#pragma once
// The section of a case for a canvas, as JSON in [m], with the path of the key that each part comes from.

#include <nlohmann/json_fwd.hpp>

#include "input/sketch.hpp"

namespace talus::studio {

/// Returns what a canvas shows of a case as far as it could be read; null without a plane section. Each part has
/// `path`, the key whose points it has, or null if it is derived:
///   units        {length, stress, unit_weight: {name, si}}
///   ground       [[x, y]] from left to right, empty if it is not unique
///   regions      [{name, soil, polygon, path}]
///   boundaries   [{name, kind: "ground", "bottom", "level" or "depths", points, path}] of a section by layers
///   lines        [{name, points, path}]
///   water_tables [{name, points, path, is_later}]; ponds [[[x, y]]]; pond_levels [[x, y]]
///   loads        [{text, line, load: [[p_x, p_y] in Pa], path}]; supports [{name, head, end, free, path}]
///   conditions   [{kind, text, line, outward}]; water_sides [{kind, text, line}]; monitors [{name, at, path}]
///   surfaces     [{name, points, path}]; ranges, zones, centres: of the search; notes [text]; box [[x, y]]
nlohmann::json write_section(const input::Sketch& sketch, bool is_faulty);

}  // namespace talus::studio
