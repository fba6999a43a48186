// SPDX-License-Identifier: MIT
// Water, slurries and earthquakes on a section extruded to 3D, against hydrostatics and the plane section.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "input/read.hpp"
#include "mesh/generate.hpp"
#include "run/check_case.hpp"
#include "run/run_case.hpp"
#include "site/ground_load.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

constexpr double thickness = 4, water = 9810;  // [m], [N/m³]

/// A section of clay of this outline, `more` after it.
std::string write_clay(int dimension, const std::string& outline, const std::string& more) {
  std::string text = fmt::format(
      "title = \"clay\"\n[geometry]\ndimension = {}\nbox = [[0, 0], [40, 13]]\n{}[[geometry.polygon]]\n"
      "name = \"clay\"\npoints = {}\n[regions]\nclay = \"clay\"\n[mesh]\nsize = 4\n[materials.clay]\n"
      "model = \"mohr_coulomb\"\nunit_weight = 18.5\nporosity = 0.4\ncohesion = 8\nfriction_angle = "
      "26\ndilatancy_angle = 26\n"
      "tensile_strength = 0\nyoung_modulus = \"30 MPa\"\npoisson_ratio = 0.3\n"
      "[analysis]\nmethods = [\"fem\"]\n[fem]\nsize = 4\nmeshes = 1\n",
      dimension, dimension == 3 ? fmt::format("thickness = {}\n", thickness) : "", outline);
  for (const char* side : {"left", "right", "bottom", "front", "back"})
    if (dimension == 3 || (std::string(side) != "front" && std::string(side) != "back"))
      text += fmt::format("[[boundary]]\non = \"{}\"\nfix = \"{}\"\n", side,
                          std::string(side) == "bottom" ? "full" : "normal");
  return text + more;
}

constexpr const char *level_ground = "[[0, 0], [40, 0], [40, 8], [0, 8]]",
                     *slope = "[[0, 0], [40, 0], [40, 4], [28, 4], [12, 12], [0, 12]]",
                     *trench = "[[0, 0], [40, 0], [40, 8], [24, 8], [24, 3], [16, 3], [16, 8], [0, 8]]";

std::string write_table(double level) {
  return fmt::format("[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, {0}], [40, {0}]]\n", level);
}

input::Case read_soil_case(const std::string& text) {
  return input::read_case_text(text, "clay.toml", {}).data;
}

/// Returns the sum of the loads on the ground of the case [N].
Vec<3> sum_loads(const std::string& text) {
  const input::Case data = read_soil_case(text);
  const mesh::Mesh<3> mesh = mesh::generate<3>(data.mesh);
  Vec<3> sum{};
  for (const auto& load : site::make_surface_loads<3>(data, mesh))
    for (std::size_t s = 0; s < load.sides.size(); ++s) {
      const auto &a = mesh.nodes[load.sides[s][0]], &b = mesh.nodes[load.sides[s][1]],
                 &c = mesh.nodes[load.sides[s][2]];
      const Vec<3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      const double area =
          std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
      for (const Vec<3>& t : load.traction[s])
        for (std::size_t d = 0; d < 3; ++d) sum[d] += t[d] * area / 3;
    }
  return sum;
}

TEST(LoadsIn3D, LevelGroundCarriesTheWeightOfThePond) {
  const Vec<3> sum = sum_loads(write_clay(3, level_ground, write_table(8.5)));
  const double weight = water * 0.5 * 40 * thickness;
  EXPECT_NEAR(sum[1], -weight, 1e-9 * weight);
  EXPECT_NEAR(std::hypot(sum[0], sum[2]), 0, 1e-9 * weight);
  EXPECT_EQ(norm(sum_loads(write_clay(3, level_ground, write_table(7.5)))), 0) << "a table in the soil is no load";
}

