// SPDX-License-Identifier: MIT
#include "drawing/geostudio.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <set>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/user_file.hpp"
#include "drawing/case_text.hpp"

namespace talus::drawing {
namespace {

constexpr std::uint64_t largest_archive = 500 * largest_file::megabyte, largest_model = 50 * largest_file::megabyte;
constexpr double most_expansion = 300;

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

/// Returns the index and the statistics of the only XML file at the root, or of the first one.
std::optional<zip_stat_t> find_model(zip_t* archive) {
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    if (zip_stat_index(archive, static_cast<zip_uint64_t>(i), 0, &stat) != 0 || stat.name == nullptr) continue;
    const std::string_view name(stat.name);
    if (name.ends_with(".xml") && name.find('/') == std::string_view::npos) return stat;
  }
  return std::nullopt;
}

/// Units of a model and their names in a case file; empty: those of the manual.
struct ModelUnits {
  double length = 1;  ///< [m]
  const char* weight = "";
  const char* stress = "";
};

std::string write_quantity(double value, const char* unit) {
  return *unit == '\0' ? fmt::format("{}", value) : fmt::format("\"{} {}\"", value, unit);
}

std::string get_text(const pugi::xml_node& node, const char* name) {
  const pugi::xml_node child = node.child(name);
  return child.attribute("Missing").as_bool() ? "" : child.child_value();
}

std::optional<double> get_number(const pugi::xml_node& node, const char* name) {
  const std::string text = get_text(node, name);
  if (text.empty()) return std::nullopt;
  const double value = read_number(text);
  if (!std::isfinite(value))
    fail_input("the GeoStudio model has '{}' for {}, which is not a number", text.substr(0, 40), name);
  return value;
}

class Translator {
 public:
  Translator(const pugi::xml_node& root, const std::string& source) : root_(root), source_(source) {
    if (std::string(root.child("Coordinates").child("EngCoords").attribute("UnitSystem").value()) == "Imperial")
      units_ = {0.3048, "lbf/ft3", "lbf/ft2"};
  }

  ImportedCase translate(const std::string& wanted) {
    select_analysis(wanted);
    text_ = fmt::format("# SLOPE/W analysis \"{}\" of {}\ntitle = \"{}\"\n\n", clean_text(get_text(analysis_, "Name")),
                        clean_text(source_), clean_text(get_text(analysis_, "Name")));
    read_points();
    write_regions();
    write_materials();
    entry_ = find_of_analysis(root_.child("StabilityItems"), "StabilityItem").child("Entry");
    write_water();
    write_earthquake();
    write_search();
    remark_rest();
    return {text_, remarks_};
  }

 private:
  void select_analysis(const std::string& wanted) {
    std::string others;
    for (const pugi::xml_node& analysis : root_.child("Analyses").children("Analysis")) {
      if (get_text(analysis, "Kind") != "SLOPE/W") continue;
      const std::string name = get_text(analysis, "Name");
      if (!analysis_ && (wanted.empty() || name == wanted))
        analysis_ = analysis;
      else
        others += fmt::format("{}'{}'", others.empty() ? "" : ", ", clean_text(name));
    }
    if (!analysis_)
      fail_input("{} has no SLOPE/W analysis{}{}", source_, wanted.empty() ? "" : " '" + clean_text(wanted) + "'",
                 others.empty() ? "" : "; it has " + others);
    if (wanted.empty() && !others.empty())
      remarks_.push_back(fmt::format("analysis '{}' was read; others, for --analysis: {}",
                                     clean_text(get_text(analysis_, "Name")), others));
  }

  /// Returns the item of a list that belongs to the analysis.
  pugi::xml_node find_of_analysis(const pugi::xml_node& list, const char* name) const {
    const std::string id = get_text(analysis_, "ID");
    for (const pugi::xml_node& item : list.children(name))
      if (get_text(item, "AnalysisID") == id) return item;
    return {};
  }

  std::optional<mesh::Point2> find_point(const pugi::xml_node& at) const {
    const pugi::xml_attribute x = at.attribute("X"), y = at.attribute("Y");
    if (!x || !y) return std::nullopt;
    const mesh::Point2 p{read_number(x.value()) * units_.length, read_number(y.value()) * units_.length};
    return std::isfinite(p[0]) && std::isfinite(p[1]) ? std::optional(p) : std::nullopt;
  }

