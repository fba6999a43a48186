// SPDX-License-Identifier: MIT
#include "input/case/layers.hpp"

#include <fmt/format.h>
#include <math.h>  // NOLINT(modernize-deprecated-headers): PCHIP of Boost 1.74 needs ::isnan

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <filesystem>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/units.hpp"
#include "input/case/case.hpp"
#include "input/case/checks.hpp"
#include "input/case/series_file.hpp"
#include "input/case/text_table.hpp"
#include "input/language/visitor.hpp"
#include "mesh/layers.hpp"

namespace talus::input {

void describe(Visitor& v, LayerInput& l) {
  v.key("name", l.name, plain().required().example(R"("clay")"), "Name of the region; [regions] gives it a material.");
  v.key("bottom", l.bottom, quantity("m").example("[[0, 4], [44, 2]]"),
        "Lower boundary as points from left to right, or a table. A line that ends inside the section at the boundary "
        "above pinches out there; otherwise it continues level. Each layer needs one of `bottom`, `level`, `thickness` "
        "and `depths`.");
  v.key("level", l.level, quantity("m").example("-5"), "Level of a horizontal lower boundary.");
  v.key("thickness", l.thickness, quantity("m").above(0).example("0.5"),
        "Vertical distance of the lower boundary from the one above, or from the ground.");
  v.key("depths", l.depths, quantity("m").example("[[4, 3.2], [20, 2.5]]"),
        "Boreholes: position along x, and depth of the lower boundary below the ground there. A layer that a borehole "
        "does not meet has the depth of the one above. In a table, boreholes that end higher have an empty cell.");
  v.key("between", l.between, plain(),
        "How the boundary runs between boreholes. Beyond the first and the last its depth is constant.");
  v.key("cut", l.cut, plain(),
        "true: the boundary above cuts this one where they cross, as an erosion surface does. By default, crossing "
        "boundaries are a fault. The ground always cuts, and boundaries between boreholes are always cut.");
}
namespace {

using mesh::Point2;
using mesh::Polyline;

constexpr std::size_t most_points = 5000;  // of all boundaries: the checks of a section are of quadratic cost

/// Returns the index of a column, which is `name`, or `usual` if the table has it, or the `index`-th one.
std::size_t select_column(const TextTable& table, const std::string& name, const char* usual, std::size_t index) {
  if (!name.empty()) return table.find_column(name);
  return table.has_column(usual) ? table.find_column(usual) : index;
}

/// Reads the points of a table; rows without a value of y are left out.
Polyline read_points(const PointsFile& source, const std::filesystem::path& folder) {
  const TextTable table((folder / source.file).lexically_normal());
  if (table.header().size() < 2) fail_input("'{}' has one column; points need two, x and y", table.file());
  const std::array columns{select_column(table, source.x, "x", 0), select_column(table, source.y, "y", 1)};
  std::array<double, 2> factor{1, 1};
  for (std::size_t d = 0; d < 2; ++d) {
    const TextTable::Heading& heading = table.header()[columns[d]];
    if (!heading.unit.empty())
      factor[d] =
          units::parse_as_si("1 " + heading.unit, "m", fmt::format("column '{}' of '{}'", heading.name, table.file()));
  }
  if (table.rows() > most_points)
    fail_input(
        "'{}' has {} rows, and a boundary has at most {} points: leave out those that lie nearer together than "
        "the elements are large",
        table.file(), table.rows(), most_points);
  Polyline points;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (!is_missing(table.cell(row, columns[1]), -99))
      points.push_back({table.number(row, columns[0]) * factor[0], table.number(row, columns[1]) * factor[1]});
  return points;
}

/// Adds the line through the boreholes to `line`.
void draw_between(const std::vector<double>& x, const std::vector<double>& level, Interpolation between,
                  Polyline& line) {
  constexpr std::size_t least_for_spline = 4;
  constexpr int parts = 16;  // of an interval between boreholes
  if (between == Interpolation::linear || x.size() < least_for_spline) {
    for (std::size_t i = 0; i < x.size(); ++i) line.push_back({x[i], level[i]});
    return;
  }
  const auto curve = boost::math::interpolators::pchip(std::vector(x), std::vector(level));
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (int k = 0; k < parts; ++k) {
      const double at = x[i] + (x[i + 1] - x[i]) * k / parts;
      line.push_back({at, curve(at)});
    }
  line.push_back({x.back(), level.back()});
}

/// Reads and checks the boundary lines of a case.
class LayerReader {
 public:
  LayerReader(Case& data, const std::string& file, Findings& findings)
      : data_(data), folder_(std::filesystem::path(file).parent_path()), findings_(findings) {}

