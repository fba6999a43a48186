// SPDX-License-Identifier: MIT
#include "drawing/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/case_text.hpp"
#include "drawing/lines.hpp"
#include "drawing/subdivision.hpp"
#include "mesh/layers.hpp"

namespace talus::drawing {
namespace {

using mesh::Point2;
using mesh::Polyline;

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

class SectionFinder {
 public:
  SectionFinder(const Drawing& drawing, const SectionOptions& options) : drawing_(drawing), options_(options) {
    section_.remarks = drawing.remarks;
  }

  DrawnSection find() {
    std::vector<Chain> chains = list_chains();
    thin_out(chains, tolerance_, "the drawing", section_.remarks);
    std::vector<Chain> lines, open, closed, water;
    for (Chain& chain : chains) {
      auto& list = chain.closed ? closed : is_water(chain.layer) ? water : lines;
      list.push_back(std::move(chain));
    }
    const bool has_areas = needs_areas(lines) && find_areas(lines, closed);
    for (const Chain& chain : has_areas ? std::vector<Chain>() : lines)
      if (const Polyline line = orient(chain); !line.empty()) open.push_back({chain.layer, chain.handle, false, line});
    if (open.size() > most_boundaries)
      fail_input(
          "the drawing has {} lines that do not meet; a section has at most {} boundaries: name its layers with "
          "--layers",
          open.size(), most_boundaries);
    set_water(water);
    if (!open.empty()) set_layers(open, closed);
    if (!has_areas) {
      for (const Chain& chain : closed) all_faces_.push_back(chain.points);
      for (const Chain& chain : closed) add_region(chain.points, chain.layer, chain.soil);
    }
    if (section_.layers.empty() && section_.regions.empty())
      fail_input("the drawing shows no section: no closed lines, and no two lines above one another");
    remark_texts();
    return std::move(section_);
  }

 private:
  static constexpr std::size_t most_boundaries = 200;
  static constexpr double largest_snap = 0.01;  // of the section

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
      Chain chain{line.layer, line.handle, line.closed, line.points, line.soil};
      for (Point2& p : chain.points)
        for (double& c : p) c *= options_.unit;
      if (std::all_of(chain.points.begin(), chain.points.end(), is_a_place))
        all.push_back(std::move(chain));
      else
        remark(chain, "has a coordinate that is not a number or too large, and was left out");
    }
    if (result_lines_ > 0)
      section_.remarks.push_back(
          fmt::format("{} slip surfaces, supports and ponds of talus export were left out", result_lines_));
    for (const std::string& layer : options_.layers)
      if (std::none_of(all.begin(), all.end(), [&](const Chain& c) { return c.layer == layer; }))
        fail_input("the drawing has no lines on a layer '{}'", layer);
    if (all.empty()) fail_input("the drawing has no lines");
    const double extent = measure_extent(all);
    if (!(extent > 0)) fail_input("the drawing has no extent");
    tolerance_ = meeting_distance * extent;
    for (Chain& chain : all) {
      drop_repeated(chain.points, tolerance_);
      if (chain.points.size() < (chain.closed ? 3u : 2u))
        remark(chain, "is shorter than a hundred-thousandth of the section and was left out");
      else
        by_layer[chain.layer].push_back(std::move(chain));
    }
    std::vector<Chain> chains;
    for (const auto& [layer, lines] : by_layer)
      for (Chain& chain : join_lines(lines, tolerance_)) chains.push_back(std::move(chain));
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

  void set_water(std::vector<Chain>& chains) {
    std::vector<Chain> water;
    for (const Chain& chain : chains)
      if (const Polyline line = orient(chain); !line.empty()) water.push_back({chain.layer, chain.handle, false, line});
    if (water.empty()) return;
    section_.water_table = water.front().points;
    for (std::size_t i = 1; i < water.size(); ++i) remark(water[i], "is a second water table and was left out");
  }

