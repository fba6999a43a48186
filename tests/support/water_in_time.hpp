// SPDX-License-Identifier: MIT
#pragma once
// The pore water of a case with a [timeline], computed as in its run: the initial state, and the pressures at its
// times.

#include <array>
#include <string>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "input/read.hpp"
#include "mesh/generate.hpp"
#include "mesh/locate.hpp"
#include "run/timeline/times.hpp"
#include "site/initial_water.hpp"
#include "site/season.hpp"

namespace talus::support {

class WaterInTime {
 public:
  explicit WaterInTime(const std::string& text, const std::vector<input::Override>& overrides = {})
      : data_(site::close_sides(input::read_case_text(text, "water.toml", overrides).data)) {
    mesh_ = mesh::generate<2>(data_.mesh);
    mesh::Mesh<2> wet_mesh;
    const auto model = site::make_seepage_model<2>(data_, mesh_, wet_mesh);
    pressures_.push_back(site::find_nodal_pressure<2>(data_, mesh_));
    if (!data_.timeline) return;
    std::vector<double> heads;
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i)
      heads.push_back(mesh_.nodes[i][1] - pressures_[0][i] / model.unit_weight);
    fem::SeepageSchedule schedule;
    schedule.outputs = run::list_times(data_);
    schedule.head_tolerance = site::head_tolerance;
    const auto flow = site::follow_flow<2>(data_, model, heads, schedule, "[timeline]");
    for (const auto& state : flow.history.states) pressures_.push_back(state.pressure);
  }

  /// Pore pressure [Pa], suction negative, after `number` of the case's times, 0 for the start; linear in the element.
  double find(std::size_t number, const std::array<double, 2>& x) const {
    const int e = mesh::find_element<2>(mesh_, x);
    if (e < 0) throw std::runtime_error("the point is outside the mesh");
    const auto& nodes = mesh_.elements[static_cast<std::size_t>(e)];
    const auto &a = mesh_.nodes[nodes[0]], &b = mesh_.nodes[nodes[1]], &c = mesh_.nodes[nodes[2]];
    const auto cross = [](const auto& p, const auto& q, const auto& r) {
      return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    };
    const std::vector<double>& p = pressures_.at(number);
    return -(cross(x, b, c) * p[nodes[0]] + cross(a, x, c) * p[nodes[1]] + cross(a, b, x) * p[nodes[2]]) /
           cross(a, b, c);
  }

 private:
  input::Case data_;
  mesh::Mesh<2> mesh_;
  std::vector<std::vector<double>> pressures_;  ///< of the nodes, positive in tension [Pa]
};

}  // namespace talus::support