  /// Returns true if `points` are a line from left to right with at least `least` points.
  bool read_line(SurveyPoints& points, const std::string& path, const std::string& what, std::size_t least) {
    if (!findings_.is_sound(path)) return false;
    if (points.source) {
      try {
        points.points = read_points(*points.source, folder_);
      } catch (const Error& error) {
        findings_.add(path, error.what());
        return false;
      }
    }
    const Polyline& line = points.points;
    if (line.size() < least) {
      findings_.add(path, "{} has {} point{}; it needs at least {}", what, line.size(), line.size() == 1 ? "" : "s",
                    least);
      return false;
    }
    if (line.size() > most_points) {
      findings_.add(path, "{} has {} points, and a section has at most {}", what, line.size(), most_points);
      return false;
    }
    points_ += line.size();
    if (const int fold = mesh::find_fold(line); fold > 0) {
      const std::string at = points.source ? path : fmt::format("{}.{}", path, fold);
      const std::size_t i = static_cast<std::size_t>(fold);
      findings_.add(at,
                    "{} folds back from x = {} to x = {}: give its points from left to right. An overhang needs "
                    "[[geometry.polygon]]",
                    what, write_x(line[i - 1][0]), write_x(line[i][0]));
      return false;
    }
    return true;
  }

  /// Returns true if the layer has exactly one lower boundary.
  bool check_kind(const LayerInput& layer, const std::string& path) {
    const auto is_given = [&](const char* key) { return findings_.places.is_given(path + "." + key); };
    std::vector<std::string> given;
    for (const char* key : {"bottom", "level", "thickness", "depths"})
      if (is_given(key)) given.emplace_back(key);
    if (given.size() != 1) {
      findings_.add(path, "layer '{}' has {}; it needs exactly one of 'bottom', 'level', 'thickness' and 'depths'",
                    layer.name,
                    given.empty() ? "no lower boundary" : fmt::format("both '{}' and '{}'", given[0], given[1]));
      return false;
    }
    if (is_given("between") && given[0] != "depths")
      findings_.add(path + ".between", "'between' has no meaning without 'depths'");
    return true;
  }

  /// Returns the boundary between boreholes, and true if they are from left to right within the ground.
  bool join_boreholes(const LayerInput& layer, const Polyline& ground, const std::string& path, Polyline& line) {
    const Polyline& depths = layer.depths.points;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const auto [x, depth] = depths[i];
      const std::string at = layer.depths.source ? path : fmt::format("{}.{}", path, i);
      if (x < ground.front()[0] || x > ground.back()[0]) {
        findings_.add(at,
                      "the borehole at x = {} of layer '{}' is outside the ground, which goes from x = {} to x = {}",
                      write_x(x), layer.name, write_x(ground.front()[0]), write_x(ground.back()[0]));
        return false;
      }
      if (depth < 0) {
        findings_.add(at, "the borehole at x = {} of layer '{}' has a negative depth; depths are below the ground",
                      write_x(x), layer.name);
        return false;
      }
      if (i > 0 && x == depths[i - 1][0]) {
        findings_.add(at, "layer '{}' has two boreholes at x = {}", layer.name, write_x(x));
        return false;
      }
    }
    std::vector<double> x, level;
    for (const auto& [at, depth] : depths) {
      x.push_back(at);
      level.push_back(mesh::find_level(ground, at) - depth);
    }
    line.clear();
    for (const Point2& p : ground)
      if (p[0] < x.front()) line.push_back({p[0], p[1] - depths.front()[1]});
    draw_between(x, level, layer.between, line);
    for (const Point2& p : ground)
      if (p[0] > x.back()) line.push_back({p[0], p[1] - depths.back()[1]});
    const auto warn = [&](double from, double to) {
      if (to > from)
        findings_.warn(path,
                       "layer '{}' has no borehole from x = {} to x = {}; its depth there is that of the nearest one",
                       layer.name, write_x(from), write_x(to));
    };
    warn(ground.front()[0], x.front());
    warn(x.back(), ground.back()[0]);
    return true;
  }

  /// Returns true if all layers are sound.
  bool read(std::vector<mesh::Layer>& layers) {
    Layering& layering = data_.layering;
    const Polyline& ground = layering.ground.points;
    bool is_sound = read_line(layering.ground, "geometry.ground", "the ground", 2);
    if (is_sound && !(ground.back()[0] > ground.front()[0])) {
      findings_.add("geometry.ground", "the ground has no width");
      is_sound = false;
    }
    const bool has_ground = is_sound;
    for (std::size_t i = 0; i < layering.layers.size(); ++i) {
      LayerInput& input = layering.layers[i];
      const std::string path = fmt::format("geometry.layer.{}", i);
      const std::string what = fmt::format("the lower boundary of layer '{}'", input.name);
      mesh::Layer& layer = layers.emplace_back();
      layer.name = input.name;
      layer.cut = input.cut;
      bool is_good = findings_.is_sound(path) && check_kind(input, path);
      if (is_good && findings_.places.is_given(path + ".bottom"))
        is_good = read_line(input.bottom, path + ".bottom", what, 2), layer.bottom = input.bottom.points;
      if (is_good && findings_.places.is_given(path + ".depths")) {
        layer.cut = true;
        is_good = read_line(input.depths, path + ".depths", "the list of boreholes of layer '" + input.name + "'", 1) &&
                  has_ground && join_boreholes(input, ground, path + ".depths", layer.bottom);
      }
      layer.thickness = input.thickness;
      if (input.level && has_ground)
        layer.bottom = {{ground.front()[0], *input.level}, {ground.back()[0], *input.level}};
      is_sound = is_sound && is_good;
    }
    if (is_sound && points_ > most_points) {
      findings_.add("geometry.layer", "the ground and the boundaries have {} points, and a section has at most {}",
                    points_, most_points);
      return false;
    }
    return is_sound;
  }

