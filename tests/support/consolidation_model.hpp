// SPDX-License-Identifier: MIT
#pragma once
// Models for consolidation: layered elastic boxes between smooth walls, drained on chosen sides.

#include <functional>
#include <string>
#include <vector>

#include "fem/consolidation/consolidation.hpp"
#include "support/solid_model.hpp"

namespace talus::support {

inline constexpr double water_weight = 10e3;  ///< [N/m³]

/// A layer of elastic soil, from the base up.
struct WetLayer {
  double thickness = 1;     ///< [m]
  double oedometric = 1e7;  ///< E_oed [Pa]
  double conductivity = 1e-8;
  double poisson = 0;
  double unit_weight = 0;
};

/// A box of layers whose sides and base are on rollers. Not to be moved: the models point to the meshes.
struct WetBox {
  mesh::Mesh<2> mesh;
  fem::SolidModel<2> solid;
  fem::SeepageModel<2> flow;
  fem::ConsolidationModel<2> model;
  std::vector<WetLayer> layers;
  double width = 1, height = 0;  ///< [m]

  /// `plan` has further lines and refinements of the mesh.
  WetBox(std::vector<WetLayer> given, double box_width, double size, mesh::Plan plan = {})
      : layers(std::move(given)), width(box_width) {
    for (const WetLayer& layer : layers) {
      const double low = height, high = height + layer.thickness;
      plan.polygons.push_back(
          {"layer " + std::to_string(plan.polygons.size()), {{0, low}, {width, low}, {width, high}, {0, high}}});
      height = high;
    }
    plan.box_min = {0, 0};
    plan.box_max = {width, height};
    plan.size = size;
    mesh = mesh::generate<2>(plan);
    solid.mesh = flow.mesh = &mesh;
    solid.direction = {0, -1};
    for (const int region : mesh.element_region) solid.unit_weight.push_back(get_layer(region).unit_weight);
    solid.make_law = [this](int region, double) -> material::Law {
      const WetLayer& layer = get_layer(region);
      const double young = layer.oedometric * (1 + layer.poisson) * (1 - 2 * layer.poisson) / (1 - layer.poisson);
      return material::LinearElastic::from_young(young, layer.poisson);
    };
    add_roller<2>(solid, 0, 0);
    add_roller<2>(solid, 0, width);
    add_roller<2>(solid, 1, 0);
    flow.unit_weight = water_weight;
    for (std::size_t r = 0; r < mesh.region_names.size(); ++r) {
      fem::HydraulicSoil<2> soil;
      const double k = get_layer(static_cast<int>(r)).conductivity;
      soil.name = mesh.region_names[r], soil.porosity = 0.4, soil.conductivity = {k, k};
      soil.water_modulus = 1e13;  // practically incompressible, as in the closed forms
      flow.soils.push_back(soil);
    }
    model.solid = &solid;
    model.flow = &flow;
    balance_water();
  }
  WetBox(const WetBox&) = delete;

  const WetLayer& get_layer(int region) const {
    const std::string& name = mesh.region_names[static_cast<std::size_t>(region)];
    return layers[static_cast<std::size_t>(std::stoi(name.substr(6)))];
  }
  /// Lets the soil bear the weight of the water at rest, which has none here.
  void balance_water() {
    for (const auto& element : mesh.elements)
      for (std::size_t q = 0; q < 3; ++q) {
        double y = 0;
        for (std::size_t i = 0; i < 3; ++i)
          y += (i == q ? 2.0 / 3 : 1.0 / 6) * mesh.nodes[static_cast<std::size_t>(element[i])][1];
        const double p = water_weight * (height - y);
        solid.point_stress.push_back({p, p, p, 0, 0, 0});
      }
  }
  /// Keeps the head at a level on a side at a coordinate plane.
  void drain(std::size_t axis, double value, double head) {
    fem::HydraulicBoundary<2> b;
    b.name = "drained";
    b.kind = fem::HydraulicKind::total_head;
    b.sides = find_sides_at<2>(mesh, axis, value);
    b.value = head;
    flow.boundaries.push_back(b);
  }
  void press_top(double pressure) { add_load<2>(solid, find_sides_at<2>(mesh, 1, height), {0, -pressure}); }
  /// The state without stress, with water at rest up to the top.
  fem::ConsolidationState<2> make_start() const {
    return fem::make_first_state(model, std::vector<double>(mesh.nodes.size(), height));
  }
  /// Acts the loads at once, without flow.
  fem::ConsolidationState<2> press_undrained(const fem::ConsolidationState<2>& start) const {
    fem::ConsolidationSchedule schedule;
    schedule.load_steps = 1;
    schedule.threads = 1;
    fem::ConsolidationResult<2> result = fem::run_stage(model, start, schedule);
    EXPECT_TRUE(result.converged);
    return result.outputs.back().at;
  }
  /// Pore pressure above that of water at rest up to the top, at the corner nodes [Pa].
  double find_excess(const fem::ConsolidationState<2>& state, std::size_t node) const {
    return water_weight * (state.head[node] - height);
  }
  std::size_t find_node(double x, double y) const {
    std::size_t best = 0;
    const auto miss = [&](std::size_t n) { return std::hypot(mesh.nodes[n][0] - x, mesh.nodes[n][1] - y); };
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      if (miss(n) < miss(best)) best = n;
    return best;
  }
  /// Mean excess over the area [Pa].
  double find_mean_excess(const fem::ConsolidationState<2>& state) const {
    double sum = 0, area = 0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      for (const int node : mesh.elements[e]) {
        sum += mesh.volumes[e] / 3 * find_excess(state, static_cast<std::size_t>(node));
        area += mesh.volumes[e] / 3;
      }
    return sum / area;
  }
};

}  // namespace talus::support