  void read_points() {
    const pugi::xml_node geometries = root_.child("Geometries");
    const std::string id = get_text(analysis_, "GeometryId");
    const int number = std::max(1, std::atoi(id.c_str()));
    int i = 0;
    for (const pugi::xml_node& geometry : geometries.children("Geometry"))
      if (++i == number || get_text(geometry, "ID") == id) geometry_ = geometry;
    if (!geometry_) geometry_ = geometries.child("Geometry");
    for (const pugi::xml_node& point : geometry_.child("Points").children("Point"))
      if (const auto p = find_point(point)) points_[point.attribute("ID").value()] = *p;
  }

  /// Returns the corners of a region: "1,9,10,6".
  mesh::Polyline read_ring(const std::string& list) const {
    mesh::Polyline ring;
    for (std::size_t from = 0; from < list.size();) {
      const std::size_t end = std::min(list.find(',', from), list.size());
      const auto point = points_.find(list.substr(from, end - from));
      if (point != points_.end() && (ring.empty() || ring.back() != point->second)) ring.push_back(point->second);
      from = end + 1;
    }
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
  }

  void write_regions() {
    const pugi::xml_node context = find_of_analysis(root_.child("Contexts"), "Context");
    std::map<std::string, std::string> material_of;
    for (const pugi::xml_node& use : context.child("GeometryUsesMaterials").children("GeometryUsesMaterial"))
      material_of[use.attribute("ID").value()] = use.attribute("Entry").value();
    std::string regions = "[regions]\n";
    for (const pugi::xml_node& region : geometry_.child("Regions").children("Region")) {
      const std::string id = get_text(region, "ID");
      const auto material = material_of.find("Regions-" + id);
      const mesh::Polyline ring = read_ring(get_text(region, "PointIDs"));
      if (material == material_of.end() || ring.size() < 3) {
        remarks_.push_back(
            fmt::format("region {} {}, and was left out", clean_text(id),
                        ring.size() < 3 ? "has fewer than three points" : "has no material in this analysis"));
        continue;
      }
      const std::string name = take_name(regions_, "region " + id);
      text_ += fmt::format("[[geometry.polygon]]\nname = \"{}\"\npoints = {}\n\n", name, write_points(ring));
      regions += fmt::format("\"{}\" = \"{}\"\n", name, get_material(material->second));
    }
    if (regions_.empty())
      fail_input("the analysis '{}' of {} has no region with a material", clean_text(get_text(analysis_, "Name")),
                 source_);
    text_ += regions;
  }

  /// Returns the name of a material in the case, which is written by write_materials().
  const std::string& get_material(const std::string& id) {
    const auto found = materials_.find(id);
    if (found != materials_.end()) return found->second;
    std::string wanted = "material " + id;
    for (const pugi::xml_node& material : root_.child("Materials").children("Material"))
      if (get_text(material, "ID") == id && !get_text(material, "Name").empty()) wanted = get_text(material, "Name");
    return materials_[id] = take_name(names_, wanted);
  }

  void write_materials() {
    for (const pugi::xml_node& material : root_.child("Materials").children("Material")) {
      const auto used = materials_.find(get_text(material, "ID"));
      if (used == materials_.end()) continue;
      text_ += fmt::format("\n[materials.\"{}\"]\nmodel = \"mohr_coulomb\"\n", used->second);
      const pugi::xml_node values = material.child("StressStrain");
      const auto weight = get_number(values, "UnitWeight"), dry = get_number(values, "DryWeight");
      if (weight) text_ += fmt::format("unit_weight = {}\n", write_quantity(dry.value_or(*weight), units_.weight));
      if (weight && dry) text_ += fmt::format("saturated_unit_weight = {}\n", write_quantity(*weight, units_.weight));
      const std::string model = get_text(material, "SlopeModel");
      // GeoStudio leaves out values of zero.
      const bool undrained = model == "UndrainedPhiZero";
      if (!undrained && model != "MohrCoulomb") {
        text_ += fmt::format(
            "# The strength model {} is not translated.\n# cohesion =        # kPa\n# friction_angle =  # deg\n",
            clean_text(model));
        remarks_.push_back(fmt::format("material '{}' has the strength model {}, which is not translated: complete it",
                                       used->second, clean_text(model)));
        continue;
      }
      text_ += fmt::format(
          "cohesion = {}\nfriction_angle = {}\n",
          write_quantity(get_number(values, undrained ? "Cohesion" : "CohesionPrime").value_or(0), units_.stress),
          undrained ? 0 : get_number(values, "PhiPrime").value_or(0));
    }
  }

