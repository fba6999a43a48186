// SPDX-License-Identifier: MIT
#include "drawing/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <cmath>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/case_text.hpp"
#include "mesh/layers.hpp"

namespace talus::drawing {
namespace {

using mesh::Point2;
using mesh::Polyline;

/// Lines of one layer that meet, as one.
struct Chain {
  std::string layer, handle;
  bool closed = false;
  Polyline points;
};

bool has_word(const std::string& layer, std::initializer_list<const char*> words) {
  const std::string name = to_lower(layer);
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return name.find(w) != std::string::npos; });
}

bool is_water(const std::string& layer) {
  return has_word(layer, {"water", "phreatic", "piezo", "gwt", "gwl"});
}

bool is_ground(const std::string& layer) {
  return !is_water(layer) && has_word(layer, {"ground", "surface", "terrain", "topo"});
}

/// Joins the lines of a layer at points in which exactly two of them end.
class Joiner {
 public:
  explicit Joiner(double tolerance) : tolerance_(tolerance) {}

  std::vector<Chain> join(const std::vector<Chain>& lines) {
    std::vector<Chain> joined;
    ends_.clear();
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (!lines[i].closed)
        for (const Point2* p : {&lines[i].points.front(), &lines[i].points.back()})
          ends_[get_cell(*p)].push_back({i, *p});
    std::vector<char> is_used(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (is_used[i]) continue;
      is_used[i] = 1;
      Chain chain = lines[i];
      for (int side = 0; side < 2 && !chain.closed; ++side) {
        while (const auto next = find_next(chain.points.back(), is_used)) {
          is_used[*next] = 1;
          Polyline more = lines[*next].points;
          if (!meets(more.front(), chain.points.back())) std::reverse(more.begin(), more.end());
          chain.points.insert(chain.points.end(), more.begin() + 1, more.end());
        }
        if (chain.points.size() > 3 && meets(chain.points.front(), chain.points.back())) {
          chain.points.pop_back();
          chain.closed = true;
        }
        std::reverse(chain.points.begin(), chain.points.end());
      }
      joined.push_back(std::move(chain));
    }
    return joined;
  }

  bool meets(const Point2& a, const Point2& b) const { return std::hypot(a[0] - b[0], a[1] - b[1]) <= tolerance_; }

 private:
  struct End {
    std::size_t line;
    Point2 at;
  };
  using Cell = std::array<double, 2>;
  Cell get_cell(const Point2& p) const { return {std::floor(p[0] / tolerance_), std::floor(p[1] / tolerance_)}; }

  /// Returns the unused line that ends at `p`, if it is the only other one.
  std::optional<std::size_t> find_next(const Point2& p, const std::vector<char>& is_used) const {
    std::optional<std::size_t> found;
    int count = 0;
    const Cell centre = get_cell(p);
    for (const double dx : {-1.0, 0.0, 1.0})
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto cell = ends_.find({centre[0] + dx, centre[1] + dy});
        if (cell == ends_.end()) continue;
        for (const End& end : cell->second) {
          if (!meets(end.at, p)) continue;
          ++count;
          if (!is_used[end.line]) found = end.line;
        }
      }
    return count == 2 ? found : std::nullopt;
  }

  double tolerance_;
  std::map<Cell, std::vector<End>> ends_;
};

bool is_a_place(const Point2& p) {
  constexpr double farthest = 1e9;  // [m]
  return std::abs(p[0]) < farthest && std::abs(p[1]) < farthest;
}

double measure_extent(const std::vector<Chain>& chains) {
  Point2 low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Chain& chain : chains)
    for (const Point2& p : chain.points)
      for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], p[d]), high[d] = std::max(high[d], p[d]);
  return std::max(high[0] - low[0], high[1] - low[1]);
}

void drop_repeated(Polyline& points, const Joiner& joiner) {
  points.erase(
      std::unique(points.begin(), points.end(), [&](const Point2& a, const Point2& b) { return joiner.meets(a, b); }),
      points.end());
}

/// Returns the line without points within `tolerance` of it (Douglas and Peucker).
Polyline simplify(const Polyline& line, bool closed, double tolerance) {
  using Place = boost::geometry::model::d2::point_xy<double>;
  boost::geometry::model::linestring<Place> all, fewer;
  for (const Point2& p : line) all.emplace_back(p[0], p[1]);
  if (closed) all.push_back(all.front());
  boost::geometry::simplify(all, fewer, tolerance);
  if (closed) fewer.pop_back();
  if (closed && fewer.size() < 3) return line;
  Polyline points;
  for (const Place& p : fewer) points.push_back({p.x(), p.y()});
  return points;
}

