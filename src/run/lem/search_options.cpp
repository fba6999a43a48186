// SPDX-License-Identifier: MIT
// Settings of the search for slip surfaces from [lem]: ranges, windows, paths, tangents and limits.
#include <algorithm>
#include <cmath>

#include "input/case/support.hpp"
#include "run/lem/run_lem.hpp"

namespace talus::run {
namespace {

std::array<double, 2> get_range(const std::vector<double>& given, const std::array<double, 2>& otherwise) {
  return given.size() == 2 ? std::array{given[0], given[1]} : otherwise;
}

lem::Window make_window(const input::SurfaceWindow& given) {
  lem::Window window{given.name, {given.points.begin(), given.points.end()}, given.box.size() == 2};
  if (!window.is_box) return window;
  const auto &a = given.box[0], &b = given.box[1];
  window.points = {{std::min(a[0], b[0]), std::min(a[1], b[1])}, {std::max(a[0], b[0]), std::max(a[1], b[1])}};
  return window;
}

lem::BlockSearch make_block_search(const input::Case& data) {
  const input::BlockSearch& given = data.lem.block;
  lem::BlockSearch search;
  for (const input::SurfaceWindow& w : given.windows) search.windows.push_back(make_window(w));
  if (!given.along.empty()) search.path = find_path(data, given.along);
  search.active = get_range(given.active, {});
  search.passive = get_range(given.passive, {});
  search.angles = given.angles;
  search.surfaces = given.surfaces;
  if (data.lem.entry_exit.exit.size() == 2) search.exit = get_range(data.lem.entry_exit.exit, {});
  if (data.lem.entry_exit.entry.size() == 2) search.entry = get_range(data.lem.entry_exit.entry, {});
  return search;
}

lem::TangentLines make_tangent(const input::Case& data, const input::TangentCircles& given) {
  lem::TangentLines lines;
  if (given.levels.empty()) {
    const lem::Path path = find_path(data, given.layer);
    lines.upper = lines.lower = given.side == input::LayerSide::top ? path.top : path.bottom;
    return lines;
  }
  lines.is_level = true;
  double left = 1e300, right = -1e300;
  for (const mesh::Polygon& polygon : data.mesh.polygons)
    for (const auto& p : polygon.points) left = std::min(left, p[0]), right = std::max(right, p[0]);
  lines.lower = {{left, given.levels.front()}, {right, given.levels.front()}};
  lines.upper = {{left, given.levels.back()}, {right, given.levels.back()}};
  return lines;
}

/// Half the width of the area that stands for a wall, and the length that it is shorter at both ends, over the length
/// of a piece of the wall.
constexpr double wall_width = 1e-4;

/// Adds the walls that surfaces must not cross, each piece as a thin area.
void exclude_walls(const input::Case& data, std::vector<std::vector<lem::Point>>& areas) {
  for (const auto& [name, support] : data.supports) {
    if (support.kind != input::SupportKind::wall || support.crossing != input::WallCrossing::excluded) continue;
    for (const input::BarLine& bar : input::lay_bars(support, mesh::find_ground(data.mesh), data.units().length).bars) {
      const double dx = wall_width * (bar.end[0] - bar.head[0]), dy = wall_width * (bar.end[1] - bar.head[1]);
      const lem::Point head{bar.head[0] + dx, bar.head[1] + dy}, end{bar.end[0] - dx, bar.end[1] - dy};
      areas.push_back({{head[0] - dy, head[1] + dx},
                       {head[0] + dy, head[1] - dx},
                       {end[0] + dy, end[1] - dx},
                       {end[0] - dy, end[1] + dx}});
    }
  }
}

std::shared_ptr<const lem::SurfaceLimits> make_limits(const input::Case& data) {
  const input::LimitEquilibrium& settings = data.lem;
  lem::SurfaceLimits limits;
  exclude_walls(data, limits.excluded);
  for (const input::ExcludedArea& area : settings.excluded)
    limits.excluded.emplace_back(area.points.begin(), area.points.end());
  for (const input::SurfaceWindow& w : settings.passages) limits.passages.push_back(make_window(w));
  limits.smallest_area = settings.smallest_area.value_or(0);
  limits.smallest_weight = settings.smallest_weight.value_or(0);
  limits.direction = settings.slides == input::SlidingDirection::both   ? 0
                     : settings.slides == input::SlidingDirection::left ? -1
                                                                        : 1;
  const bool is_any = !limits.excluded.empty() || !limits.passages.empty() || limits.smallest_area > 0 ||
                      limits.smallest_weight > 0 || limits.direction != 0;
  return is_any ? std::make_shared<const lem::SurfaceLimits>(std::move(limits)) : nullptr;
}

}  // namespace

lem::Path find_path(const input::Case& data, const std::string& name) {
  for (const mesh::Line& line : data.mesh.lines)
    if (line.name == name) {
      std::vector<lem::Point> points(line.points.begin(), line.points.end());
      if (points.size() > 1 && points.back()[0] < points.front()[0]) std::reverse(points.begin(), points.end());
      return {points, points};
    }
  std::vector<std::vector<lem::Point>> polygons;
  for (const mesh::Polygon& polygon : data.mesh.polygons) {
    const auto region = data.regions.find(polygon.name);
    if (polygon.name == name || (region != data.regions.end() && region->second == name))
      polygons.emplace_back(polygon.points.begin(), polygon.points.end());
  }
  return lem::make_path(polygons);
}

namespace {

std::vector<results::SearchShape> list_windows(const std::vector<input::SurfaceWindow>& given) {
  std::vector<results::SearchShape> shapes;
  for (const input::SurfaceWindow& w : given) {
    const lem::Window window = make_window(w);
    shapes.push_back({window.name, window.points, window.is_box});
  }
  return shapes;
}

}  // namespace

std::optional<results::SearchRestrictions> make_restrictions(const input::Case& data) {
  const input::LimitEquilibrium& given = data.lem;
  results::SearchRestrictions out;
  if (given.search == input::SurfaceSearch::block) {
    const input::BlockSearch& block = given.block;
    out.block = {
        {}, list_windows(block.windows), get_range(block.active, {}), get_range(block.passive, {}), block.angles};
    if (!block.along.empty()) out.block->along = block.along;
  }
  if (given.tangent) {
    out.tangent.emplace();
    if (given.tangent->layer.empty())
      out.tangent->levels = {given.tangent->levels.front(), given.tangent->levels.back()};
    else
      out.tangent->layer = given.tangent->layer;
    out.tangent->is_top = given.tangent->side == input::LayerSide::top;
  }
  for (const input::ExcludedArea& area : given.excluded)
    out.excluded.push_back({area.name, {area.points.begin(), area.points.end()}, false});
  out.through = list_windows(given.passages);
  out.impenetrable = given.impenetrable;
  if (given.slides != input::SlidingDirection::both) out.slides_left = given.slides == input::SlidingDirection::left;
  out.smallest_area = given.smallest_area;
  out.smallest_weight = given.smallest_weight;
  const bool is_any = out.block || out.tangent || !out.excluded.empty() || !out.through.empty() ||
                      !out.impenetrable.empty() || out.slides_left || out.smallest_area || out.smallest_weight;
  return is_any ? std::optional(out) : std::nullopt;
}

std::string describe_restrictions(const input::LimitEquilibrium& settings) {
  std::string what;
  const auto add = [&](bool is_given, const char* name) {
    if (is_given) what += (what.empty() ? "" : ", ") + std::string(name);
  };
  const bool is_searched = settings.search != input::SurfaceSearch::none;
  add(settings.search == input::SurfaceSearch::block, "[lem.block]");
  add(is_searched && settings.tangent.has_value(), "[lem.tangent]");
  add(is_searched && !settings.excluded.empty(), "[[lem.exclude]]");
  add(is_searched && !settings.passages.empty(), "[[lem.through]]");
  add(!settings.impenetrable.empty(), "impenetrable");
  add(is_searched && settings.slides != input::SlidingDirection::both, "slides");
  add(is_searched && settings.smallest_area.has_value(), "smallest_area");
  add(is_searched && settings.smallest_weight.has_value(), "smallest_weight");
  if (what.empty()) return "";
  return "The search is restricted by " + what +
         ": its factor is that of the surfaces asked for, and other surfaces may have a smaller one. Search once "
         "without the restriction.";
}

lem::SearchOptions make_search_options(const input::Case& data, int threads) {
  const input::LimitEquilibrium& settings = data.lem;
  lem::SearchOptions options;
  options.kind = settings.search == input::SurfaceSearch::grid    ? lem::SearchKind::grid
                 : settings.search == input::SurfaceSearch::block ? lem::SearchKind::block
                                                                  : lem::SearchKind::entry_exit;
  if (options.kind == lem::SearchKind::block) options.block = make_block_search(data);
  if (settings.tangent) options.tangent = make_tangent(data, *settings.tangent);
  lem::GridSearch grid;  // from == to: derived from the ground
  grid.columns = settings.grid.columns;
  grid.rows = settings.grid.rows;
  grid.radii = settings.grid.radii;
  if (settings.grid.corners.size() == 2) {
    grid.from = settings.grid.corners[0];
    grid.to = settings.grid.corners[1];
  }
  if (settings.grid.levels.size() == 2) {
    grid.lowest = settings.grid.levels[0];
    grid.highest = settings.grid.levels[1];
  }
  options.grid = grid;
  lem::EntryExitSearch between;  // empty ranges: the whole ground
  constexpr std::array<double, 2> everywhere{-1e9, 1e9};
  const bool has_range = !settings.entry_exit.exit.empty() || !settings.entry_exit.entry.empty();
  between.exit = get_range(settings.entry_exit.exit, has_range ? everywhere : std::array<double, 2>{});
  between.entry = get_range(settings.entry_exit.entry, has_range ? everywhere : std::array<double, 2>{});
  between.exits = settings.entry_exit.exits;
  between.entries = settings.entry_exit.entries;
  between.depths = settings.entry_exit.depths;
  options.entry_exit = between;
  options.slices = settings.slices;
  options.methods = settings.methods;
  options.checks.smallest_m_alpha = settings.smallest_m_alpha;
  options.checks.most_tension = settings.most_tension;
  options.checks.most_thrust_outside = settings.most_thrust_outside;
  options.checks.smallest_lambda = settings.smallest_lambda;
  options.checks.largest_lambda = settings.largest_lambda;
  if (settings.smallest_depth) {
    options.checks.smallest_depth = *settings.smallest_depth;
    options.finds_skins = true;
  }
  options.checks.limits = make_limits(data);
  options.checks.composite = settings.composite;
  options.checks.reject = settings.reject;
  options.composite = settings.composite;
  options.optimise_surface = settings.noncircular;
  options.vertices = settings.vertices;
  options.kept_minima = settings.minima;
  options.seed = settings.seed;
  options.threads = threads;
  return options;
}

}  // namespace talus::run
