#include "report/content/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "mesh/quality.hpp"
#include "report/content/boundary_lines.hpp"
#include "report/content/materials.hpp"
#include "report/content/soil_water.hpp"
#include "report/content/water.hpp"
#include "report/content/water_choices.hpp"
#include "report/look_up.hpp"
#include "report/words/answer.hpp"
#include "run/mpm/record/checkpoint.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// A mesh with more elements would be the largest part of the report, and too fine to be seen.
constexpr int most_drawn_elements = 100000;

/// (0.6, -0.8)
std::string show_vector(const std::vector<double>& v, std::size_t dimension) {
  std::string text;
  for (std::size_t d = 0; d < std::min(dimension, v.size()); ++d) text += (d ? ", " : "") + show_number(v[d], 4);
  return "(" + text + ")";
}

/// ", times a factor: 0 at 0 s, 1 at 2 s"; nothing without a table.
std::string describe_factor(const json& node) {
  constexpr std::size_t most_rows = 6;
  const json* rows = find(node, {"factor", "value"});
  if (rows == nullptr || !rows->is_array() || rows->empty()) return "";
  if (rows->size() > most_rows) return ", times a factor that changes with time (see the input)";
  std::string text;
  for (const json& row : *rows)
    text += fmt::format("{} {} at {} s", text.empty() ? ", times a factor:" : ",", show_number(row.at(1), 4),
                        show_number(row.at(0), 4));
  return text;
}

const json& get_table(const json& summary, const char* name) {
  static const json empty = json::object();
  const json* found = find(summary, {"input", name});
  return found != nullptr ? *found : empty;
}

std::string describe_boundary(const json& b, std::size_t dimension) {
  const std::string fix = get_word(b, "fix");
  if (fix == "full") return "fixed: no motion";
  if (fix == "normal") return "rollers: no motion across the side";
  if (fix == "plane") return "no motion along the normal " + show_vector(get_si_vector(b, "normal"), dimension);
  if (fix == "friction")
    return fmt::format("rough wall with μ = {:g}: the soil may leave it but not cross it", get_si(b, "friction", 0));
  if (fix == "velocity")
    return fmt::format("prescribed velocity {} m/s{}", show_vector(get_si_vector(b, "velocity"), dimension),
                       describe_factor(b));
  return fix;
}

json list_boundaries(const json& summary, std::size_t dimension, const std::optional<mesh::Mesh<2>>& mesh) {
  json list = json::array();
  for (const json& b : find_list(summary, {"input", "boundary"})) {
    json lines = json::array();
    if (dimension == 2) lines = find_boundary_lines(get_word(b, "on"), get_table(summary, "geometry"), mesh);
    list.push_back({{"on", get_word(b, "on")},
                    {"fix", get_word(b, "fix")},
                    {"text", describe_boundary(b, dimension)},
                    {"lines", lines}});
  }
  return list;
}

/// Surcharges and the earthquake, which slices and finite elements know.
void add_loads_of_slices(const json& summary, const ShownUnits& units, json& list) {
  for (const json& s : find_list(summary, {"input", "surcharge"})) {
    const std::vector<double> x = get_si_vector(s, "x"), load = get_si_vector(s, "load");
    std::string text;
    for (std::size_t i = 0; i < std::min(x.size(), load.size()); ++i)
      text += fmt::format("{}{} at x = {}", i ? ", " : "", show(load[i], units.stress), show(x[i], units.length));
    list.push_back({{"name", "surcharge " + get_word(s, "name")},
                    {"text", text + (get_flag(s, "variable") ? " (variable)" : " (permanent)")}});
  }
  const json& earthquake = get_table(summary, "earthquake");
  const double across = get_si(earthquake, "horizontal", 0), down = get_si(earthquake, "vertical", 0);
  if (across != 0 || down != 0)
    list.push_back(
        {{"name", "earthquake"},
         {"text", fmt::format("pseudo-static: k_h = {:g} out of the slope, k_v = {:g} down", across, down)}});
}

/// For the pictures of slices: x [m] and loads [Pa].
json list_surcharges(const json& summary) {
  json list = json::array();
  for (const json& s : find_list(summary, {"input", "surcharge"}))
    list.push_back({{"name", get_word(s, "name")}, {"x", get_si_vector(s, "x")}, {"load", get_si_vector(s, "load")}});
  return list;
}

json list_loads(const json& summary, std::size_t dimension, const ShownUnits& units) {
  json list = json::array();
  const json& gravity = get_table(summary, "gravity");
  if (!gravity.empty())
    list.push_back({{"name", "gravity"},
                    {"text", fmt::format("{:g} m/s² along {}", get_si(gravity, "acceleration", 9.81),
                                         show_vector(get_si_vector(gravity, "direction"), dimension))}});
  for (const json& t : find_list(summary, {"input", "traction"})) {
    std::vector<double> traction = get_si_vector(t, "traction");
    for (double& v : traction) v /= units.stress.si;
    const bool moves = get_word(t, "carrier", "points") == "points";
    list.push_back(
        {{"name", "traction on " + get_word(t, "on")},
         {"text", fmt::format("{} {}, {}{}", show_vector(traction, dimension), units.stress.name,
                              moves ? "carried by the soil beside the side" : "fixed in space", describe_factor(t))}});
  }
  add_loads_of_slices(summary, units, list);
  return list;
}

