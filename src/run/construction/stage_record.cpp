// SPDX-License-Identifier: MIT
#include "run/construction/stage_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/error.hpp"
#include "mesh/locate.hpp"
#include "output/files/vtu.hpp"

namespace talus::run {
namespace {

constexpr std::size_t element_points = input::KnownStress::points;
constexpr int line_places = 60;  ///< intervals of a section line
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Effective mean stress, compression positive, and q.
std::array<double, 2> find_invariants(const std::array<double, 6>& s) {
  const double p = -(s[0] + s[1] + s[2]) / 3;
  double q = 0;
  for (std::size_t i = 0; i < 3; ++i) q += (s[i] + p) * (s[i] + p) + 2 * s[i + 3] * s[i + 3];
  return {p, std::sqrt(1.5 * q)};
}

/// Returns the constant pressures at the corners of an element without flow [Pa], compression positive.
std::array<double, 3> find_given_pressures(const StageModel& stage, std::size_t element) {
  const auto& pore = stage.solid.model.pore_stress;
  if (pore.empty()) return {};
  return {-pore[element][0], -pore[element][1], -pore[element][2]};
}

/// Makes a measured curve with its difference from the computed one, whose values have the given sign.
std::optional<results::MeasuredCurve> compare(const input::TimeTable& measured, const std::vector<double>& time,
                                              const std::vector<double>& computed, double sign) {
  if (measured.time.empty()) return std::nullopt;
  results::MeasuredCurve curve{measured.time, measured.value, {}};
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < measured.time.size(); ++i) {
    const double value = sign * read_in_time(time, computed, measured.time[i]);
    if (!std::isfinite(value)) continue;
    sum += (value - measured.value[i]) * (value - measured.value[i]);
    ++count;
  }
  if (count > 0) curve.rms = std::sqrt(sum / count);
  return curve;
}

}  // namespace

double read_in_time(const std::vector<double>& time, const std::vector<double>& value, double t) {
  if (time.empty() || t < time.front() || t > time.back()) return none;
  const auto after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  if (after == time.size() || time[after - 1] == t) return value[after - 1];
  const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
  return value[after - 1] + share * (value[after] - value[after - 1]);
}

/// Reads the state of one stage at places.
class StageRecord::Reader {
 public:
  Reader(const StageRecord& record, const StageModel& stage, const fem::SolidState<2>& solid,
         const std::vector<double>& head)
      : record_(record),
        stage_(stage),
        solid_(solid),
        head_(head),
        mesh_(fem::make_quadratic<2>(*stage.solid.mesh, fem::list_cuts(stage.solid.model))),
        elements_(record.mesh_->elements.size(), -1) {
    for (std::size_t k = 0; k < mesh_.linear_element.size(); ++k)
      elements_[static_cast<std::size_t>(mesh_.linear_element[k])] = static_cast<int>(k);
  }

  const fem::QuadraticMesh<2>& mesh() const { return mesh_; }
  /// Returns true if an element of the whole mesh has pore pressures.
  bool holds_water(std::size_t element) const {
    return stage_.is_wet && stage_.wet_mesh.element_region[element] != mesh::empty_region;
  }

  Values read(const Place& place) const {
    const auto inside = std::find_if(place.begin(), place.end(), [&](const Inside& i) {
      return elements_[static_cast<std::size_t>(i.element)] >= 0;
    });
    Values values{{none, none}, none, none, {}};
    values.stress.fill(none);
    if (inside == place.end()) return values;
    const auto k = static_cast<std::size_t>(elements_[static_cast<std::size_t>(inside->element)]);
    const auto& l = inside->share;
    const auto& nodes = mesh_.elements[k];
    values = {};
    // Quadratic: corners l (2 l − 1), middles of the edges 0-1, 1-2, 2-0.
    const std::array<double, 6> shape{l[0] * (2 * l[0] - 1), l[1] * (2 * l[1] - 1), l[2] * (2 * l[2] - 1),
                                      4 * l[0] * l[1],       4 * l[1] * l[2],       4 * l[2] * l[0]};
    for (std::size_t i = 0; i < shape.size(); ++i)
      for (std::size_t d = 0; d < 2; ++d)
        values.displacement[d] += shape[i] * solid_.displacement[static_cast<std::size_t>(nodes[i])][d];
    const auto whole = static_cast<std::size_t>(inside->element);
    if (holds_water(whole)) {
      const auto& corners = stage_.water_mesh->elements[whole];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(corners[i]);
        const auto [pressure, excess] = record_.find_pressures(stage_, head_, n);
        values.pressure += l[i] * pressure;
        values.excess += l[i] * excess;
      }
    } else {
      const std::array<double, 3> given = find_given_pressures(stage_, whole);
      for (std::size_t i = 0; i < 3; ++i) values.pressure += l[i] * given[i];
    }
    const auto nearest = static_cast<std::size_t>(std::max_element(l.begin(), l.end()) - l.begin());
    values.stress = solid_.stress[k * element_points + nearest];
    return values;
  }

 private:
  const StageRecord& record_;
  const StageModel& stage_;
  const fem::SolidState<2>& solid_;
  const std::vector<double>& head_;
  const fem::QuadraticMesh<2> mesh_;
  std::vector<int> elements_;  ///< of the quadratic mesh, by those of the linear one; -1: no soil
};

