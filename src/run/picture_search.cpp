// SPDX-License-Identifier: MIT
// Ranges of the search for slip surfaces, and given surfaces, in the picture of a case.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "lem/search/trial_circles.hpp"
#include "run/picture_parts.hpp"
#include "site/ground_line.hpp"

namespace talus::run {
namespace {

using Point = results::Point;
using Polyline = std::vector<Point>;
using Picture = output::CasePicture;

/// Adds a given surface: a polyline, or the longest part of its circle below the ground.
void add_surface(const PictureSource& source, const input::SlipSurface& surface, Picture& picture) {
  if (!surface.points.empty()) {
    picture.surfaces.push_back({surface.name, surface.points});
    return;
  }
  if (!surface.centre || !surface.radius || source.ground.size() < 2) return;
  constexpr int parts = 360;
  Polyline run, longest;
  for (int i = 0; i <= parts; ++i) {
    const double angle = std::numbers::pi * (1 + static_cast<double>(i) / parts);  // the lower half, from left to right
    const Point p{(*surface.centre)[0] + *surface.radius * std::cos(angle),
                  (*surface.centre)[1] + *surface.radius * std::sin(angle)};
    const bool is_between = surface.ends.size() != 2 || (p[0] >= surface.ends[0] && p[0] <= surface.ends[1]);
    const bool is_below = p[0] >= source.ground.front()[0] && p[0] <= source.ground.back()[0] &&
                          p[1] <= site::find_level(source.ground, p[0]);
    if (is_below && is_between) run.push_back(p);
    if (!(is_below && is_between) || i == parts) {
      if (run.size() > longest.size()) longest = run;
      run.clear();
    }
  }
  if (longest.size() > 1) picture.surfaces.push_back({surface.name, longest});
}

}  // namespace

void add_search(const PictureSource& source, Picture& picture) {
  if (!input::uses(source.data, input::Method::lem)) return;
  const input::LimitEquilibrium& lem = source.data.lem;
  for (const input::SlipSurface& surface : lem.surfaces) add_surface(source, surface, picture);
  if (source.ground.size() < 2) return;
  const double left = source.ground.front()[0], right = source.ground.back()[0];
  if (lem.search == input::SurfaceSearch::entry_exit && source.sketch.is_sound("lem.entry_exit")) {
    const auto add = [&](const std::vector<double>& range, const char* name, bool is_entry) {
      const bool is_given = range.size() == 2;
      picture.ranges.push_back({is_given ? name : fmt::format("{}: all of the ground", name),
                                source.cut_ground(is_given ? range[0] : left, is_given ? range[1] : right), is_entry});
    };
    const input::EntryExit& search = lem.entry_exit;
    if (search.exit.empty() && search.entry.empty()) {
      picture.ranges.push_back({"entries and exits: all of the ground", source.cut_ground(left, right), false});
    } else {
      add(search.entry, "entries", true);
      add(search.exit, "exits", false);
    }
    picture.notes.push_back(fmt::format("LEM: circles between {} entries and {} exits, {} deep each{}.", search.entries,
                                        search.exits, search.depths, lem.noncircular ? "; then polylines" : ""));
  }
  if (lem.search != input::SurfaceSearch::grid || !source.sketch.is_sound("lem.grid")) return;
  lem::GridSearch grid;
  grid.columns = lem.grid.columns, grid.rows = lem.grid.rows;
  if (lem.grid.corners.size() == 2) grid.from = lem.grid.corners[0], grid.to = lem.grid.corners[1];
  if (lem.grid.levels.size() == 2) grid.lowest = lem.grid.levels[0], grid.highest = lem.grid.levels[1];
  grid = lem::choose_grid(source.ground, site::find_base(source.data.mesh), grid);
  picture.centres =
      Picture::CentreGrid{fmt::format("{} × {} centres, {} radii each", grid.columns, grid.rows, lem.grid.radii),
                          grid.from,
                          grid.to,
                          grid.columns,
                          grid.rows,
                          {*grid.lowest, *grid.highest}};
  picture.notes.push_back(fmt::format(
      "LEM: circles about {} × {} centres; their deepest points between y = {} and y = {} "
      "(dotted){}.",
      grid.columns, grid.rows, format_coordinate(*grid.lowest, source.data.units().length),
      format_coordinate(*grid.highest, source.data.units().length), lem.noncircular ? "; then polylines" : ""));
}

}  // namespace talus::run