/// Returns the mean height of a line over another one where both are; NaN where they have no common x.
double compare_levels(const Polyline& a, const Polyline& b) {
  const double from = std::max(a.front()[0], b.front()[0]), to = std::min(a.back()[0], b.back()[0]);
  if (!(to > from)) return std::nan("");
  constexpr int samples = 32;
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = from + (to - from) * (i + 0.5) / samples;
    sum += mesh::find_level(a, x) - mesh::find_level(b, x);
  }
  return sum / samples;
}

/// Splits an outline into the line above and the line below, both from left to right.
std::pair<Polyline, Polyline> split_outline(const Polyline& outline) {
  const std::size_t n = outline.size();
  const auto select = [&](auto&& is_better) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (is_better(outline[i], outline[best])) best = i;
    return best;
  };
  const auto is_left = [](const Point2& a, const Point2& b) { return a[0] < b[0]; };
  const auto is_right = [](const Point2& a, const Point2& b) { return a[0] > b[0]; };
  const auto walk = [&](std::size_t from, std::size_t to, std::size_t step) {
    Polyline line{outline[from]};
    for (std::size_t i = from; i != to;) line.push_back(outline[i = (i + step) % n]);
    return line;
  };
  const auto at_end = [&](bool left, bool top) {
    return select([&](const Point2& a, const Point2& b) {
      if (a[0] != b[0]) return left ? is_left(a, b) : is_right(a, b);
      return top ? a[1] > b[1] : a[1] < b[1];
    });
  };
  const bool clockwise = mesh::compute_area(outline) < 0;
  const std::size_t forward = clockwise ? 1 : n - 1, backward = n - forward;
  return {walk(at_end(true, true), at_end(false, true), forward),
          walk(at_end(true, false), at_end(false, false), backward)};
}

class SectionFinder {
 public:
  SectionFinder(const Drawing& drawing, const SectionOptions& options) : drawing_(drawing), options_(options) {
    section_.remarks = drawing.remarks;
  }

  DrawnSection find() {
    std::vector<Chain> chains = list_chains();
    thin_out(chains);
    std::vector<Chain> open, closed, water;
    for (const Chain& chain : chains) {
      if (chain.closed)
        closed.push_back(chain);
      else if (const Polyline line = orient(chain); !line.empty())
        (is_water(chain.layer) ? water : open).push_back({chain.layer, chain.handle, false, line});
    }
    if (open.size() > most_boundaries)
      fail_input(
          "the drawing has {} lines that do not meet; a section has at most {} boundaries: name its layers with "
          "--layers",
          open.size(), most_boundaries);
    set_water(water);
    if (!open.empty()) set_layers(open, closed);
    add_regions(closed);
    if (section_.layers.empty() && section_.regions.empty())
      fail_input("the drawing shows no section: no closed lines, and no two lines above one another");
    remark_texts();
    return std::move(section_);
  }

 private:
  static constexpr std::size_t most_boundaries = 200;
  static constexpr std::size_t most_corners = 2000;  // of a section: its checks are of quadratic cost

  /// Leaves out points that are nearly on the line between others, if there are too many.
  void thin_out(std::vector<Chain>& chains) {
    const auto count = [&] {
      std::size_t sum = 0;
      for (const Chain& chain : chains) sum += chain.points.size();
      return sum;
    };
    const std::size_t before = count();
    double used = 0;
    for (double tolerance = tolerance_; count() > most_corners && tolerance < 100 * tolerance_; tolerance *= 2) {
      used = tolerance;
      for (Chain& chain : chains)
        if (chain.points.size() > 2) chain.points = simplify(chain.points, chain.closed, tolerance);
    }
    if (count() > most_corners)
      fail_input(
          "the drawing has {} points, and a section at most {}: even with lines that move by a thousandth of it, {} "
          "remain. "
          "Simplify them, or name the layers of the section with --layers",
          before, most_corners, count());
    if (used > 0)
      section_.remarks.push_back(fmt::format("{} of {} points were left out; the lines moved by less than {:.2g} m",
                                             before - count(), before, 2 * used));
  }

  void remark(const Chain& chain, const std::string& what) {
    section_.remarks.push_back(fmt::format("the line {} on layer '{}' {}", chain.handle, chain.layer, what));
  }

