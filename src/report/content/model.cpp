// SPDX-License-Identifier: MIT
#include "report/content/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "input/case/boundary.hpp"
#include "input/echo.hpp"
#include "mesh/planar.hpp"
#include "mesh/quality.hpp"
#include "report/content/choices.hpp"
#include "report/content/materials.hpp"
#include "report/content/parts.hpp"
#include "report/content/water.hpp"
#include "report/folder/numbers.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "site/supports.hpp"

namespace talus::report {

namespace {

/// Relative tolerance: nodes nearer to the straight line between their neighbours, over its extent, are omitted.
constexpr double straight = 1e-9;

}  // namespace

std::vector<Polyline> join_sides(const mesh::Mesh<2>& mesh, const std::vector<mesh::Mesh<2>::Side>& sides) {
  std::map<int, std::vector<int>> beside;
  for (const auto& side : sides) {
    beside[side[0]].push_back(side[1]);
    beside[side[1]].push_back(side[0]);
  }
  std::set<std::pair<int, int>> used;
  std::vector<Polyline> lines;
  const auto walk = [&](int start) {
    Polyline line{mesh.nodes[static_cast<std::size_t>(start)]};
    for (int at = start;;) {
      const std::vector<int>& next = beside.at(at);
      const auto step = std::find_if(next.begin(), next.end(), [&](int n) {
        return !used.contains({std::min(at, n), std::max(at, n)});
      });
      if (step == next.end()) break;
      used.insert({std::min(at, *step), std::max(at, *step)});
      at = *step;
      line.push_back(mesh.nodes[static_cast<std::size_t>(at)]);
    }
    if (line.size() < 2) return;
    double length = 0;
    for (const auto& x : line) length = std::max(length, std::hypot(x[0] - line[0][0], x[1] - line[0][1]));
    lines.push_back(mesh::drop_straight_points(line, false, straight * length));
  };
  // Ends and branching nodes first, so that no polyline starts in its middle. The remaining polylines are closed.
  for (const auto& [node, others] : beside)
    if (others.size() != 2)
      for (std::size_t k = 0; k < others.size(); ++k) walk(node);
  for (const auto& [node, others] : beside) walk(node);
  return lines;
}

std::vector<Polyline> find_boundary_lines(const std::string& name, const mesh::Plan& plan,
                                          const std::optional<mesh::Mesh<2>>& mesh) {
  if (mesh) {
    const auto sides = mesh->sides.find(name);
    return sides == mesh->sides.end() ? std::vector<Polyline>{} : join_sides(*mesh, sides->second);
  }
  for (const mesh::Line& line : plan.lines)
    if (line.name == name) return {line.points};
  const auto [x0, y0] = plan.box_min;
  const auto [x1, y1] = plan.box_max;
  if (plan.box_min == plan.box_max) return {};  // the mesh is given as a file
  if (name == "left") return {{{x0, y0}, {x0, y1}}};
  if (name == "right") return {{{x1, y0}, {x1, y1}}};
  if (name == "bottom") return {{{x0, y0}, {x1, y0}}};
  if (name == "top") return {{{x0, y1}, {x1, y1}}};
  return {};
}

using nlohmann::json;

namespace {

/// Limit on the mesh in the report; a finer mesh would dominate the file size and could not be resolved on the page.
constexpr int most_drawn_elements = 100000;

/// Returns a text such as "(0.6, -0.8)"; the third component is omitted in 2D.
std::string show_vector(const std::array<double, 3>& v, std::size_t dimension, double unit = 1) {
  std::string text;
  for (std::size_t d = 0; d < (v[2] != 0 ? dimension : 2); ++d) text += (d ? ", " : "") + show_number(v[d] / unit, 4);
  return "(" + text + ")";
}

/// Returns a text such as ", times a factor: 0 at 0 s, 1 at 2 s"; empty without a table.
std::string describe_factor(const input::TimeTable& table) {
  constexpr std::size_t most_factors = 6;
  if (table.time.size() > most_factors) return ", times a factor that changes with time (see the input)";
  std::string text;
  for (std::size_t i = 0; i < table.time.size(); ++i)
    text += fmt::format("{} {} at {} s", text.empty() ? ", times a factor:" : ",", show_number(table.value[i], 4),
                        show_number(table.time[i], 4));
  return text;
}

std::string describe_boundary(const input::Boundary& b, std::size_t dimension, const ShownUnit& speed) {
  switch (b.fix) {
    case input::Fix::full:
      return "fixed: no motion";
    case input::Fix::normal:
      return "rollers: no motion across the side";
    case input::Fix::plane:
      return "no motion along the normal " + show_vector(b.normal, dimension);
    case input::Fix::friction:
      return fmt::format("rough wall with μ = {:g}: the soil may leave it but not cross it", b.friction);
    case input::Fix::velocity:
      return fmt::format("prescribed velocity {} {}{}{}", show_vector(b.velocity, dimension, speed.si), speed.name,
                         b.smooth ? " across it, free along it" : "", describe_factor(b.factor));
  }
  return "";
}

json list_boundaries(const input::Case& data, std::size_t dimension, const std::optional<mesh::Mesh<2>>& mesh,
                     const ShownUnit& speed) {
  json list = json::array();
  for (const input::Boundary& b : data.boundaries) {
    json lines = json::array();
    if (dimension == 2) lines = find_boundary_lines(b.on, data.mesh, mesh);
    list.push_back({{"on", b.on},
                    {"fix", input::get_word(b.fix)},
                    {"text", describe_boundary(b, dimension, speed)},
                    {"lines", lines}});
  }
  return list;
}

/// Adds the surcharges and the earthquake, which act in LEM and FEM.
void add_loads_of_slices(const input::Case& data, const ShownUnits& units, json& list) {
  for (const input::Surcharge& s : data.surcharges) {
    std::string text;
    for (std::size_t i = 0; i < std::min(s.x.size(), s.load.size()); ++i)
      text += fmt::format("{}{} at x = {}", i ? ", " : "", show(s.load[i], units.stress),
                          show_coordinate(s.x[i], units.length));
    list.push_back({{"name", "surcharge " + s.name}, {"text", text + (s.variable ? " (variable)" : " (permanent)")}});
  }
  const auto [across, down, direction] = data.earthquake;
  const char* towards = direction == input::EarthquakeDirection::left    ? "towards smaller x"
                        : direction == input::EarthquakeDirection::right ? "towards larger x"
                                                                         : "towards either side";
  if (across != 0 || down != 0)
    list.push_back({{"name", "earthquake"},
                    {"text", fmt::format("pseudo-static: k_h = {:g} {}, k_v = {:g} down", across, towards, down)}});
}

/// Describes the tension crack. It shortens each surface; water in it presses on its side.
json describe_crack(const input::TensionCrack& crack, const ShownUnits& units) {
  return {{"name", "tension crack"},
          {"text", fmt::format("slip surfaces of LEM end in a vertical crack, {} deep at most{}",
                               show(crack.depth, units.length),
                               crack.water > 0 ? ", in which water stands " + show(crack.water, units.length) +
                                                     " deep and presses on its side"
                                               : ", without water")}};
}

/// Returns the largest depth of the dry cracks that the search added [m]; 0 if there is none.
double find_added_crack(const results::RunResult& run) {
  double depth = 0;
  if (!run.slices) return depth;
  for (const auto* list : {&run.slices->critical, &run.slices->noncircular})
    for (const results::CriticalSurface& c : *list) depth = std::max(depth, c.crack.value_or(0));
  return depth;
}

/// Returns the surcharges in the section: x [m] and loads [Pa].
json list_surcharges(const input::Case& data) {
  json list = json::array();
  for (const input::Surcharge& s : data.surcharges) list.push_back({{"name", s.name}, {"x", s.x}, {"load", s.load}});
  return list;
}

/// Returns the bars of the supports; none where the section has no ground for them.
json list_bars(const input::Case& data) {
  json list = json::array();
  try {
    for (const site::Bar& bar : site::list_bars(site::Site(data)))
      list.push_back({{"support", bar.support},
                      {"row", bar.row},
                      {"head", bar.head},
                      {"end", bar.end},
                      {"bonded", std::min(bar.free_length, bar.length())}});
  } catch (const Error&) {
    return json::array();
  }
  return list;
}

json list_loads(const input::Case& data, std::size_t dimension, const ShownUnits& units) {
  json list = json::array();
  list.push_back({{"name", "gravity"},
                  {"text", fmt::format("{} along {}", show(data.gravity.acceleration, units.acceleration(), 4),
                                       show_vector(data.gravity.direction, dimension))}});
  for (const input::Traction& t : data.tractions)
    list.push_back(
        {{"name", "traction on " + t.on},
         {"text",
          fmt::format("{} {}, {}{}", show_vector(t.traction, dimension, units.stress.si), units.stress.name,
                      t.carrier == input::Carrier::points ? "carried by the soil beside the side" : "fixed in space",
                      describe_factor(t.factor))}});
  add_loads_of_slices(data, units, list);
  return list;
}

/// Returns the monitors and the numbers of the points that they follow: the nearest at the start, as in the recorder.
json list_monitors(const ResultFolder& folder, std::size_t dimension) {
  json list = json::array();
  if (folder.data.output.monitors.empty() || !folder.frames || folder.frames->size() == 0) return list;
  const output::Frame frame = folder.frames->read(0);
  const output::Field* displacement = output::find(frame.point_fields, "displacement");
  for (const input::Monitor& m : folder.data.output.monitors) {
    int nearest = -1;
    double shortest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < frame.ids.size(); ++i) {
      double square = 0;
      for (std::size_t d = 0; d < dimension; ++d) {
        const double moved = displacement != nullptr ? displacement->values[3 * i + d] : 0;
        const double distance = frame.positions[3 * i + d] - moved - m.at[d];
        square += distance * distance;
      }
      if (square >= shortest) continue;
      shortest = square;
      nearest = frame.ids[i];
    }
    list.push_back({{"name", m.name}, {"at", std::vector(m.at.begin(), m.at.begin() + dimension)}, {"id", nearest}});
  }
  return list;
}

/// `water` is the clause on pore water.
std::string describe_stage(const input::Stage& s, const ShownUnits& units, const std::string& water) {
  std::string text = s.until == input::Until::rest ? fmt::format("until rest, at most {:g} s", s.duration)
                                                   : fmt::format("{:g} s", s.duration);
  text += fmt::format(", damping {:g}", s.step.damping);
  if (s.cohesion) text += ", cohesion " + show(*s.cohesion, units.stress);
  if (s.strength_factor) text += fmt::format(", strength divided by {:g}", *s.strength_factor);
  if (s.gravity_ramp > 0) text += fmt::format(", gravity grows over {:g} s", s.gravity_ramp);
  if (s.step.mass_scaling != 1) text += fmt::format(", inertia times {:g}", s.step.mass_scaling);
  if (s.step.geometry == input::Geometry::frozen) text += ", frozen geometry";
  if (s.step.smoothing != input::Smoothing::none)
    text += fmt::format(", {} smoothing", s.step.smoothing == input::Smoothing::strain ? "strain" : "stable");
  if (s.step.integration == input::Integration::points) text += ", stresses integrated on the points";
  text += water;
  if (s.reset_displacement) text += ", displacements counted from here";
  return text;
}

json list_stages(const ResultFolder& folder, const ShownUnits& units) {
  json list = json::array();
  const std::vector<input::Stage>& plans = folder.data.stages;
  const std::vector<results::Stage> reports = folder.run.stages.value_or(std::vector<results::Stage>{});
  const results::Status status = folder.run.status;
  const bool stopped = status != results::Status::finished && status != results::Status::unfinished;
  const bool wet = is_wet(folder);
  for (std::size_t i = 0; i < std::max(plans.size(), reports.size()); ++i) {
    const bool planned = i < plans.size();
    // The report of a stage is written at its end, so an interrupted run stopped in the first stage without a report.
    const bool reported = i < reports.size(), stopped_here = i == reports.size() && stopped;
    const results::Stage report = reported ? reports[i] : results::Stage{};
    const std::string water = planned && wet ? describe_stage_water(plans[i].step) : std::string();
    list.push_back({{"name", reported ? report.name : plans[i].name},
                    {"text", planned ? describe_stage(plans[i], units, water) : ""},
                    {"end", reported       ? results::to_word(report.end)
                            : stopped_here ? results::to_word(status)
                                           : "not reached"},
                    {"time", report.time},
                    {"steps", report.steps},
                    {"wall", report.wall}});
  }
  return list;
}

json describe_mesh(const results::Mesh& mesh) {
  return {{"nodes", mesh.nodes},
          {"elements", mesh.elements},
          {"points", mesh.points},
          {"mean_size", mesh.mean_size},
          {"smallest_altitude", mesh.smallest_altitude},
          {"critical_time_step", mesh.critical_time_step}};
}

template <int D>
void add_mesh(const mesh::Mesh<D>& mesh, bool is_measured, json& block, Packer& packer) {
  // A killed run has no summary.
  if (!is_measured) {
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
  block["positions"] = packer.add_places("mesh.positions", positions, {mesh.nodes.size(), D});
  block["cells"] = packer.add_numbers("mesh.cells", cells, {mesh.elements.size(), D + 1}, true);
}

/// Bounding box of a list of points.
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

/// Returns the bounding box: that of the case, otherwise of the mesh (given as a file), of the points in the first
/// frame, or of the polygons (without MPM).
template <class Mesh2, class Mesh3>
json find_bounds(const ResultFolder& folder, std::size_t dimension, const Mesh2& plane, const Mesh3& space) {
  const mesh::Plan& plan = folder.data.mesh;
  Bounds bounds;
  if (plan.box_min != plan.box_max) {
    for (const auto& [corner, z] : {std::pair{plan.box_min, 0.0}, std::pair{plan.box_max, plan.thickness}})
      bounds.add(std::array{corner[0], corner[1], z}.data(), dimension);
  } else if (plane) {
    for (const auto& x : plane->nodes) bounds.add(x.data(), dimension);
  } else if (space) {
    for (const auto& x : space->nodes) bounds.add(x.data(), dimension);
  } else if (folder.frames && folder.frames->size() > 0) {
    const output::Frame frame = folder.frames->read(0);
    for (std::size_t i = 0; i < frame.ids.size(); ++i) bounds.add(&frame.positions[3 * i], dimension);
  }
  if (bounds.empty() && dimension == 2)
    for (const mesh::Polygon& polygon : plan.polygons)
      for (const auto& corner : polygon.points) bounds.add(corner.data(), dimension);
  if (bounds.empty()) bounds.add(std::array<double, 3>{}.data(), dimension);
  return bounds.to_json();
}

}  // namespace

json make_model(const ResultFolder& folder, std::optional<double> factor_of_safety, Packer& packer) {
  const std::size_t dimension = get_dimension(folder.run);
  const ShownUnits units = read_units(folder.run);
  const input::Case& data = folder.data;
  const results::Mesh result = folder.run.mesh.value_or(results::Mesh{});
  const bool is_measured = result.elements > 0;
  json mesh = describe_mesh(result);
  std::optional<mesh::Mesh<2>> plane;
  std::optional<mesh::Mesh<3>> space;
  if (std::filesystem::exists(folder.path / "mesh.h5")) {
    const output::ArchiveReader archive(folder.path / "mesh.h5");
    if (dimension == 2) {
      plane = run::get_mesh<2>(archive);
      add_mesh<2>(*plane, is_measured, mesh, packer);
    } else {
      space = run::get_mesh<3>(archive);
      add_mesh<3>(*space, is_measured, mesh, packer);
    }
  }
  // The case of a killed run is unknown, and element tests have no weight.
  const bool has_weight = !folder.run.input.is_empty() && !folder.has_tests_alone;
  json polygons = json::array();
  for (const mesh::Polygon& p : data.mesh.polygons) {
    const auto material = data.regions.find(p.name);
    polygons.push_back(
        {{"name", p.name}, {"material", material != data.regions.end() ? material->second : ""}, {"points", p.points}});
  }
  json loads = has_weight ? list_loads(data, dimension, units) : json::array();
  const bool has_crack = data.lem.crack.depth > 0 && asks_for(folder, Method::lem);
  const double added_crack = has_crack ? 0 : find_added_crack(folder.run);
  if (has_crack) loads.push_back(describe_crack(data.lem.crack, units));
  if (added_crack > 0)
    loads.push_back(
        {{"name", "tension crack"},
         {"text", fmt::format("the search added a dry crack, {} deep at most, to slip surfaces that have no "
                              "equilibrium without it",
                              show(added_crack, units.length))}});
  json model{{"dimension", dimension},
             {"bounds", find_bounds(folder, dimension, plane, space)},
             {"slope_height", folder.run.slope_height.value_or(0)},
             {"polygons", polygons},
             {"boundaries", list_boundaries(data, dimension, plane, units.speed())},
             {"loads", loads},
             {"surcharges", list_surcharges(data)},
             {"bars", list_bars(data)},
             {"water", list_water_states(folder)},
             {"monitors", list_monitors(folder, dimension)},
             {"materials", list_materials(folder, factor_of_safety)},
             {"stages", list_stages(folder, units)},
             {"mesh", mesh}};
  if (has_crack) model["crack"] = {{"depth", data.lem.crack.depth}, {"water", data.lem.crack.water}};
  if (added_crack > 0) model["crack"] = {{"depth", added_crack}, {"water", 0}};
  return model;
}

}  // namespace talus::report