/// Monitors and the numbers of the points they follow: the nearest at the start, as the recorder chooses.
json list_monitors(const ResultFolder& folder, std::size_t dimension) {
  json list = json::array();
  const json& monitors = find_list(folder.summary, {"input", "output", "monitor"});
  if (monitors.empty() || !folder.frames || folder.frames->size() == 0) return list;
  const output::Frame frame = folder.frames->read(0);
  const output::Field* displacement = output::find(frame.point_fields, "displacement");
  for (const json& m : monitors) {
    const std::vector<double> at = get_si_vector(m, "at");
    if (at.size() < dimension) continue;
    int nearest = -1;
    double shortest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < frame.ids.size(); ++i) {
      double square = 0;
      for (std::size_t d = 0; d < dimension; ++d) {
        const double moved = displacement != nullptr ? displacement->values[3 * i + d] : 0;
        const double distance = frame.positions[3 * i + d] - moved - at[d];
        square += distance * distance;
      }
      if (square >= shortest) continue;
      shortest = square;
      nearest = frame.ids[i];
    }
    list.push_back({{"name", get_word(m, "name")}, {"at", at}, {"id", nearest}});
  }
  return list;
}

std::string describe_stage(const json& s, const ShownUnits& units, const std::string& water) {
  const bool rests = get_word(s, "until") == "rest";
  std::string text = rests ? fmt::format("until rest, at most {:g} s", get_si(s, "duration", 0))
                           : fmt::format("{:g} s", get_si(s, "duration", 0));
  text += fmt::format(", damping {:g}", get_si(s, "damping", 0));
  if (const auto cohesion = find_si(s, "cohesion")) text += ", cohesion " + show(*cohesion, units.stress);
  if (const auto factor = find_si(s, "strength_factor")) text += fmt::format(", strength divided by {:g}", *factor);
  if (const double ramp = get_si(s, "gravity_ramp", 0); ramp > 0)
    text += fmt::format(", gravity grows over {:g} s", ramp);
  if (const double scaling = get_si(s, "mass_scaling", 1); scaling != 1)
    text += fmt::format(", inertia times {:g}", scaling);
  if (get_word(s, "geometry") == "frozen") text += ", frozen geometry";
  if (const std::string smoothing = get_word(s, "smoothing", "none"); smoothing != "none")
    text += fmt::format(", {} smoothing", smoothing);
  if (get_word(s, "integration", "mixed") == "points") text += ", stresses integrated on the points";
  text += water;
  if (get_flag(s, "reset_displacement")) text += ", displacements counted from here";
  return text;
}

json list_stages(const ResultFolder& folder, const ShownUnits& units) {
  const json& summary = folder.summary;
  json list = json::array();
  const json& plans = find_list(summary, {"input", "stage"});
  const json& reports = find_list(summary, {"stages"});
  const bool wet = is_wet(folder);
  for (std::size_t i = 0; i < std::max(plans.size(), reports.size()); ++i) {
    static const json none = json::object();
    const json& plan = i < plans.size() ? plans[i] : none;
    const json& report = i < reports.size() ? reports[i] : none;
    // A stage is reported when it ends: the first without a report is where a broken run stopped.
    const std::string status = results::to_word(folder.run.status);
    const bool stopped_here = i == reports.size() && status != "finished" && status != "unfinished";
    list.push_back(
        {{"name", get_text(report, {"name"}, get_word(plan, "name"))},
         {"text",
          plan.empty() ? "" : describe_stage(plan, units, wet ? describe_stage_water(folder.data.stages[i].step) : "")},
         {"end", get_text(report, {"end"}, stopped_here ? status : "not reached")},
         {"time", get_number(report, {"time"})},
         {"steps", get_number(report, {"steps"})},
         {"wall", get_number(report, {"wall"})}});
  }
  return list;
}

template <int D>
void add_mesh(const mesh::Mesh<D>& mesh, json& block, Packer& packer) {
  // A run that was killed has no summary.
  if (block["elements"] == 0) {
    const mesh::Quality<D> quality = mesh::measure_quality(mesh);
    block["nodes"] = mesh.nodes.size();
    block["elements"] = mesh.elements.size();
    block["mean_size"] = quality.mean_size;
    block["smallest_altitude"] = quality.min_altitude;
  }
  if (mesh.element_count() > most_drawn_elements) return;
  std::vector<double> positions;
  for (const auto& x : mesh.nodes) positions.insert(positions.end(), x.begin(), x.end());
  std::vector<std::uint32_t> cells;
  for (const auto& e : mesh.elements)
    for (const int node : e) cells.push_back(static_cast<std::uint32_t>(node));
  block["positions"] = packer.add_reals("mesh.positions", positions, {mesh.nodes.size(), D});
  block["cells"] = packer.add_numbers("mesh.cells", cells, {mesh.elements.size(), D + 1}, true);
}