  bool is_asked(const std::string& layer) const {
    return options_.layers.empty() ||
           std::find(options_.layers.begin(), options_.layers.end(), layer) != options_.layers.end();
  }

  std::vector<Chain> list_chains() {
    std::map<std::string, std::vector<Chain>> by_layer;
    std::vector<Chain> all;
    for (const DrawnLine& line : drawing_.lines) {
      if (!is_asked(line.layer)) continue;
      if (options_.layers.empty() && is_result_line(line)) {
        ++result_lines_;
        continue;
      }
      Chain chain{line.layer, line.handle, line.closed, line.points};
      for (Point2& p : chain.points)
        for (double& c : p) c *= options_.unit;
      if (std::all_of(chain.points.begin(), chain.points.end(), is_a_place))
        all.push_back(std::move(chain));
      else
        remark(chain, "has a coordinate that is not a number or too large, and was left out");
    }
    if (result_lines_ > 0)
      section_.remarks.push_back(
          fmt::format("{} slip surfaces and ponds of talus export were left out", result_lines_));
    for (const std::string& layer : options_.layers)
      if (std::none_of(all.begin(), all.end(), [&](const Chain& c) { return c.layer == layer; }))
        fail_input("the drawing has no lines on a layer '{}'", layer);
    if (all.empty()) fail_input("the drawing has no lines");
    const double extent = measure_extent(all);
    if (!(extent > 0)) fail_input("the drawing has no extent");
    tolerance_ = 1e-5 * extent;
    Joiner joiner(tolerance_);
    for (Chain& chain : all) {
      drop_repeated(chain.points, joiner);
      if (chain.points.size() < (chain.closed ? 3u : 2u))
        remark(chain, "is shorter than a hundred-thousandth of the section and was left out");
      else
        by_layer[chain.layer].push_back(std::move(chain));
    }
    std::vector<Chain> chains;
    for (const auto& [layer, lines] : by_layer)
      for (Chain& chain : joiner.join(lines)) chains.push_back(std::move(chain));
    return chains;
  }

  /// Returns the points of a line from left to right; none if it is vertical or folds back.
  Polyline orient(const Chain& chain) {
    Polyline line = chain.points;
    if (line.front()[0] > line.back()[0]) std::reverse(line.begin(), line.end());
    if (line.front()[0] == line.back()[0]) return remark(chain, "is vertical and was left out"), Polyline{};
    if (const int fold = mesh::find_fold(line); fold > 0) {
      remark(chain, fmt::format("folds back at x = {:.6g} m and was left out; draw an overhang as closed regions",
                                line[static_cast<std::size_t>(fold)][0]));
      return {};
    }
    return line;
  }

  void set_water(std::vector<Chain>& water) {
    if (water.empty()) return;
    section_.water_table = water.front().points;
    for (std::size_t i = 1; i < water.size(); ++i) remark(water[i], "is a second water table and was left out");
  }