  /// Reports the notes on the built section, those of one kind on one layer in one sentence.
  void report(const mesh::LayeredSection& section) {
    std::map<std::pair<int, mesh::LayerNote::Kind>, std::pair<mesh::LayerNote, int>> largest;
    for (const mesh::LayerNote& note : section.notes) {
      auto& [worst, count] = largest[{note.layer, note.kind}];
      if (count++ == 0 || note.size > worst.size) worst = note;
    }
    for (const auto& [key, found] : largest) {
      const auto& [note, count] = found;
      const std::string& name = data_.layering.layers[static_cast<std::size_t>(note.layer)].name;
      const std::string path = fmt::format("geometry.layer.{}", note.layer);
      const std::string others = count > 1 ? fmt::format(", and in {} further places", count - 1) : "";
      if (note.kind == mesh::LayerNote::Kind::crossed)
        findings_.add(path,
                      "the lower boundary of layer '{}' is above the one of the layer above{}, by up to {}{}: correct "
                      "it, or write cut = true where the boundary above cuts it",
                      name, write_span(note), write_length(note.size), others);
      else
        findings_.warn(path, write_change(note, name) + others);
    }
  }

 private:
  std::string write_x(double x) const { return format_coordinate(x, data_.units().length); }
  std::string write_length(double size) const { return format_value(size, data_.units().length, 2); }
  std::string write_span(const mesh::LayerNote& note) const {
    return note.from == note.to ? fmt::format(" at x = {}", write_x(note.from))
                                : fmt::format(" from x = {} to x = {}", write_x(note.from), write_x(note.to));
  }
  std::string write_change(const mesh::LayerNote& note, const std::string& name) const {
    using Kind = mesh::LayerNote::Kind;
    switch (note.kind) {
      case Kind::outcrop:
        return fmt::format("the lower boundary of layer '{}' is above the ground{}, and ends there", name,
                           write_span(note));
      case Kind::cut:
        return fmt::format("the lower boundary of layer '{}' is cut by the one above{}, by up to {}", name,
                           write_span(note), write_length(note.size));
      case Kind::extended:
        return fmt::format("the lower boundary of layer '{}' ends inside the section and continues level{}", name,
                           write_span(note));
      case Kind::trimmed:
        return fmt::format("the lower boundary of layer '{}' goes{}, and is cut off at the ends of the ground", name,
                           write_span(note));
      case Kind::sliver:
        return fmt::format("layer '{}' is thinner than 'smallest_thickness'{}, and was removed there (up to {})", name,
                           write_span(note), write_length(note.size));
      default:
        return fmt::format("nothing is left of layer '{}': it has no thickness anywhere", name);
    }
  }

  Case& data_;
  std::filesystem::path folder_;
  Findings& findings_;
  std::size_t points_ = 0;
};

/// Gives the parts of a layer its material, and records the place of the layer for messages on its polygons.
void name_parts(Case& data, const mesh::LayeredSection& section, Findings& findings) {
  std::set<std::string> built;
  for (std::size_t i = 0; i < section.polygons.size(); ++i) {
    const auto layer = static_cast<std::size_t>(section.layers[i]);
    const std::string &name = section.polygons[i].name, &of = data.layering.layers[layer].name;
    built.insert(of);
    if (const auto material = data.regions.find(of); material != data.regions.end())
      data.regions[name] = material->second;
    const Place place = findings.places.find(fmt::format("geometry.layer.{}", layer));
    findings.places.record(fmt::format("geometry.polygon.{}", data.mesh.polygons.size() + i), place.line, place.column);
  }
  for (const LayerInput& layer : data.layering.layers)
    if (!built.contains(layer.name)) data.regions.erase(layer.name);
}

}  // namespace

void build_layers(Case& data, const std::string& file, Findings& findings) {
  const bool has_ground = findings.places.is_given("geometry.ground");
  if (!has_ground && data.layering.layers.empty()) return;
  if (!has_ground)
    return findings.add("geometry.layer",
                        "[[geometry.layer]] needs 'ground' in [geometry], the surface above all layers");
  if (data.layering.layers.empty())
    return findings.add("geometry.ground", "'ground' needs at least one [[geometry.layer]] below it");
  if (!data.mesh.file.empty())
    return findings.add("geometry.layer", "[[geometry.layer]] has no meaning where 'mesh.file' is given");
  check_names(data.layering.layers, "geometry.layer", "layers", findings);
  std::vector<mesh::Layer> layers;
  LayerReader reader(data, file, findings);
  if (!reader.read(layers)) return;
  const mesh::LayeredSection section =
      mesh::make_layers(data.layering.ground.points, layers, data.layering.smallest_thickness);
  reader.report(section);
  name_parts(data, section, findings);
  data.mesh.polygons.insert(data.mesh.polygons.end(), section.polygons.begin(), section.polygons.end());
  data.layering = {};
}

}  // namespace talus::input