  void write_water() {
    const pugi::xml_node water = find_of_analysis(root_.child("WaterItems"), "WaterItem").child("Entry");
    const std::string option = get_text(water.child("ResultInputInfo"), "Option");
    const pugi::xml_node surfaces = entry_.child("PiezometricSurfaces");
    if (option.empty()) return;
    if (option != "PiezoSurface" && option != "PiezoLine") {
      remarks_.push_back(fmt::format(
          "pore pressures are those of another analysis (option {}), which is not translated", clean_text(option)));
      return;
    }
    std::map<std::string, mesh::Point2> local;
    for (const pugi::xml_node& point : entry_.child("DataPoints").children("DataPoint"))
      if (const auto p = find_point(point)) local[point.attribute("Number").value()] = *p;
    std::vector<std::pair<std::string, mesh::Polyline>> lines;  // ID and points
    for (const pugi::xml_node& surface : surfaces.children("PiezometricSurface")) {
      mesh::Polyline line;
      for (const pugi::xml_node& point : surface.child("DataPoints").children("DataPoint"))
        if (const auto at = local.find(point.child_value()); at != local.end()) line.push_back(at->second);
      if (line.size() > 1 && line.front()[0] > line.back()[0]) std::reverse(line.begin(), line.end());
      if (line.size() >= 2) lines.emplace_back(surface.child("ID").child_value(), std::move(line));
    }
    if (lines.empty()) return;
    // The first surface is the water table, also where water stands on the ground; the others act in their soils.
    text_ += fmt::format("\n[initial]\npore_pressure = \"water_table\"\nwater_table = {}\n",
                         write_points(lines.front().second));
    if (lines.size() > 1)
      remarks_.push_back(fmt::format(
          "of {} piezometric surfaces the first is the water table; water stands on the ground under it only",
          lines.size()));
    std::map<std::string, std::string> line_of;  // material → ID
    for (const pugi::xml_node& use : entry_.child("MaterialUsesPiezs").children("MaterialUsesPiez"))
      line_of[use.attribute("ID").value()] = use.attribute("UsesID").value();
    for (const auto& [id, name] : materials_) {
      const auto used = line_of.find(id);
      if (used == line_of.end()) {
        // Below all soil: its pore pressure is zero.
        write_line(name, {{lines.front().second.front()[0], find_lowest()}});
        remarks_.push_back(fmt::format(
            "material '{}' has no piezometric surface there; its line lies at the base of the section", name));
        continue;
      }
      for (std::size_t i = 1; i < lines.size(); ++i)
        if (lines[i].first == used->second) write_line(name, lines[i].second);
    }
  }

