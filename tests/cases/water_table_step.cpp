// SPDX-License-Identifier: MIT
// A water table with a step of 1 cm beside a vertical face, against hydrostatics of the two sides.

#include <gtest/gtest.h>

#include <cmath>

#include "input/read.hpp"
#include "mesh/generate.hpp"
#include "site/ground_load.hpp"
#include "site/pore_water.hpp"

namespace talus {
namespace {

/// A pit of 6 m whose table falls from -3 m to its bottom within `from` and `to`.
input::Case read_pit(const std::string& from, const std::string& to) {
  return input::read_case_text(
             "title = \"pit\"\n[[geometry.polygon]]\nname = \"sand\"\n"
             "points = [[0, -16], [50, -16], [50, -6], [20, -6], [20, 0], [0, 0]]\n[geometry]\n"
             "[[geometry.line]]\nname = \"wall\"\npoints = [[20, -6], [20, -16]]\n[mesh]\nsize = 2\n"
             "[regions]\nsand = \"sand\"\n[materials.sand]\nmodel = \"mohr_coulomb\"\nunit_weight = 18\nporosity = "
             "0.38\n"
             "cohesion = 1\nfriction_angle = 33\ndilatancy_angle = 3\ntensile_strength = 0\nyoung_modulus = \"40 "
             "MPa\"\n"
             "poisson_ratio = 0.3\n[analysis]\nmethods = [\"fem\"]\n[fem]\nsize = 2\n[initial]\n"
             "pore_pressure = \"water_table\"\nwater_table = [[0, -3], [" +
                 from + ", -3], [" + to + ", -6], [50, -6]]\n",
             "pit.toml", {})
      .data;
}

TEST(WaterTableStep, GivesEachSideItsOwnLevelAndLoadsNoFace) {
  constexpr double weight = 9810;
  for (const auto& [from, to] : {std::pair{"20", "20.01"}, std::pair{"19.99", "20"}}) {
    const input::Case data = read_pit(from, to);
    const site::Site site(data);
    const mesh::Mesh<2> mesh = mesh::generate<2>(site::conform_to_loads(site, data.mesh));
    double shortest = 10;
    const auto water = site::find_held_water<2>(data, mesh);
    for (int e = 0; e < mesh.element_count(); ++e) {
      if (mesh.element_region[e] == mesh::empty_region) continue;
      double middle = 0;
      for (const int node : mesh.elements[e]) middle += mesh.nodes[node][0] / 3;
      const double level = middle < 20 ? -3 : -6;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto &a = mesh.nodes[mesh.elements[e][c]], &b = mesh.nodes[mesh.elements[e][(c + 1) % 3]];
        shortest = std::min(shortest, std::hypot(a[0] - b[0], a[1] - b[1]));
        EXPECT_NEAR(std::min(water.pore[e][c], 0.0), std::min(weight * (a[1] - level), 0.0), 1) << a[0] << ", " << a[1];
      }
    }
    EXPECT_GT(shortest, 0.2) << "a step adds no corner to the ground";
    EXPECT_TRUE(site::make_surface_loads<2>(site, mesh).empty()) << "water of 1 cm stands on nothing";
  }
}

}  // namespace
}  // namespace talus
