// SPDX-License-Identifier: MIT
// Places of messages in the section, from the paths of their keys and the points in their sentences.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "base/numbers.hpp"
#include "input/case/geometry.hpp"
#include "mesh/planar.hpp"
#include "run/case_picture.hpp"
#include "run/picture_parts.hpp"
#include "site/ground_line.hpp"

namespace talus::run {
namespace {

using Point = results::Point;
using Polyline = std::vector<Point>;

/// Divides "geometry.polygon.0.points" at its dots.
std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> steps;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    steps.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return steps;
}

std::optional<std::size_t> read_index(const std::vector<std::string>& steps, std::size_t at) {
  std::size_t index = 0;
  if (at >= steps.size()) return std::nullopt;
  const char* end = steps[at].data() + steps[at].size();
  const auto [stop, fault] = std::from_chars(steps[at].data(), end, index);
  return fault == std::errc() && stop == end ? std::optional(index) : std::nullopt;
}

/// Returns the element of a list with the index at a step of a path; nullptr if there is none.
template <class List>
const typename List::value_type* find_item(const List& list, const std::vector<std::string>& steps, std::size_t at) {
  const std::optional<std::size_t> index = read_index(steps, at);
  return index && *index < list.size() ? &list[*index] : nullptr;
}

/// Returns a point inside a polygon, far from its sides.
std::optional<Point> find_inner_point(const Polyline& corners) {
  if (corners.empty()) return std::nullopt;
  Point low = corners.front(), high = low;
  for (const Point& p : corners)
    for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], p[d]), high[d] = std::max(high[d], p[d]);
  constexpr int parts = 16;
  constexpr std::size_t most_corners = 2000;
  std::optional<Point> best;
  double most = -1;
  if (corners.size() > 2 && corners.size() <= most_corners) {
    const Polyline closed = mesh::close_polygon(corners);
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const Point x{low[0] + (i + 0.5) / parts * (high[0] - low[0]), low[1] + (j + 0.5) / parts * (high[1] - low[1])};
        if (!mesh::is_inside(x, corners)) continue;
        if (const double room = mesh::compute_distance(x, closed); room > most) most = room, best = x;
      }
  }
  return best ? best : Point{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
}

/// Returns the point at half the length of a line.
std::optional<Point> find_middle(const Polyline& line) {
  if (line.empty()) return std::nullopt;
  double length = 0, before = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double part = std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
    if (part > 0 && before + part >= length / 2) {
      const double t = (length / 2 - before) / part;
      return Point{line[i - 1][0] + t * (line[i][0] - line[i - 1][0]),
                   line[i - 1][1] + t * (line[i][1] - line[i - 1][1])};
    }
    before += part;
  }
  return line.front();
}

/// Returns the lowest level of a polygon at x; std::nullopt where it is not.
std::optional<double> find_lower_side(const Polyline& corners, double x) {
  std::optional<double> level;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if (x < std::min(a[0], b[0]) || x > std::max(a[0], b[0])) continue;
    const double here = a[0] == b[0] ? std::min(a[1], b[1]) : a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
    level = std::min(level.value_or(here), here);
  }
  return level;
}

/// The points and positions that a sentence names, in [m].
class Sentence {
 public:
  Sentence(const std::string& text, double unit) : text_(text), unit_(unit) {}

  /// Reads "(12, 4.5)" behind a word, such as "around "; without a word the first point of the sentence.
  std::optional<Point> find_point(std::string_view word) const {
    for (std::size_t at = text_.find(word); at != std::string::npos; at = text_.find(word, at + 1))
      if (std::size_t end = at + word.size(); const auto point = read_point(end)) return point;
    return std::nullopt;
  }

  /// Returns the point between the ends of "between (0, 5) and (4, 8)".
  std::optional<Point> find_middle_point() const {
    constexpr std::string_view first = "between ", second = " and ";
    std::size_t at = text_.find(first);
    if (at == std::string::npos) return std::nullopt;
    at += first.size();
    const auto a = read_point(at);
    if (!a || text_.compare(at, second.size(), second) != 0) return std::nullopt;
    at += second.size();
    const auto b = read_point(at);
    return b ? std::optional(Point{((*a)[0] + (*b)[0]) / 2, ((*a)[1] + (*b)[1]) / 2}) : std::nullopt;
  }

  /// Returns the position of "x = 12 m", or the middle of "from x = 12 m to x = 20 m".
  std::optional<double> find_x() const {
    constexpr std::string_view sign = "x = ";
    const std::size_t at = text_.find(sign);
    if (at == std::string::npos) return std::nullopt;
    const std::optional<double> first = read_at(at + sign.size());
    const std::size_t next = text_.find(sign, at + 1);
    constexpr std::string_view to = "to ";
    const bool is_span =
        next != std::string::npos && next >= to.size() && text_.compare(next - to.size(), to.size(), to) == 0;
    const std::optional<double> last = is_span ? read_at(next + sign.size()) : std::nullopt;
    return first && last ? std::optional((*first + *last) / 2) : first;
  }

