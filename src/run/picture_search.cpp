// SPDX-License-Identifier: MIT
// Ranges of the search for slip surfaces, and given surfaces, in the picture of a case.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "lem/search/trial_circles.hpp"
#include "run/lem/run_lem.hpp"
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

/// Adds a window. A box becomes a polygon.
void add_window(const input::SurfaceWindow& window, output::SearchZoneKind kind, Picture& picture) {
  Picture::SearchZone zone{kind, window.name, window.points, false};
  if (window.box.size() == 2) {
    const auto &a = window.box[0], &b = window.box[1];
    zone.points = {a, {b[0], a[1]}, b, {a[0], b[1]}};
    zone.is_closed = true;
  }
  picture.zones.push_back(std::move(zone));
}

/// Adds the line to which circles are tangent: levels across the section, or the side of a layer.
void add_tangent(const PictureSource& source, const input::TangentCircles& tangent, Picture& picture) {
  const auto add = [&](const std::string& text, const Polyline& points) {
    if (points.size() > 1) picture.zones.push_back({output::SearchZoneKind::tangent, text, points, false});
  };
  if (!tangent.layer.empty()) {
    const lem::Path path = find_path(source.data, tangent.layer);
    return add("tangent to " + tangent.layer, tangent.side == input::LayerSide::top ? path.top : path.bottom);
  }
  for (const double level : tangent.levels)
    add("deepest point of circles", {{source.ground.front()[0], level}, {source.ground.back()[0], level}});
}

std::string describe_block(const input::BlockSearch& block) {
  const auto range = [](const std::vector<double>& angles) {
    constexpr double degree = std::numbers::pi / 180;
    return angles.size() == 2 ? fmt::format("{:.4g}° to {:.4g}°", angles[0] / degree, angles[1] / degree) : "";
  };
  return fmt::format("LEM: polylines {}; upper end rises at {}, lower end at {}; about {} of them.",
                     block.along.empty() ? "through windows" : "along " + block.along, range(block.active),
                     range(block.passive), block.surfaces);
}

/// Adds what restricts the slip surfaces of any search.
void add_restrictions(const PictureSource& source, Picture& picture) {
  const input::LimitEquilibrium& lem = source.data.lem;
  if (lem.search == input::SurfaceSearch::block) {
    for (const input::SurfaceWindow& window : lem.block.windows)
      add_window(window, output::SearchZoneKind::window, picture);
    if (source.sketch.is_sound("lem.block")) picture.notes.push_back(describe_block(lem.block));
  }
  if (lem.tangent && source.sketch.is_sound("lem.tangent")) add_tangent(source, *lem.tangent, picture);
  for (const input::ExcludedArea& area : lem.excluded)
    picture.zones.push_back({output::SearchZoneKind::excluded, area.name, area.points, true});
  for (const input::SurfaceWindow& window : lem.passages) add_window(window, output::SearchZoneKind::passage, picture);
  if (lem.slides != input::SlidingDirection::both)
    picture.notes.push_back(fmt::format("LEM: masses slide to the {}.", input::get_word(lem.slides)));
  if (!lem.impenetrable.empty() && source.sketch.is_sound("lem.impenetrable"))
    picture.notes.push_back(
        fmt::format("LEM: no slip surface enters {}; it follows the top.", fmt::join(lem.impenetrable, ", ")));
}

}  // namespace

void add_search(const PictureSource& source, Picture& picture) {
  if (!input::uses(source.data, input::Method::lem)) return;
  const input::LimitEquilibrium& lem = source.data.lem;
  for (const input::SlipSurface& surface : lem.surfaces) add_surface(source, surface, picture);
  if (source.ground.size() < 2) return;
  if (lem.search != input::SurfaceSearch::none) add_restrictions(source, picture);
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
                                        search.exits, search.depths,
                                        lem.noncircular && !lem.tangent ? "; then polylines" : ""));
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
  picture.notes.push_back(
      fmt::format("LEM: circles about {} × {} centres; their deepest points between y = {} and y = {} "
                  "(dotted){}.",
                  grid.columns, grid.rows, format_coordinate(*grid.lowest, source.data.units().length),
                  format_coordinate(*grid.highest, source.data.units().length),
                  lem.noncircular && !lem.tangent ? "; then polylines" : ""));
}

}  // namespace talus::run