StageRecord::StageRecord(const input::Case& data, std::shared_ptr<const mesh::Mesh<2>> whole)
    : data_(data), mesh_(std::move(whole)) {
  file_.nodes.assign(mesh_->nodes.begin(), mesh_->nodes.end());
  file_.elements.assign(mesh_->elements.begin(), mesh_->elements.end());
  for (const input::Monitor& monitor : data.output.monitors) {
    places_.push_back(find_place({monitor.at[0], monitor.at[1]}));
    if (places_.back().empty())
      throw Error(ExitCode::wrong_input, fmt::format("monitor '{}' at ({:g}, {:g}) lies outside the section",
                                                     monitor.name, monitor.at[0], monitor.at[1]));
    monitors_.emplace_back();
    monitors_.back().name = monitor.name;
    monitors_.back().at = {monitor.at[0], monitor.at[1]};
  }
  for (const input::SectionLine& section : data.output.sections) {
    results::ConstructionLine& line = lines_.emplace_back();
    line.name = section.name;
    line.from = {section.from[0], section.from[1]};
    line.to = {section.to[0], section.to[1]};
    const double length = std::hypot(line.to[0] - line.from[0], line.to[1] - line.from[1]);
    std::vector<Place>& places = line_places_.emplace_back();
    for (int i = 0; i <= line_places; ++i) {
      const double t = static_cast<double>(i) / line_places;
      line.distance.push_back(t * length);
      places.push_back(
          find_place({line.from[0] + t * (line.to[0] - line.from[0]), line.from[1] + t * (line.to[1] - line.from[1])}));
    }
  }
}

StageRecord::Place StageRecord::find_place(const Vec<2>& x) const {
  Place place;
  for (std::size_t e = 0; e < mesh_->elements.size(); ++e) {
    if (mesh_->element_region[e] == mesh::empty_region) continue;
    const auto xi = mesh::to_local(*mesh_, static_cast<int>(e), x);
    const std::array<double, 3> share{1 - xi[0] - xi[1], xi[0], xi[1]};
    constexpr double tolerance = 1e-9;
    if (*std::min_element(share.begin(), share.end()) > -tolerance) place.push_back({static_cast<int>(e), share});
  }
  return place;
}

/// Returns the pore pressure of a node with water and its excess [Pa].
std::pair<double, double> StageRecord::find_pressures(const StageModel& stage, const std::vector<double>& head,
                                                      std::size_t node) const {
  const double weight = stage.flow.unit_weight, level = stage.elevation[node];
  const double pressure = weight * (head[node] - level);
  return {pressure, fem::find_excess(pressure, weight * (steady_head_[node] - level))};
}

void StageRecord::add_step(double time, const StageModel& stage, const fem::SolidState<2>& solid,
                           const std::vector<double>& head) {
  if (places_.empty()) return;
  times_.push_back(time);
  const Reader reader(*this, stage, solid, head);
  for (std::size_t m = 0; m < places_.size(); ++m) {
    results::ConstructionMonitor& monitor = monitors_[m];
    const Values values = reader.read(places_[m]);
    monitor.displacement_x.push_back(values.displacement[0]);
    monitor.displacement_y.push_back(values.displacement[1]);
    monitor.pressure.push_back(values.pressure);
    const auto [p, q] = find_invariants(values.stress);
    monitor.mean.push_back(p);
    monitor.deviator.push_back(q);
  }
}

