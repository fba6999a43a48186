// SPDX-License-Identifier: MIT
// The same weight, loads and earthquake in the models that LEM, FEM, limit analysis and MPM make of one site.

#include "site/site.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"
#include "mesh/generate.hpp"
#include "mesh/planar.hpp"
#include "mpm/solver/observe.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "run/common/section_of_case.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/mpm/start/prepare.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

constexpr double weight = 20e3;  // γ of the soil, above and below the water table [N/m³]

/// The dry slope of the source with a constant unit weight.
input::Case make_case(const std::string& more) {
  std::string text = support::write_slope("dry");
  const std::string density = "grain_density = 2500\nporosity = 0.2\n";
  text.replace(text.find(density), density.size(),
               "unit_weight = \"20 kN/m3\"\nsaturated_unit_weight = \"20 kN/m3\"\n");
  return input::read_case_text(text + more, "slope.toml",
                               {{"mesh.size", "2.5"},
                                {"analysis.methods", R"(["lem", "fem", "bounds", "mpm"])"},
                                {"stage", R"([{name = "gravity", duration = 1}])"}})
      .data;
}

/// Forces on the whole soil, per metre: of weight and earthquake, and of the loads on the ground [N/m].
struct Forces {
  Vec<2> body{}, loads{};
};

Forces sum_solid(const input::Case& data) {
  const run::SolidOfCase<2> solid = run::make_solid<2>(data);
  const mesh::Mesh<2>& mesh = *solid.mesh;
  Forces sum;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (std::size_t d = 0; d < 2; ++d)
      sum.body[d] += mesh.volumes[e] * solid.model.unit_weight[e] * solid.model.direction[d];
  for (const fem::SurfaceLoad<2>& load : solid.model.loads)
    for (std::size_t s = 0; s < load.sides.size(); ++s) {
      const Vec<2>&a = mesh.nodes[load.sides[s][0]], &b = mesh.nodes[load.sides[s][1]];
      for (std::size_t d = 0; d < 2; ++d)
        sum.loads[d] += std::hypot(b[0] - a[0], b[1] - a[1]) * (load.traction[s][0][d] + load.traction[s][1][d]) / 2;
    }
  return sum;
}

Forces sum_problem(const input::Case& data) {
  const bounds::Problem problem = run::make_bounds_problem(data).problem;
  const auto at = [&](int node) { return problem.nodes[static_cast<std::size_t>(node)]; };
  Forces sum;
  for (std::size_t e = 0; e < problem.size(); ++e) {
    const Vec<2> a = at(problem.triangles[e][0]), b = at(problem.triangles[e][1]), c = at(problem.triangles[e][2]);
    const double area = std::abs(mesh::compute_area({a, b, c}));
    for (std::size_t d = 0; d < 2; ++d) sum.body[d] += area * problem.body_force[e][d];
  }
  for (const bounds::Side& side : problem.sides) {
    const Vec<2> a = at(side.from), b = at(side.to);
    for (std::size_t d = 0; d < 2; ++d)
      sum.loads[d] += std::hypot(b[0] - a[0], b[1] - a[1]) * (side.traction[0][d] + side.traction[1][d]) / 2;
  }
  return sum;
}

Forces sum_body(const input::Case& data) {
  const mpm::Body<2> body = run::prepare<2>(data, mesh::generate<2>(data.mesh));
  const Vec<2> acceleration = run::find_acceleration<2>(data);
  Forces sum;
  for (int id = 0; id < body.points.size(); ++id)
    for (std::size_t d = 0; d < 2; ++d) sum.body[d] += mpm::view_point(body, id).mass * acceleration[d];
  // The nodal forces of the fixed pore pressures add up to zero, since the gradients of an element's shape functions
  // do.
  for (const mpm::Load<2>& load : body.conditions.loads)
    for (const auto& entry : load.entries)
      for (std::size_t d = 0; d < 2; ++d) sum.loads[d] += entry.force[d];
  return sum;
}

/// LEM has the loads as functions of x.
Forces sum_section(const input::Case& data) {
  const lem::Section section = run::make_section(data).section;
  Forces sum;
  for (const lem::Region& region : section.regions)
    sum.body[1] -= std::abs(mesh::compute_area(region.polygon)) * section.soils[region.soil].saturated_unit_weight;
  sum.body[0] = -sum.body[1] * section.horizontal_acceleration;
  constexpr int parts = 200000;
  const double left = section.ground.front()[0], width = (section.ground.back()[0] - left) / parts;
  for (int i = 0; i < parts; ++i) {
    const double x = left + (i + 0.5) * width, ground = site::find_level(section.ground, x);
    const double rise =
        (site::find_level(section.ground, x + width / 4) - site::find_level(section.ground, x - width / 4)) /
        (width / 2);
    const double pressure =
        section.water_unit_weight * std::max(0.0, site::find_water_table(section.water_table, x) - ground);
    sum.loads[0] += width * pressure * rise;
    sum.loads[1] -= width * pressure;
  }
  for (const lem::Surcharge& s : section.surcharges)
    for (std::size_t i = 1; i < s.load.size(); ++i)
      sum.loads[1] -= (s.load[i][0] - s.load[i - 1][0]) * (s.load[i][1] + s.load[i - 1][1]) / 2;
  return sum;
}

void expect_equal(const Forces& got, const Forces& given, double most, const char* method) {
  const double all = std::hypot(given.body[0], given.body[1]);
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_NEAR(got.body[d], given.body[d], 1e-9 * all) << method << ", axis " << d;
    EXPECT_NEAR(got.loads[d], given.loads[d], most * all) << method << ", axis " << d;
  }
}

TEST(Site, EachMethodTakesTheSameWeightAndLoads) {
  std::mt19937 random(11);
  const auto draw = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(random()) / 0x1p32);
  };
  for (int i = 0; i < 6; ++i) {
    const double from = draw(0.5, 20), to = from + draw(1, 20), level = draw(4, 14);
    const input::Case data =
        make_case(fmt::format("[[surcharge]]\nname = \"shed\"\nx = [{}, {}]\nload = [\"30 kPa\", \"{} kPa\"]\n"
                              "[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, {}], [44, {}]]\n"
                              "[earthquake]\nhorizontal = {}\ndirection = \"right\"\n",
                              from, to, draw(5, 60), level, level, draw(0, 0.3)));
    const Forces given = sum_solid(data);
    EXPECT_NEAR(given.body[1], -weight * (44 * 5 + 22 * 10), 1) << "the section of the source";
    expect_equal(sum_problem(data), given, 1e-9, "limit analysis");
    expect_equal(sum_body(data), given, 1e-9, "MPM");
    expect_equal(sum_section(data), given, 1e-6, "LEM");
  }
}

TEST(Site, AnOverhangHasNoGroundUntilItIsAskedFor) {
  input::Case data = make_case("");
  data.mesh.polygons = {{"soil", {{0, 0}, {14, 0}, {14, 1}, {10, 5}, {14, 8}, {0, 8}}}};
  const site::Site site(data);
  EXPECT_FALSE(site.has_ground());
  EXPECT_TRUE(site.ponds().empty());
  EXPECT_FALSE(site.find_standing_level(5).has_value());
  EXPECT_THROW(site.ground(), Error);
  EXPECT_EQ(&site.get_soil("soil"), &site.data().materials.at("sand"));
  EXPECT_THROW(site.get_soil("rock"), Error);
}

}  // namespace
}  // namespace talus