/// Corners of a list of points.
class Bounds {
 public:
  void add(const double* x, std::size_t dimension) {
    min_.resize(dimension, std::numeric_limits<double>::max());
    max_.resize(dimension, std::numeric_limits<double>::lowest());
    for (std::size_t d = 0; d < dimension; ++d) {
      min_[d] = std::min(min_[d], x[d]);
      max_[d] = std::max(max_[d], x[d]);
    }
  }
  bool empty() const { return min_.empty(); }
  json to_json() const { return {min_, max_}; }

 private:
  std::vector<double> min_, max_;
};

/// From the box of the case, else (a ready mesh) from the mesh, else from the points of the first frame, else (without
/// material points) from the polygons.
template <class Mesh2, class Mesh3>
json find_bounds(const ResultFolder& folder, std::size_t dimension, const Mesh2& plane, const Mesh3& space) {
  const json& geometry = get_table(folder.summary, "geometry");
  const auto box = get_si_points(geometry, "box");
  Bounds bounds;
  if (box.size() == 2 && box[0].size() >= 2 && box[1].size() >= 2) {
    for (const std::size_t end : {0u, 1u}) {
      const double corner[] = {box[end][0], box[end][1], end == 1 ? get_si(geometry, "thickness", 0) : 0};
      bounds.add(corner, dimension);
    }
  } else if (plane) {
    for (const auto& x : plane->nodes) bounds.add(x.data(), dimension);
  } else if (space) {
    for (const auto& x : space->nodes) bounds.add(x.data(), dimension);
  } else if (folder.frames && folder.frames->size() > 0) {
    const output::Frame frame = folder.frames->read(0);
    for (std::size_t i = 0; i < frame.ids.size(); ++i) bounds.add(&frame.positions[3 * i], dimension);
  }
  if (bounds.empty())
    for (const json& polygon : find_list(folder.summary, {"input", "geometry", "polygon"}))
      for (const auto& corner : get_si_points(polygon, "points"))
        if (corner.size() >= dimension) bounds.add(corner.data(), dimension);
  if (bounds.empty()) bounds.add(std::array<double, 3>{}.data(), dimension);
  return bounds.to_json();
}

}  // namespace

json make_model(const ResultFolder& folder, std::optional<double> factor_of_safety, Packer& packer) {
  const json& summary = folder.summary;
  const std::size_t dimension = get_dimension(summary);
  const ShownUnits units = read_units(summary);
  json mesh{{"nodes", get_number(summary, {"mesh", "nodes"})},
            {"elements", get_number(summary, {"mesh", "elements"})},
            {"points", get_number(summary, {"mesh", "points"})},
            {"mean_size", get_number(summary, {"mesh", "mean_size"})},
            {"smallest_altitude", get_number(summary, {"mesh", "smallest_altitude"})},
            {"critical_time_step", get_number(summary, {"mesh", "critical_time_step"})}};
  std::optional<mesh::Mesh<2>> plane;
  std::optional<mesh::Mesh<3>> space;
  if (std::filesystem::exists(folder.path / "mesh.h5")) {
    const output::ArchiveReader archive(folder.path / "mesh.h5");
    if (dimension == 2) {
      plane = run::get_mesh<2>(archive);
      add_mesh<2>(*plane, mesh, packer);
    } else {
      space = run::get_mesh<3>(archive);
      add_mesh<3>(*space, mesh, packer);
    }
  }
  json polygons = json::array();
  for (const json& p : find_list(summary, {"input", "geometry", "polygon"})) {
    const std::string name = get_word(p, "name");
    polygons.push_back({{"name", name},
                        {"material", get_word(get_table(summary, "regions"), name.c_str())},
                        {"points", get_si_points(p, "points")}});
  }
  return {{"dimension", dimension},
          {"bounds", find_bounds(folder, dimension, plane, space)},
          {"slope_height", get_number(summary, {"slope_height"})},
          {"polygons", polygons},
          {"boundaries", list_boundaries(summary, dimension, plane)},
          {"loads", list_loads(summary, dimension, units)},
          {"surcharges", list_surcharges(summary)},
          {"water", list_water_tables(folder)},
          {"monitors", list_monitors(folder, dimension)},
          {"materials", list_materials(folder, factor_of_safety)},
          {"stages", list_stages(folder, units)},
          {"mesh", mesh}};
}

}  // namespace talus::report