 private:
  std::optional<double> read_at(std::size_t at) const {
    double value = 0;
    const char* end = parse_number(text_.data() + at, text_.data() + text_.size(), value);
    return end == nullptr ? std::nullopt : std::optional(value * unit_);
  }
  /// Reads a point at `at`, which moves behind it.
  std::optional<Point> read_point(std::size_t& at) const {
    if (at >= text_.size() || text_[at] != '(') return std::nullopt;
    Point point{};
    const char *here = text_.data() + at + 1, *end = text_.data() + text_.size();
    here = parse_number(here, end, point[0]);
    if (here == nullptr || end - here < 2 || here[0] != ',' || here[1] != ' ') return std::nullopt;
    here = parse_number(here + 2, end, point[1]);
    if (here == nullptr || here == end || *here != ')') return std::nullopt;
    at = static_cast<std::size_t>(here + 1 - text_.data());
    for (double& x : point) x *= unit_;
    return point;
  }

  const std::string& text_;
  double unit_;
};

class PlaceSearch {
 public:
  PlaceSearch(const input::Sketch& sketch, const Polyline& ground, const std::string& path)
      : sketch_(sketch), data_(sketch.data), ground_(ground), steps_(split(path)) {}

  /// Returns the place of the key; sets `is_exact` if the key is a single point.
  std::optional<Point> find(bool& is_exact) const {
    is_exact = false;
    const std::string block = step(0);
    if (block == "geometry") return find_in_geometry(is_exact);
    if (block == "mesh" && step(1) == "refine") {
      const auto* refinement = find_item(data_.mesh.refinements, steps_, 2);
      return refinement == nullptr ? std::nullopt : find_on_line(refinement->near, 4, is_exact);
    }
    if (block == "materials") return find_material();
    if (block == "regions") return find_region(step(1));
    if (block == "boundary") return find_condition(data_.boundaries);
    if (block == "traction") return find_condition(data_.tractions);
    if (block == "hydraulic") return find_condition(data_.hydraulics);
    if (block == "roots") {
      const auto* roots = find_item(data_.roots, steps_, 1);
      return roots == nullptr ? std::nullopt : find_middle(find_side_line(data_, roots->ground));
    }
    if (block == "surcharge") {
      const auto* load = find_item(data_.surcharges, steps_, 1);
      return load == nullptr ? std::nullopt : find_on_ground(load->x);
    }
    if (block == "initial") return find_initial(is_exact);
    if (block == "lem") return find_in_lem(is_exact);
    if (block == "output" && step(1) == "monitor") {
      const auto* monitor = find_item(data_.output.monitors, steps_, 2);
      return monitor == nullptr ? std::nullopt : std::optional(Point{monitor->at[0], monitor->at[1]});
    }
    return std::nullopt;
  }

  /// Returns the place at x on the lower side of the polygon that the key names; on the ground for other keys.
  std::optional<Point> find_at(double x) const {
    if (step(0) == "geometry" && step(1) == "polygon") {
      const auto index = read_index(steps_, 2);
      // The boundary of a layer without thickness is that of the layer above.
      for (std::size_t i = std::min(index.value_or(0) + 1, data_.mesh.polygons.size()); i-- > 0;)
        if (const auto level = find_lower_side(data_.mesh.polygons[i].points, x)) return Point{x, *level};
    }
    if (!ground_.empty()) return Point{x, site::find_level(ground_, x)};
    const double level = input::SoilOutline(data_.mesh).find_ground(x);
    return std::isfinite(level) ? std::optional(Point{x, level}) : std::nullopt;
  }

 private:
  std::string step(std::size_t at) const { return at < steps_.size() ? steps_[at] : ""; }

  /// Returns the point of a line with the index at a step of the path; without an index its middle.
  std::optional<Point> find_on_line(const Polyline& line, std::size_t at, bool& is_exact) const {
    const Point* corner = find_item(line, steps_, at);
    is_exact = corner != nullptr;
    if (corner != nullptr) return *corner;
    std::string path;
    for (std::size_t i = 0; i < std::min(at, steps_.size()); ++i) path += (i > 0 ? "." : "") + steps_[i];
    Polyline points = line;
    drop_unread(points, path, sketch_);
    return find_middle(points);
  }

  std::optional<Point> find_in_geometry(bool& is_exact) const {
    const std::string kind = step(1);
    if (kind == "box") return find_middle({data_.mesh.box_min, data_.mesh.box_max});
    if (kind == "ground")
      return find_on_line(data_.layering.ground.points.empty() ? ground_ : data_.layering.ground.points, 2, is_exact);
    if (kind == "line") {
      const auto* line = find_item(data_.mesh.lines, steps_, 2);
      return line == nullptr ? std::nullopt : find_on_line(line->points, 4, is_exact);
    }
    if (kind == "layer") {
      const auto* layer = find_item(data_.layering.layers, steps_, 2);
      if (layer == nullptr) return std::nullopt;
      if (!layer->bottom.points.empty()) return find_on_line(layer->bottom.points, 4, is_exact);
      return find_on_ground_of(layer->depths.points);
    }
    if (kind != "polygon") return std::nullopt;
    const auto* polygon = find_item(data_.mesh.polygons, steps_, 2);
    if (polygon == nullptr) return std::nullopt;
    if (const Point* corner = find_item(polygon->points, steps_, 4)) {
      is_exact = true;
      return *corner;
    }
    return find_inner_point(polygon->points);
  }

