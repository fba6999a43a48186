// SPDX-License-Identifier: MIT
// Transient seepage over the season, and its record by layers under the ground.
#include "site/season.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "site/roots.hpp"
#include "site/seepage_results.hpp"

namespace talus::site {
namespace {

constexpr int intervals = 100;
/// The states of every tenth interval are kept, as more could hardly be distinguished in a figure.
constexpr int kept_interval = 10;
/// Lower limits of the layers of the record, as multiples of the depth of the deepest roots, or of a tenth of the
/// height of the soil if there are none.
constexpr double layer_limits[] = {0.5, 1, 2, 4};

/// The nodes with soil in each layer under the ground, and the volume of soil of each node [m³].
struct Layers {
  std::vector<double> depths;                   ///< lower limits [m]
  std::vector<std::vector<std::size_t>> nodes;  ///< by layer
  std::vector<double> volume;                   ///< by node
};

/// Returns the depth of the nodes under the rooted ground; without roots that below the highest point of the soil.
template <int D>
std::vector<double> find_node_depths(const input::Case& data, const mesh::Mesh<D>& mesh,
                                     const std::vector<double>& volume, double& unit) {
  std::vector<double> depths;
  unit = 0;
  for (const input::Roots& roots : data.roots) {
    if (roots.depth <= unit) continue;
    unit = roots.depth;
    depths = find_depths<D>(mesh, roots.ground, mesh.nodes);
  }
  if (unit > 0) return depths;
  double top = -std::numeric_limits<double>::infinity(), bottom = -top;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (volume[i] == 0) continue;
    top = std::max(top, mesh.nodes[i][1]);
    bottom = std::min(bottom, mesh.nodes[i][1]);
  }
  unit = 0.1 * (top - bottom);
  for (const auto& x : mesh.nodes) depths.push_back(top - x[1]);
  return depths;
}

template <int D>
Layers find_layers(const input::Case& data, const mesh::Mesh<D>& mesh) {
  Layers layers;
  layers.volume.assign(mesh.nodes.size(), 0.0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    for (int node : mesh.elements[e]) layers.volume[static_cast<std::size_t>(node)] += mesh.volumes[e] / (D + 1);
  }
  double unit = 0;
  const std::vector<double> depths = find_node_depths<D>(data, mesh, layers.volume, unit);
  double upper = -std::numeric_limits<double>::infinity();
  for (const double limit : layer_limits) {
    const double lower = limit * unit;
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      if (layers.volume[i] > 0 && depths[i] > upper && depths[i] <= lower) nodes.push_back(i);
    }
    upper = lower;
    if (nodes.empty()) continue;
    layers.depths.push_back(lower);
    layers.nodes.push_back(std::move(nodes));
  }
  return layers;
}

std::vector<SeasonRecord::Suctions> find_suctions(const Layers& layers, const std::vector<double>& pressure) {
  std::vector<SeasonRecord::Suctions> all;
  for (const auto& nodes : layers.nodes) {
    SeasonRecord::Suctions s{0, pressure[nodes.front()], pressure[nodes.front()]};
    double volume = 0;
    for (const std::size_t i : nodes) {
      s.mean += layers.volume[i] * pressure[i];
      volume += layers.volume[i];
      s.least = std::min(s.least, pressure[i]);
      s.greatest = std::max(s.greatest, pressure[i]);
    }
    s.mean /= volume;
    all.push_back(s);
  }
  return all;
}

template <int D>
std::vector<double> find_pressures(const fem::SeepageModel<D>& model, const std::vector<double>& head) {
  std::vector<double> pressure;
  for (std::size_t i = 0; i < head.size(); ++i)
    pressure.push_back(model.unit_weight * (model.mesh->nodes[i][static_cast<std::size_t>(model.up)] - head[i]));
  return pressure;
}

template <int D>
fem::SeepageHistory<D> solve(const fem::SeepageModel<D>& model, const std::vector<double>& initial,
                             const fem::SeepageSchedule& schedule, const std::string& key,
                             const fem::SeepageOutput<D>& on_output) {
  try {
    return fem::solve_transient_seepage<D>(model, initial, schedule, {}, on_output);
  } catch (const Error& error) {
    if (error.code() != ExitCode::unstable) throw;
    throw Error(
        ExitCode::unstable,
        fmt::format("{}: {} Smaller elements at the ground, or an air entry where the conductivity is Mualem's, may "
                    "help.",
                    key, error.what()));
  }
}

/// Stores the water tables and the fields of the season.
template <int D>
void keep_states(const input::Case& data, const fem::SeepageModel<D>& model,
                 const std::vector<fem::SeepageResult<D>>& states, SeasonRecord& record) {
  for (std::size_t i = kept_interval - 1; i < states.size(); i += kept_interval) {
    record.states.push_back(make_state_result<D>(data, states[i], results::WaterFlow::transient, states[i].time));
    if constexpr (D == 2)
      record.fields.push_back(
          make_field_result<D>(*model.mesh, states[i], results::WaterFlow::transient, states[i].time));
  }
}

}  // namespace

double SeasonRecord::find_error() const {
  const Row& last = rows.back();
  const double scale = std::max({last.inflow, last.outflow, last.transpired, std::abs(last.stored), 1e-300});
  return (last.inflow - last.outflow - last.transpired - last.stored) / scale;
}

