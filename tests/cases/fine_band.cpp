// SPDX-License-Identifier: MIT
// Fine meshes in a shear band: a slope with ψ = φ is stable with every strength at which a lower bound exists.

#include "cases/methods_slope.hpp"

namespace talus {
namespace {

using nlohmann::json;

class FineBandTest : public MethodsTest {};

/// 45°, H = 10 m, c = 16.1 kPa, φ = ψ = 25.3°: limit analysis bounds the factor by 1.294 and 1.302
/// (docs/verification_data/frozen_meshes.md). Elements of H/67 lie along the band, of H/13 elsewhere. With an average
/// that violates the normality of associated flow the slope fails at 1.29, with 30 m in a minute.
TEST_F(FineBandTest, IsStableBelowTheLowerBound) {
  std::string text = R"(
mesh.size = 0.75
regions = {soil = "soil"}
boundary = [{on = "bottom", fix = "full"}, {on = "left", fix = "normal"}, {on = "right", fix = "normal"}]
geometry.box = [[0, 0], [40, 21]]
[[mesh.refine]]
near = [[11.8, 19.3], [13, 17.1], [14.4, 15.4], [16.9, 13], [19.5, 11.3], [22.1, 10.1], [25, 9.9]]
size = 0.15
distance = 5
[[geometry.polygon]]
name = "soil"
points = [[0, 0], [40, 0], [40, 10], [25, 10], [15, 20], [0, 20]]
[materials.soil]
model = "mohr_coulomb"
grain_density = 2038.736
porosity = 0
young_modulus = "100 MPa"
poisson_ratio = 0.3
cohesion = "16.1 kPa"
friction_angle = 25.3
dilatancy_angle = 25.3
tensile_strength = "34 kPa"
)";
  for (const char* stage :
       {"name = \"gravity\"\nduration = 60\ndamping = 0.75\ncohesion = \"1000 kPa\"\n",
        "name = \"real strength\"\nduration = 60\ndamping = 0.2\n",
        "name = \"reduced\"\nduration = 10\ndamping = 0.2\nstrength_factor = 1.29\nreset_displacement = true\n"})
    text += std::string("[[stage]]\nuntil = \"rest\"\ngeometry = \"frozen\"\nsmoothing = \"stable\"\n") + stage;
  const json summary = run(text);
  const json& reduced = summary.at("stages").at(2);
  EXPECT_EQ(reduced.at("end"), "rest") << reduced.dump();
  EXPECT_LT(reduced.at("displacement").get<double>(), 0.1);
}

}  // namespace
}  // namespace talus