  double find_lowest() const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const auto& [id, p] : points_) lowest = std::min(lowest, p[1]);
    return lowest;
  }

  void write_line(const std::string& material, const mesh::Polyline& line) {
    text_ += fmt::format("\n[[initial.piezometric_line]]\nmaterials = [\"{}\"]\npoints = {}\n", material,
                         write_points(line));
  }

  /// Returns an acceleration of the earthquake; zero if it is left out.
  double read_acceleration(const char* name) const {
    const std::string text = entry_.child("Seismic").attribute(name).value();
    const double value = text.empty() ? 0 : read_number(text);
    if (!std::isfinite(value))
      fail_input("the GeoStudio model has '{}' for the {} acceleration, which is not a number",
                 clean_text(text.substr(0, 40)), name);
    return value;
  }

  void write_earthquake() {
    const double horizontal = read_acceleration("Horizontal"), vertical = read_acceleration("Vertical");
    if (horizontal == 0 && vertical == 0) return;
    text_ += fmt::format("\n[earthquake]\nhorizontal = {}\nvertical = {}\n", horizontal, vertical);
  }

  void write_search() {
    static const std::map<std::string, const char*> methods{{"Morgenstern-Price", "morgenstern_price"},
                                                            {"Spencer", "spencer"},
                                                            {"Bishop", "bishop"},
                                                            {"Janbu", "janbu"},
                                                            {"Ordinary", "fellenius"}};
    const std::string method = get_text(analysis_, "Method");
    text_ += "\n[analysis]\nmethods = [\"lem\"]\n\n[lem]\n";
    if (const auto known = methods.find(method); known != methods.end())
      text_ += fmt::format("methods = [\"{}\"]\n", known->second);
    else
      remarks_.push_back(
          fmt::format("the method '{}' is not translated: the usual ones were taken", clean_text(method)));
    const pugi::xml_node ranges = entry_.child("SlipSurface").child("EntryExit");
    const auto find_range = [&](const char* from, const char* to) {
      std::optional<mesh::Point2> a = find_point(ranges.child(from)), b = find_point(ranges.child(to));
      if (!a) a = b;
      if (!b) b = a;
      return a ? std::optional(std::array{std::min((*a)[0], (*b)[0]), std::max((*a)[0], (*b)[0])}) : std::nullopt;
    };
    const auto left = find_range("LeftSideLeftPt", "LeftSideRightPt"),
               right = find_range("RightSideLeftPt", "RightSideRightPt");
    if (!left || !right)
      return remarks_.push_back("the slip surfaces are not given by entry and exit: the whole ground is searched");
    const bool slides_left = get_text(entry_.child("SlipSurface"), "DirectionOfSlip") == "RightToLeft";
    const auto& exit = slides_left ? *left : *right;
    const auto& entry = slides_left ? *right : *left;
    const auto write = [&](const char* name, const std::array<double, 2>& range) {
      constexpr double about = 0.5;  // [m]
      const bool is_point = range[0] == range[1];
      if (is_point)
        remarks_.push_back(
            fmt::format("the {} is one point, x = {:.6g} m; it is searched from {} m before to {} m behind it", name,
                        range[0], about, about));
      const double widen = is_point ? about : 0;
      return fmt::format("{} = [{:.6g}, {:.6g}]\n", name, range[0] - widen, range[1] + widen);
    };
    text_ += "noncircular = false\n\n[lem.entry_exit]\n" + write("exit", exit) + write("entry", entry);
  }

  void remark_rest() {
    for (const auto& [name, what] : {std::pair{"Surcharges", "surcharges"},
                                     {"LineLoadPoints", "line loads"},
                                     {"ReinforcementLines", "reinforcements"}})
      if (entry_.child(name).first_child()) remarks_.push_back(fmt::format("{} are not translated", what));
    if (!get_text(entry_.child("TensionCrack"), "TensionOption").empty())
      remarks_.push_back("the tension crack is not translated");
  }

  const pugi::xml_node root_;
  const std::string& source_;
  ModelUnits units_;
  pugi::xml_node analysis_, geometry_, entry_;
  std::map<std::string, mesh::Point2> points_;
  std::map<std::string, std::string> materials_;  ///< identifier → name
  std::set<std::string> regions_, names_;
  std::string text_;
  std::vector<std::string> remarks_;
};

}  // namespace

std::string read_model(const std::string& path) {
  std::string bytes;
  if (const auto fault = try_user_file(path, largest_archive, bytes))
    fail_input("'{}' cannot be read: {}", path, fault->why);
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  const std::unique_ptr<zip_t, CloseArchive> archive(
      source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error));
  if (!archive) {
    if (source != nullptr) zip_source_free(source);
    fail_input("'{}' is not a GeoStudio file: it is no zip archive", path);
  }
  const auto stat = find_model(archive.get());
  if (!stat) fail_input("'{}' is not a GeoStudio file: there is no XML file at the root of the archive", path);
  const double expansion =
      static_cast<double>(stat->size) / static_cast<double>(std::max<zip_uint64_t>(stat->comp_size, 1));
  if (stat->size > largest_model || expansion > most_expansion)
    fail_input(
        "the model of '{}' has {} bytes, {:.0f} times those in the archive; at most {} and {:.0f} times are read", path,
        stat->size, expansion, largest_model, most_expansion);
  const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen_index(archive.get(), stat->index, 0));
  std::string xml(stat->size, '\0');
  if (!file || zip_fread(file.get(), xml.data(), stat->size) != static_cast<zip_int64_t>(stat->size))
    fail_input("the model of '{}' cannot be read: the archive is damaged", path);
  return xml;
}

ImportedCase translate_model(const std::string& xml, const std::string& analysis, const std::string& source) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
  if (!parsed) fail_input("the model of {} is damaged: {}", source, parsed.description());
  const pugi::xml_node root = document.child("GSIData");
  if (!root) fail_input("the model of {} is not one of GeoStudio", source);
  return Translator(root, source).translate(analysis);
}

}  // namespace talus::drawing