  /// Sorts lines from the top down.
  static void sort_down(std::vector<Chain>& lines) {
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      std::size_t top = i;
      for (std::size_t k = i + 1; k < lines.size(); ++k)
        if (compare_levels(lines[k].points, lines[top].points) > 0) top = k;
      std::rotate(lines.begin() + static_cast<std::ptrdiff_t>(i), lines.begin() + static_cast<std::ptrdiff_t>(top),
                  lines.begin() + static_cast<std::ptrdiff_t>(top) + 1);
    }
  }

  void set_layers(std::vector<Chain>& lines, std::vector<Chain>& closed) {
    sort_down(lines);
    Chain base;
    if (closed.size() == 1 &&
        std::none_of(lines.begin(), lines.end(), [](const Chain& c) { return is_ground(c.layer); })) {
      auto [top, bottom] = split_outline(closed.front().points);
      if (mesh::find_fold(top) < 0 && mesh::find_fold(bottom) < 0) {
        remark(closed.front(), "is the outline of the section");
        lines.insert(lines.begin(), {closed.front().layer, closed.front().handle, false, top});
        base = {"base", closed.front().handle, false, bottom};
        closed.clear();
      }
    } else {
      const auto ground = std::find_if(lines.begin(), lines.end(), [](const Chain& c) { return is_ground(c.layer); });
      if (ground != lines.end()) std::rotate(lines.begin(), ground, ground + 1);
    }
    if (options_.base && base.points.empty()) {
      const Polyline& ground = lines.front().points;
      base = {"base", "", false, {{ground.front()[0], *options_.base}, {ground.back()[0], *options_.base}}};
    }
    if (lines.size() < 2 && base.points.empty()) {
      remark(lines.front(), "is the only open one and was left out");
      return;
    }
    section_.ground = lines.front().points;
    remark(lines.front(), "is the ground");
    for (std::size_t i = 1; i < lines.size() && !options_.role; ++i)
      if (has_word(lines[i].layer, {"top"}))
        fail_input(
            "layer '{}' of the drawing is named after a top: say with --lines tops or --lines bottoms what its lines "
            "are",
            lines[i].layer);
    const bool tops = options_.role == LineRole::tops;
    if (tops && base.points.empty())
      fail_input(
          "with lines that are the tops of soils, the section needs a base: give --base, or draw a closed outline");
    for (std::size_t i = 1; i < lines.size(); ++i)
      section_.layers.push_back({name(tops ? lines[i - 1].layer : lines[i].layer), lines[i].points});
    if (!base.points.empty()) section_.layers.push_back({name(tops ? lines.back().layer : base.layer), base.points});
  }

  std::string name(const std::string& wanted) { return take_name(names_, wanted); }

  /// Names regions after the only text in them, or after their layers. A text belongs to the smallest region around it.
  void add_regions(const std::vector<Chain>& closed) {
    std::vector<std::vector<const DrawnText*>> labels(closed.size());
    for (const DrawnText& text : drawing_.texts) {
      if (!is_asked(text.layer)) continue;
      const Point2 at{text.at[0] * options_.unit, text.at[1] * options_.unit};
      std::optional<std::size_t> smallest;
      for (std::size_t i = 0; i < closed.size(); ++i)
        if (mesh::is_inside(at, closed[i].points) &&
            (!smallest ||
             std::abs(mesh::compute_area(closed[i].points)) < std::abs(mesh::compute_area(closed[*smallest].points))))
          smallest = i;
      if (smallest) labels[*smallest].push_back(&text);
    }
    for (std::size_t i = 0; i < closed.size(); ++i) {
      const bool has_one = labels[i].size() == 1;
      section_.regions.push_back({name(has_one ? labels[i].front()->text : closed[i].layer), closed[i].points});
      if (has_one) ++used_texts_;
    }
  }

  void remark_texts() {
    const auto count = static_cast<int>(drawing_.texts.size()) - used_texts_;
    if (count > 0) section_.remarks.push_back(fmt::format("{} text{} not used", count, count == 1 ? " was" : "s were"));
  }

  const Drawing& drawing_;
  const SectionOptions& options_;
  DrawnSection section_;
  std::set<std::string> names_;
  double tolerance_ = 0;  ///< length below which distances count as zero [m]
  int used_texts_ = 0, result_lines_ = 0;
};

}  // namespace

DrawnSection find_section(const Drawing& drawing, const SectionOptions& options) {
  return SectionFinder(drawing, options).find();
}

std::string write_case(const DrawnSection& section, const std::string& source) {
  std::string text =
      fmt::format("# Section from {}. Complete the strengths, then: talus check\n\n", clean_text(source));
  std::vector<std::string> soils;
  if (!section.ground.empty()) text += fmt::format("[geometry]\nground = {}\n\n", write_points(section.ground));
  for (const DrawnSoil& soil : section.layers) {
    text += fmt::format("[[geometry.layer]]\nname = \"{}\"\nbottom = {}\n\n", soil.name, write_points(soil.points));
    soils.push_back(soil.name);
  }
  for (const DrawnSoil& soil : section.regions) {
    text += fmt::format("[[geometry.polygon]]\nname = \"{}\"\npoints = {}\n\n", soil.name, write_points(soil.points));
    soils.push_back(soil.name);
  }
  text += "[regions]\n";
  for (const std::string& soil : soils) text += fmt::format("\"{0}\" = \"{0}\"\n", soil);
  for (const std::string& soil : soils)
    text += fmt::format(
        "\n[materials.\"{}\"]\nmodel = \"mohr_coulomb\"\n# unit_weight =     # kN/m3\n# cohesion =        # kPa\n"
        "# friction_angle =  # deg\n",
        soil);
  if (!section.water_table.empty())
    text += fmt::format("\n[initial]\npore_pressure = \"water_table\"\nwater_table = {}\n",
                        write_points(section.water_table));
  return text + "\n[analysis]\nmethods = [\"lem\"]\n";
}

}  // namespace talus::drawing