TEST(LoadsIn3D, APondOnASlopeHasItsWeightAndItsThrust) {
  // The pond is 2 m deep at the toe, and its shore 4 m up the slope of 1 : 2.
  const double weight = water * (2 * 12 + 2.0 * 4 / 2) * thickness, thrust = water * 2 * 2 / 2 * thickness;
  const std::string head =
      "[[geometry.line]]\nname = \"face\"\npoints = [[20, 8], [28, 4], [40, 4]]\n[materials.clay.water]\n"
      "retention = \"saturated\"\nconductivity = \"1e-6 m/s\"\n[[hydraulic]]\non = \"face\"\n"
      "condition = \"total_head\"\nhead = 6\n[initial]\npore_pressure = \"seepage\"\n";
  const std::string porous = write_clay(3, slope, head);
  for (const std::string& text : {write_clay(3, slope, write_table(6)), porous}) {
    const Vec<3> sum = sum_loads(text);
    EXPECT_NEAR(sum[1], -weight, 2e-3 * weight);
    EXPECT_NEAR(sum[0], -thrust, 1e-2 * thrust) << "the shore runs through triangles, which are integrated in parts";
    EXPECT_NEAR(sum[2], 0, 1e-9 * weight);
  }
}

TEST(LoadsIn3D, ASlurryPressesOnTheBaseAndTheSidesOfItsTrench) {
  const auto write_slurry = [](double from, double to) {
    return write_clay(3, trench,
                      fmt::format("[[slurry]]\nname = \"s\"\nx = [{}, {}]\nlevel = 7\nunit_weight = 11\n", from, to));
  };
  const Vec<3> whole = sum_loads(write_slurry(16, 24)), half = sum_loads(write_slurry(16, 20));
  const double weight = 11e3 * 4 * 8 * thickness, thrust = 11e3 * 4 * 4 / 2 * thickness;
  EXPECT_NEAR(whole[1], -weight, 1e-9 * weight);
  EXPECT_NEAR(whole[0], 0, 1e-3 * weight) << "on both sides";
  EXPECT_NEAR(half[0], -thrust, 1e-2 * thrust) << "on the left side alone";
}

TEST(LoadsIn3D, AnEarthquakeOfBothDirectionsPushesTowardsTheLowerEnd) {
  const std::string quake = "[earthquake]\nhorizontal = 0.1\n",
                    left = "[[0, 0], [40, 0], [40, 12], [28, 12], [12, 4], [0, 4]]";
  EXPECT_GT(site::Site(read_soil_case(write_clay(3, slope, quake))).find_earthquake<3>()[0], 0);
  EXPECT_LT(site::Site(read_soil_case(write_clay(3, left, quake))).find_earthquake<3>()[0], 0);
}

TEST(LoadsIn3D, WaterWithoutAGroundToBearItIsRefused) {
  // A cave below the water table.
  const std::string cave = "[[0, 0], [40, 0], [40, 8], [20, 8], [20, 6], [30, 6], [30, 4], [10, 4], [10, 8], [0, 8]]";
  for (const char* method : {"fem", "mpm"}) {
    const auto check = [&](int dimension, double level) {
      std::string text = write_clay(dimension, cave, write_table(level));
      text.replace(text.find("\"fem\""), 5, fmt::format("\"{}\"", method));
      run::check_methods(read_soil_case(text));
    };
    for (const int dimension : {2, 3}) EXPECT_THROW(check(dimension, 5), Error) << method << dimension;
  }
  // A ready mesh has no ground of polygons.
  input::Case ready = read_soil_case(write_clay(3, level_ground, write_table(8.5)));
  const mesh::Mesh<3> mesh = mesh::generate<3>(ready.mesh);
  ready.mesh.polygons.clear();
  EXPECT_THROW(site::make_surface_loads<3>(ready, mesh), Error);
  ready.initial.water.water_table = {{0, 7}};
  EXPECT_TRUE(site::make_surface_loads<3>(ready, mesh).empty());
}

/// Runs FEM on the case; returns its result.
results::ElementResult run_elements(const std::string& text) {
  run::RunOptions options;
  options.folder = support::make_scratch("loads_in_3d") / "run";
  return *run::run_case(input::read_case_text(text, "clay.toml", {}), options).elements;
}

TEST(LoadsIn3D, FemHasTheFactorOfThePlaneSectionUnderWater) {
  const auto find = [](int dimension) {
    return run_elements(write_clay(dimension, slope, write_table(4.5))).runs.at(0).factor;
  };
  const double plane = find(2);
  EXPECT_NEAR(find(3), plane, 0.05 * plane);
  try {
    run_elements(write_clay(3, level_ground, write_table(8.5)));
    FAIL() << "level ground does not fail";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("still stable"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace talus
