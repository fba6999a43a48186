// SPDX-License-Identifier: MIT
// Lines of the mesh along bedding: no element crosses those through the corners of a section, and none is added
// elsewhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vec.hpp"
#include "input/read.hpp"
#include "mesh/generate.hpp"
#include "run/common/bedding_lines.hpp"

namespace talus {
namespace {

input::Case read_rock(const std::string& soil) {
  return input::read_case_text(R"(title = "Rock"
geometry.polygon = [{ name = "rock", points = [[0, 0], [35, 0], [35, 15], [14, 15], [8, 5], [0, 5]] }]
regions.rock = "schist"
mesh.size = 2
boundary = [{ on = "bottom", fix = "full" }]
analysis.methods = ["fem"]
[materials.schist]
unit_weight = 25
cohesion = 300
friction_angle = 40
tensile_strength = 300
dilatancy_angle = 20
young_modulus = 1e6
poisson_ratio = 0.3
)" + soil,
                               "rock.toml")
      .data;
}

/// Returns the number of elements of soil with nodes on both sides of the plane through a point.
int count_crossed(const mesh::Mesh<2>& mesh, double degrees, const Vec<2>& through) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  int crossed = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    double low = 0, high = 0;
    for (const int n : mesh.elements[e]) {
      const double off =
          std::cos(angle) * (mesh.nodes[n][1] - through[1]) - std::sin(angle) * (mesh.nodes[n][0] - through[0]);
      low = std::min(low, off), high = std::max(high, off);
    }
    crossed += low < -1e-6 && high > 1e-6;
  }
  return crossed;
}

TEST(BeddingLines, NoElementCrossesTheLineThroughACorner) {
  for (const double degrees : {30.0, -20.0, 0.0, 85.0}) {
    std::vector<std::string> notes;
    const input::Case data =
        read_rock("model = \"bedding\"\nbedding_cohesion = 20\nbedding_friction = 25\nbedding_angle = " +
                  std::to_string(degrees) + "\n");
    const mesh::Mesh<2> with = run::generate_with_bedding(data, data.mesh, 1, notes),
                        without = mesh::generate<2>(data.mesh);
    EXPECT_TRUE(notes.empty()) << degrees;
    for (const Vec<2>& corner : {Vec<2>{8, 5}, Vec<2>{14, 15}})
      EXPECT_EQ(count_crossed(with, degrees, corner), 0) << degrees;
    EXPECT_GT(count_crossed(without, degrees, {8, 5}), degrees == 0 ? -1 : 0) << degrees;
  }
}

TEST(BeddingLines, SoilWithoutBeddingHasNone) {
  std::vector<std::string> notes;
  const input::Case data = read_rock("model = \"mohr_coulomb\"\n");
  EXPECT_FALSE(run::has_bedding(data));
  EXPECT_EQ(run::generate_with_bedding(data, data.mesh, 1, notes).elements, mesh::generate<2>(data.mesh).elements);
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace talus