template <int D>
FlowInTime<D> follow_flow(const input::Case& data, const fem::SeepageModel<D>& model,
                          const std::vector<double>& initial, const fem::SeepageSchedule& schedule,
                          const std::string& key, const fem::SeepageOutput<D>& on_output) {
  const Layers layers = find_layers<D>(data, *model.mesh);
  fem::SeepageModel<D> growing = model;
  growing.sinks = make_root_sinks<D>(data, *model.mesh);
  FlowInTime<D> flow{solve(growing, initial, schedule, key, on_output), {}};
  const fem::SeepageHistory<D>& history = flow.history;
  SeasonRecord& record = flow.record;
  record.depths = layers.depths;
  record.initial = fem::find_stored_water(model, initial);
  record.rows.push_back({schedule.start, 0, 0, 0, 0, 0, 0, find_suctions(layers, find_pressures(model, initial))});
  for (std::size_t i = 0; i < history.states.size(); ++i) {
    SeasonRecord::Row row{
        history.states[i].time, history.stored[i], 0, 0, 0, 0, 0, find_suctions(layers, history.states[i].pressure)};
    for (const fem::Discharge& d : history.volumes[i]) {
      row.inflow += d.inflow;
      row.outflow += d.outflow;
      row.runoff += d.runoff;
    }
    for (const fem::Uptake& u : history.uptakes[i]) {
      row.potential += u.potential;
      row.transpired += u.actual;
    }
    record.rows.push_back(std::move(row));
  }
  record.discharges = history.volumes.back();
  record.uptakes = history.uptakes.back();
  record.steps = history.steps;
  record.rejected = history.rejected;
  record.iterations = history.iterations;
  return flow;
}

template <int D>
Season<D> run_season(const input::Case& data, const fem::SeepageModel<D>& model, const std::vector<double>& initial) {
  const double length = data.initial.water.season;
  fem::SeepageSchedule schedule;
  schedule.start = -length;
  for (int i = 1; i <= intervals; ++i) schedule.outputs.push_back(length * (i - intervals) / intervals);
  schedule.head_tolerance = head_tolerance;
  FlowInTime<D> flow = follow_flow<D>(data, model, initial, schedule, "[initial] season");
  keep_states<D>(data, model, flow.history.states, flow.record);
  return {std::move(flow.history.states.back()), std::move(flow.record)};
}

results::Season make_season_result(const SeasonRecord& r) {
  const SeasonRecord::Row& last = r.rows.back();
  results::Season result;
  result.duration = last.time - r.rows.front().time;
  result.initial = r.initial;
  result.growth = last.stored;
  result.inflow = last.inflow;
  result.outflow = last.outflow;
  result.runoff = last.runoff;
  result.potential = last.potential;
  result.transpired = last.transpired;
  result.error = r.find_error();
  result.steps = r.steps;
  result.rejected = r.rejected;
  result.iterations = r.iterations;
  for (const fem::Discharge& d : r.discharges)
    if (d.standing != 0) result.standing = result.standing.value_or(0) + d.standing;
  for (const fem::Discharge& d : r.discharges) result.surfaces.push_back({d.name, d.inflow, d.outflow, d.runoff});
  for (const fem::Uptake& u : r.uptakes) result.plants.push_back({u.name, u.potential, u.actual});
  for (std::size_t i = 0; i < r.depths.size(); ++i) {
    const auto &first = r.rows.front().layers[i], &now = last.layers[i];
    double driest = 0;
    for (const SeasonRecord::Row& row : r.rows) driest = std::max(driest, row.layers[i].greatest);
    result.layers.push_back({r.depths[i], first.mean, now.mean, now.least, now.greatest, driest});
  }
  return result;
}

void write_season(const std::filesystem::path& path, const SeasonRecord& r) {
  std::string text =
      "time [s],stored [m3],inflow [m3],outflow [m3],runoff [m3],potential_transpiration [m3],transpired [m3]";
  double upper = 0;
  for (const double depth : r.depths) {
    for (const char* what : {"mean", "least", "greatest"})
      text += fmt::format(",suction.{:.4g}-{:.4g}m.{} [Pa]", upper, depth, what);
    upper = depth;
  }
  text += '\n';
  for (const SeasonRecord::Row& row : r.rows) {
    std::vector<double> values{row.time,   row.stored,    row.inflow,    row.outflow,
                               row.runoff, row.potential, row.transpired};
    for (const auto& s : row.layers) values.insert(values.end(), {s.mean, s.least, s.greatest});
    for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? "," : "") + write_shortest(values[i]);
    text += '\n';
  }
  write_atomically(path, text);
}

#define TALUS_INSTANTIATE(D)                                                                                         \
  template FlowInTime<D> follow_flow<D>(const input::Case&, const fem::SeepageModel<D>&, const std::vector<double>&, \
                                        const fem::SeepageSchedule&, const std::string&,                             \
                                        const fem::SeepageOutput<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE
template Season<2> run_season<2>(const input::Case&, const fem::SeepageModel<2>&, const std::vector<double>&);
template Season<3> run_season<3>(const input::Case&, const fem::SeepageModel<3>&, const std::vector<double>&);

}  // namespace talus::site