void StageRecord::add_stage(const std::string& name, const StageModel& stage, const fem::ConsolidationState<2>& state) {
  const Reader reader(*this, stage, state.solid, state.head);
  results::ConstructionFields& fields = file_.stages.emplace_back();
  fields.stage = name;
  const fem::QuadraticMesh<2>& mesh = reader.mesh();
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    fields.elements.push_back(mesh.linear_element[k]);
    int yields = 0;
    for (std::size_t q = 0; q < element_points; ++q) yields += state.solid.yields[k * element_points + q] != 0;
    fields.yields.push_back(yields / static_cast<double>(element_points));
  }
  fields.pressure.assign(mesh_->nodes.size(), 0);
  fields.excess.assign(mesh_->nodes.size(), 0);
  for (std::size_t e = 0; e < mesh_->elements.size(); ++e)
    if (!reader.holds_water(e))
      for (std::size_t i = 0; i < 3; ++i)
        fields.pressure[static_cast<std::size_t>(mesh_->elements[e][i])] = find_given_pressures(stage, e)[i];
  for (std::size_t e = 0; e < mesh_->elements.size(); ++e)
    if (reader.holds_water(e))
      for (std::size_t i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(mesh_->elements[e][i]),
                   w = static_cast<std::size_t>(stage.water_mesh->elements[e][i]);
        std::tie(fields.pressure[n], fields.excess[n]) = find_pressures(stage, state.head, w);
      }
  for (std::size_t i = 0; i < mesh_->nodes.size(); ++i) {
    fields.displacement_x.push_back(state.solid.displacement[i][0]);
    fields.displacement_y.push_back(state.solid.displacement[i][1]);
  }
  for (std::size_t s = 0; s < lines_.size(); ++s) {
    results::ConstructionProfile& profile = lines_[s].profiles.emplace_back();
    profile.stage = name;
    for (const Place& place : line_places_[s]) {
      const Values values = reader.read(place);
      profile.displacement_x.push_back(values.displacement[0]);
      profile.displacement_y.push_back(values.displacement[1]);
      profile.pressure.push_back(values.pressure);
      profile.excess.push_back(values.excess);
    }
  }
}

std::vector<results::ConstructionMonitor> StageRecord::make_monitors() const {
  std::vector<results::ConstructionMonitor> monitors = monitors_;
  for (std::size_t m = 0; m < monitors.size(); ++m) {
    const input::Monitor& measured = data_.output.monitors[m];
    results::ConstructionMonitor& monitor = monitors[m];
    monitor.measured_settlement = compare(measured.settlement, times_, monitor.displacement_y, -1);
    monitor.measured_lateral = compare(measured.lateral, times_, monitor.displacement_x, 1);
    monitor.measured_pressure = compare(measured.pressure, times_, monitor.pressure, 1);
  }
  return monitors;
}

void StageRecord::keep(results::ConstructionRestart& restart) const {
  restart.steady_head = steady_head_;
  restart.times = times_;
  restart.monitors = monitors_;
  restart.lines = lines_;
  restart.fields = file_;
}

void StageRecord::restore(results::ConstructionRestart& restart) {
  steady_head_ = restart.steady_head;
  times_ = std::move(restart.times);
  monitors_ = std::move(restart.monitors);
  lines_ = std::move(restart.lines);
  file_ = std::move(restart.fields);
}

std::string write_stage_vtu(const results::ConstructionFile& file, std::size_t stage) {
  const results::ConstructionFields& fields = file.stages[stage];
  output::VtuMesh mesh;
  for (const auto& x : file.nodes) mesh.points.insert(mesh.points.end(), {x[0], x[1], 0});
  for (const int e : fields.elements) {
    const auto& nodes = file.elements[static_cast<std::size_t>(e)];
    mesh.nodes.insert(mesh.nodes.end(), nodes.begin(), nodes.end());
  }
  std::vector<double> displacement;
  for (std::size_t i = 0; i < file.nodes.size(); ++i)
    displacement.insert(displacement.end(), {fields.displacement_x[i], fields.displacement_y[i], 0});
  mesh.point_fields = {{"displacement", 3, std::move(displacement)},
                       {"pore_pressure", 1, fields.pressure},
                       {"excess_pressure", 1, fields.excess}};
  mesh.cell_fields = {{"yields", 1, fields.yields}};
  return output::write_vtu(mesh);
}

}  // namespace talus::run