  std::optional<Point> find_region(const std::string& name) const {
    for (const mesh::Polygon& polygon : data_.mesh.polygons)
      if (polygon.name == name) return find_inner_point(polygon.points);
    return std::nullopt;
  }

  std::optional<Point> find_material() const {
    for (const auto& [region, material] : data_.regions)
      if (material == step(1))
        if (const auto place = find_region(region)) return place;
    return std::nullopt;
  }

  template <class Conditions>
  std::optional<Point> find_condition(const Conditions& conditions) const {
    const auto* condition = find_item(conditions, steps_, 1);
    return condition == nullptr ? std::nullopt : find_middle(find_side_line(data_, condition->on));
  }

  /// Returns the point on the ground in the middle of a range of x.
  std::optional<Point> find_on_ground(const std::vector<double>& x) const {
    if (x.empty()) return std::nullopt;
    return find_at_ground((x.front() + x.back()) / 2);
  }
  std::optional<Point> find_on_ground_of(const Polyline& boreholes) const {
    return boreholes.empty() ? std::nullopt : find_at_ground(boreholes.front()[0]);
  }
  std::optional<Point> find_at_ground(double x) const {
    if (!ground_.empty()) return Point{x, site::find_level(ground_, x)};
    const double level = input::SoilOutline(data_.mesh).find_ground(x);
    return std::isfinite(level) ? std::optional(Point{x, level}) : std::nullopt;
  }

  std::optional<Point> find_initial(bool& is_exact) const {
    const std::string key = step(1);
    if (key == "water_table") return find_on_line(data_.initial.water.water_table, 2, is_exact);
    if (key == "velocity") return find_region(step(2));
    if (key == "pore_pressure" || key == "largest_suction") return find_middle(data_.initial.water.water_table);
    return std::nullopt;
  }

  std::optional<Point> find_in_lem(bool& is_exact) const {
    const std::string kind = step(1), key = step(2);
    if (kind == "drawdown" && data_.lem.drawdown) return find_on_line(data_.lem.drawdown->water_table, 3, is_exact);
    if (kind == "entry_exit" && key == "exit") return find_on_ground(data_.lem.entry_exit.exit);
    if (kind == "entry_exit" && key == "entry") return find_on_ground(data_.lem.entry_exit.entry);
    if (kind == "grid" && key == "corners") return find_on_line(data_.lem.grid.corners, 3, is_exact);
    if (kind == "exclude")
      if (const auto* area = find_item(data_.lem.excluded, steps_, 2)) return find_on_line(area->points, 4, is_exact);
    if (kind == "through") return find_window(data_.lem.passages, 2, is_exact);
    if (kind == "block") return find_window(data_.lem.block.windows, 3, is_exact);
    if (kind != "surface") return std::nullopt;
    const auto* surface = find_item(data_.lem.surfaces, steps_, 2);
    if (surface == nullptr) return std::nullopt;
    if (!surface->points.empty()) return find_on_line(surface->points, 4, is_exact);
    if (step(3) == "ends") return find_on_ground(surface->ends);
    if (!surface->centre) return std::nullopt;
    if (step(3) == "centre" || !surface->radius) return *surface->centre;
    return Point{(*surface->centre)[0], (*surface->centre)[1] - *surface->radius};
  }

  /// Returns the place of the window with the index at a step of the path.
  std::optional<Point> find_window(const std::vector<input::SurfaceWindow>& windows, std::size_t at,
                                   bool& is_exact) const {
    const auto* window = find_item(windows, steps_, at);
    if (window == nullptr) return std::nullopt;
    return find_on_line(window->points.empty() ? window->box : window->points, at + 2, is_exact);
  }

  const input::Sketch& sketch_;
  const input::Case& data_;
  const Polyline& ground_;
  std::vector<std::string> steps_;
};

/// Returns true if a finding on a key may name a point: one of the section, its lines, its water or its surfaces.
bool has_points(const std::string& path) {
  if (path.empty()) return true;
  for (const char* block : {"geometry", "initial", "lem", "mesh", "surcharge", "hydraulic"})
    if (path.starts_with(block)) return true;
  return false;
}

}  // namespace

std::optional<Point> find_message_place(const input::Sketch& sketch, const Polyline& ground,
                                        const Diagnostic& message) {
  const std::string path = sketch.find_path(message);
  const PlaceSearch search(sketch, ground, path);
  bool is_exact = false;
  const std::optional<Point> of_key = search.find(is_exact);
  if (is_exact || !has_points(path)) return of_key;
  const Sentence sentence(message.sentence, sketch.data.units().length.si);
  if (const auto point = sentence.find_point("around ")) return point;
  if (const auto point = sentence.find_middle_point()) return point;
  if (const auto point = sentence.find_point("")) return point;
  if (const auto x = sentence.find_x())
    if (const auto point = search.find_at(*x)) return point;
  return of_key;
}

}  // namespace talus::run