  void set_layers(std::vector<Chain>& lines, std::vector<Chain>& closed) {
    sort_from_ground(lines);
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

  /// Returns true if the lines are no boundaries from left to right above one another. Records where two of them cross;
  /// a boundary may cross the ground, which it then crops out at.
  bool needs_areas(const std::vector<Chain>& lines) {
    if (options_.form) return *options_.form == SectionForm::regions;
    std::vector<Chain> boundaries;
    bool has_others = false;
    for (Chain line : lines) {
      if (line.points.front()[0] > line.points.back()[0]) std::reverse(line.points.begin(), line.points.end());
      const bool is_boundary = line.points.front()[0] < line.points.back()[0] && mesh::find_fold(line.points) < 0;
      has_others = has_others || !is_boundary;
      if (is_boundary) boundaries.push_back(std::move(line));
    }
    sort_from_ground(boundaries);
    for (std::size_t i = 2; i < boundaries.size() && !crossing_; ++i)
      for (std::size_t k = 1; k < i && !crossing_; ++k)
        crossing_ = find_crossing(boundaries[k].points, boundaries[i].points, tolerance_);
    return has_others || crossing_;
  }

  /// Sorts lines from the top down, after one whose layer is named after the ground.
  static void sort_from_ground(std::vector<Chain>& lines) {
    sort_down(lines);
    const auto ground = std::find_if(lines.begin(), lines.end(), [](const Chain& c) { return is_ground(c.layer); });
    if (ground != lines.end()) std::rotate(lines.begin(), ground, ground + 1);
  }

  /// Adds sides and a base below the lines, as one line.
  void add_base(std::vector<Chain>& chains, double reach) const {
    Point2 left{1e300, -1e300}, right{-1e300, -1e300};
    for (const Chain& chain : chains)
      for (const Point2& p : chain.points) left[0] = std::min(left[0], p[0]), right[0] = std::max(right[0], p[0]);
    for (const Chain& chain : chains)
      for (const Point2& p : chain.points)
        for (Point2* end : {&left, &right})
          if (std::abs(p[0] - (*end)[0]) <= reach) (*end)[1] = std::max((*end)[1], p[1]);
    chains.push_back({"", "base", false, {left, {left[0], *options_.base}, {right[0], *options_.base}, right}});
  }

  /// Makes regions of the areas between the lines; returns false if most of their length bounds none.
  bool find_areas(const std::vector<Chain>& lines, const std::vector<Chain>& closed) {
    const bool is_forced = options_.form.has_value();
    if (!is_forced && !has_gdal()) return false;
    std::vector<Chain> chains = lines;
    chains.insert(chains.end(), closed.begin(), closed.end());
    const double extent = tolerance_ / meeting_distance;
    const double snap = options_.snap.value_or(snapping_distance * extent);
    if (!(snap >= tolerance_ && snap <= largest_snap * extent))
      fail_input("--snap is {:.3g} m; it must be from {:.3g} m to {:.3g} m in this drawing", snap, tolerance_,
                 largest_snap * extent);
    if (options_.base) add_base(chains, snap);
    const Subdivision found = subdivide(chains, snap);
    double loose = 0;
    for (const Subdivision::Dangle& dangle : found.dangles) loose += dangle.length;
    if (found.faces.empty() || (!is_forced && loose > 0.5 * measure_length(lines))) {
      if (is_forced)
        fail_input("the lines of the drawing enclose no area: draw the sides and the base, or give --base");
      if (crossing_)
        section_.remarks.push_back(
            fmt::format("lines cross at ({:.6g}, {:.6g}) m, and most of them enclose no areas: they are boundaries of "
                        "layers. With a base (--base) they enclose areas, and --as regions uses these",
                        (*crossing_)[0], (*crossing_)[1]));
      return false;
    }
    if (found.faces.size() > most_boundaries)
      fail_input("the lines of the drawing enclose {} areas; a section has at most {}: name its layers with --layers",
                 found.faces.size(), most_boundaries);
    remark_subdivision(found, snap);
    add_areas(found.faces, chains);
    return true;
  }

  static double measure_length(const std::vector<Chain>& lines) {
    double sum = 0;
    for (const Chain& line : lines)
      for (std::size_t i = 1; i < line.points.size(); ++i)
        sum += std::hypot(line.points[i][0] - line.points[i - 1][0], line.points[i][1] - line.points[i - 1][1]);
    return sum;
  }

  void remark_subdivision(const Subdivision& found, double snap) {
    constexpr std::size_t most_named = 8;
    section_.remarks.push_back(
        fmt::format("the lines cross or touch: their {} areas are the soils. Ends and corners nearer than {:.3g} m are "
                    "one (--snap)",
                    found.faces.size(), snap));
    const auto list = [&](const auto& items, auto&& write) {
      for (std::size_t i = 0; i < std::min(items.size(), most_named); ++i) section_.remarks.push_back(write(items[i]));
      if (items.size() > most_named)
        section_.remarks.push_back(fmt::format("… and {} more of this kind", items.size() - most_named));
    };
    list(found.snaps, [](const Subdivision::Snap& s) {
      return fmt::format("a gap of {:.3g} m at ({:.6g}, {:.6g}) m was closed", s.gap, s.at[0], s.at[1]);
    });
    list(found.dangles, [](const Subdivision::Dangle& d) {
      return fmt::format(
          "a part of a line, {:.4g} m long, that ends at ({:.6g}, {:.6g}) m bounds no area and was left out", d.length,
          d.end[0], d.end[1]);
    });
  }

  void add_areas(std::vector<Polyline> faces, const std::vector<Chain>& chains) {
    const auto get_top = [](const Polyline& face) {
      return *std::max_element(face.begin(), face.end(), [](const Point2& a, const Point2& b) { return a[1] < b[1]; });
    };
    std::sort(faces.begin(), faces.end(), [&](const Polyline& a, const Polyline& b) {
      const Point2 p = get_top(a), q = get_top(b);
      return p[1] != q[1] ? p[1] > q[1] : p[0] < q[0];
    });
    all_faces_ = faces;
    const bool is_below = options_.role == LineRole::bottoms;
    for (const Polyline& face : faces) {
      const std::string by = name_longest_side(face, chains, is_below);
      const std::string how = add_region(face, by);
      const Point2 top = get_top(face);
      section_.remarks.push_back(
          fmt::format("the area of {:.4g} m² below ({:.6g}, {:.6g}) m is '{}', by {}",
                      std::abs(mesh::compute_area(face)), top[0], top[1], section_.regions.back().name,
                      !how.empty() ? how
                      : by.empty() ? "its number"
                                   : fmt::format("the layer of the line {} it", is_below ? "below" : "above")));
    }
  }

  /// Returns the layer of the lines that bound the upper or lower side of an area for the greatest width; empty for the
  /// default layer of CAD, "0".
  static std::string name_longest_side(const Polyline& face, const std::vector<Chain>& chains, bool is_below) {
    std::map<std::string, double> widths;
    const bool is_clockwise = mesh::compute_area(face) < 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Point2 &a = face[i], &b = face[(i + 1) % face.size()];
      const double width = is_clockwise == is_below ? a[0] - b[0] : b[0] - a[0];
      if (!(width > 0)) continue;
      const Point2 middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
      const Chain* nearest = nullptr;
      double least = 1e300;
      for (const Chain& chain : chains) {
        const double distance =
            mesh::compute_distance(middle, chain.closed ? mesh::close_polygon(chain.points) : chain.points);
        if (distance < least) least = distance, nearest = &chain;
      }
      if (nearest != nullptr) widths[nearest->layer] += width;
    }
    const auto widest = std::max_element(widths.begin(), widths.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return widest == widths.end() || widest->first == "0" ? "" : widest->first;
  }

  /// Adds a region with the name of `soil`, or of the only text in it, or of `layer`, or a number. Regions of one soil
  /// or text are of one material. Returns "its text" if it has one.
  std::string add_region(const Polyline& outline, const std::string& layer, const std::string& soil = {}) {
    std::set<std::string> labels;
    int count = 0;
    for (const DrawnText& text : drawing_.texts) {
      const Point2 at{text.at[0] * options_.unit, text.at[1] * options_.unit};
      if (!is_asked(text.layer) || !mesh::is_inside(at, outline)) continue;
      // A text in an area within this one belongs to that.
      const double area = std::abs(mesh::compute_area(outline));
      if (std::any_of(all_faces_.begin(), all_faces_.end(), [&](const Polyline& other) {
            return std::abs(mesh::compute_area(other)) < area && mesh::is_inside(at, other);
          }))
        continue;
      labels.insert(text.text);
      ++count;
    }
    if (!soil.empty()) labels = {soil}, count = 0;
    if (labels.size() != 1) {
      section_.regions.push_back(
          {name(layer.empty() ? fmt::format("soil {}", section_.regions.size() + 1) : layer), outline});
      return "";
    }
    used_texts_ += count;
    const std::string& label = *labels.begin();
    DrawnSoil& region = section_.regions.emplace_back();
    region.name = name(label);
    region.points = outline;
    region.material = materials_.try_emplace(label, region.name).first->second;
    return "its text";
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
  int used_texts_ = 0;
  int result_lines_ = 0;  ///< of slip surfaces, supports and ponds of an export
  std::vector<Polyline> all_faces_;
  std::map<std::string, std::string> materials_;  ///< text → material
  std::optional<Point2> crossing_;                ///< of two boundaries
};

}  // namespace

DrawnSection find_section(const Drawing& drawing, const SectionOptions& options) {
  return SectionFinder(drawing, options).find();
}

std::string write_case(const DrawnSection& section, const std::string& source) {
  std::string text =
      fmt::format("# Section from {}. Complete the strengths, then: talus check\n\n", clean_text(source));
  std::string regions = "[regions]\n";
  std::vector<std::string> materials;
  const auto add_soil = [&](const DrawnSoil& soil) {
    const std::string& material = soil.material.empty() ? soil.name : soil.material;
    regions += fmt::format("\"{}\" = \"{}\"\n", soil.name, material);
    if (std::find(materials.begin(), materials.end(), material) == materials.end()) materials.push_back(material);
  };
  if (!section.ground.empty()) text += fmt::format("[geometry]\nground = {}\n\n", write_points(section.ground));
  for (const DrawnSoil& soil : section.layers) {
    text += fmt::format("[[geometry.layer]]\nname = \"{}\"\n", soil.name);
    if (soil.level)
      text += fmt::format("level = {}\n\n", std::round(*soil.level * 1e6) / 1e6 + 0.0);
    else
      text += fmt::format("{} = {}\n\n", soil.are_depths ? "depths" : "bottom", write_points(soil.points));
    add_soil(soil);
  }
  for (const DrawnSoil& soil : section.regions) {
    text += fmt::format("[[geometry.polygon]]\nname = \"{}\"\npoints = {}\n\n", soil.name, write_points(soil.points));
    add_soil(soil);
  }
  text += regions;
  for (const std::string& material : materials)
    text += fmt::format(
        "\n[materials.\"{}\"]\nmodel = \"mohr_coulomb\"\n# unit_weight =     # kN/m3\n# cohesion =        # kPa\n"
        "# friction_angle =  # deg\n",
        material);
  if (!section.water_table.empty())
    text += fmt::format("\n[initial]\npore_pressure = \"water_table\"\nwater_table = {}\n",
                        write_points(section.water_table));
  return text + "\n[analysis]\nmethods = [\"lem\"]\n";
}

}  // namespace talus::drawing
