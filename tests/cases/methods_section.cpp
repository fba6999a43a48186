// SPDX-License-Identifier: MIT
// The section of LEM and the model of FEM made from a case, against closed forms and equivalent cases.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cases/methods_slope.hpp"
#include "mesh/generate.hpp"
#include "run/common/section_of_case.hpp"
#include "run/compare/slip_line.hpp"
#include "run/lem/run_lem.hpp"
#include "site/ground_load.hpp"

namespace talus {
namespace {

using nlohmann::json;

input::Case read(const std::string& text, const std::vector<input::Override>& overrides = {}) {
  return input::read_case_text(text, "slope.toml", overrides).data;
}

TEST_F(MethodsTest, APoolOverTheWholeSlopeLeavesBuoyantSoil) {
  const double water = 9.81;
  const std::string circle = R"([lem]
methods = ["bishop", "spencer"]
search = "none"
[[lem.surface]]
name = "circle"
centre = [30, 35]
radius = 31
)";
  const auto find = [&](const std::string& weights, const std::string& more) {
    const std::string sand = "model = \"mohr_coulomb\", cohesion = 2, friction_angle = 30, " + weights;
    const json summary = run(write_case("\"lem\"", circle + more), {{"materials.sand", "{ " + sand + " }"}});
    return summary.at("lem").at("given").at(0).at("factor").get<double>();  // Bishop
  };
  const auto pool = [&](double level) {
    return find(
        "unit_weight = \"18 kN/m3\", saturated_unit_weight = \"20 kN/m3\"",
        fmt::format("[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, {0}], [44, {0}]]\n", level));
  };
  const double low = pool(15.5), high = pool(30);
  // Not so exactly by Spencer: his one inclination is that of the forces between slices with their water.
  EXPECT_NEAR(low, high, 1e-9 * low);
  const double buoyant = find(fmt::format("unit_weight = \"{} kN/m3\"", 20 - water), "");
  EXPECT_NEAR(high, buoyant, 2e-3 * buoyant);
}

TEST_F(MethodsTest, ATractionOnALineOfTheGroundIsASurcharge) {
  const double traction =
      find_factor(run(write_case("\"lem\"", std::string(few_circles) +
                                                "[[traction]]\non = \"crest\"\ntraction = [0, \"-30 kPa\"]\n")),
                  "spencer");
  const double surcharge = find_factor(
      run(write_case("\"lem\"", std::string(few_circles) +
                                    "[[surcharge]]\nname = \"load\"\nx = [0, 12]\nload = [\"30 kPa\", \"30 kPa\"]\n")),
      "spencer");
  const double none = find_factor(run(write_case("\"lem\"", few_circles)), "spencer");
  EXPECT_NEAR(traction, surcharge, 1e-9);
  EXPECT_LT(surcharge, 0.98 * none);
}

TEST_F(MethodsTest, RootsHoldALongSlopeAsInClosedForm) {
  // A plane 0.5 m under a slope of 20° and 60 m: F = (c + c_r)/(γ h sinβ cosβ) + tanφ/tanβ, ends apart.
  const double beta = 20 * std::numbers::pi / 180, length = 60, rise = length * std::tan(beta), h = 0.5;
  const auto write = [&](double cohesion, double of_roots) {
    std::string text = R"(title = "Long slope"
[geometry]
[[geometry.polygon]]
name = "soil"
points = [[0, -5], [100, -5], [100, 0], [80, 0], [20, )" +
                       std::to_string(rise) + "], [0, " + std::to_string(rise) + R"(]]
[[geometry.line]]
name = "face"
points = [[20, )" + std::to_string(rise) +
                       R"(], [80, 0]]
[materials.soil]
model = "rooted_mohr_coulomb"
unit_weight = "18 kN/m3"
cohesion = )" + std::to_string(cohesion) +
                       R"(
friction_angle = "25 deg"
[regions]
soil = "soil"
[[roots]]
ground = "face"
depth = 1
cohesion = )" + std::to_string(of_roots) +
                       R"(
[analysis]
methods = ["lem"]
[lem]
methods = ["spencer"]
search = "none"
reject = false
[[lem.surface]]
name = "plane"
)";
    const double depth = h, drop = std::tan(beta);
    const auto ground = [&](double x) { return (80 - x) * drop; };
    text += fmt::format("points = [[24, {}], [24.6, {}], [75.4, {}], [76, {}]]\n", ground(24), ground(24.6) - depth,
                        ground(75.4) - depth, ground(76));
    return text;
  };
  const auto find = [&](double cohesion, double of_roots) {
    return run(write(cohesion, of_roots)).at("lem").at("given").at(0).at("factor").get<double>();
  };
  // The ends of the surface add a little to the infinite slope, whatever holds the soil.
  const double closed =
      5000 / (18000 * h * std::sin(beta) * std::cos(beta)) + std::tan(25 * std::numbers::pi / 180) / std::tan(beta);
  EXPECT_NEAR(find(1, 4), closed, 0.04 * closed);
  EXPECT_NEAR(find(1, 4), find(5, 0), 1e-3 * closed);
}

TEST(MethodsGround, UpperLimitOfPolygonsThatCrossAndHaveSteps) {
  mesh::Plan plan;
  plan.polygons = {{"a", {{0, 0}, {10, 0}, {10, 2}, {0, 6}}}, {"b", {{2, 0}, {8, 0}, {8, 7}, {2, 1}}}};
  const auto ground = site::find_ground(plan);
  for (double x = 0.05; x < 10; x += 0.1) {
    double top = 6 - 0.4 * x;
    if (x > 2 && x < 8) top = std::max(top, 1 + (x - 2));
    EXPECT_NEAR(site::find_level(ground, x), top, 1e-9) << x;
  }
  EXPECT_EQ(ground.front()[0], 0);
  EXPECT_EQ(ground.back()[0], 10);
  EXPECT_DOUBLE_EQ(site::find_slope_height(plan, ground), 7 - 2);
}

TEST(MethodsGround, APondWithoutAShoreIsNoted) {
  // The source's slope with water 2 m deep at its toe: it needs the part of the slope below y = 7 m as its shore.
  const auto find_notes = [](const std::string& points) {
    const std::string text = write_case("\"lem\"",
                                        "[[hydraulic]]\non = \"toe\"\ncondition = \"total_head\"\nhead = 7\n"
                                        "[materials.sand.water]\nretention = \"saturated\"\nconductivity = 1e-5\n");
    return site::Site(read(text, {{"geometry.line.toe.points", points}})).list_open_ends();
  };
  ASSERT_EQ(find_notes("[[32, 5], [44, 5]]").size(), 1u);
  EXPECT_NE(find_notes("[[32, 5], [44, 5]]").front().find("x = 32 m"), std::string::npos);
  EXPECT_TRUE(find_notes("[[20, 11], [32, 5], [44, 5]]").empty());
}

TEST(MethodsGround, SurchargesKeepForceAndMomentWhereverTheyEnd) {
  // A load that ends inside the sides of the mesh, falling from 20 to 5 kPa.
  const input::Case data =
      read(write_case("\"fem\"", "[[surcharge]]\nname = \"load\"\nx = [3.3, 10.1]\nload = [\"20 kPa\", \"5 kPa\"]\n"));
  const mesh::Mesh<2> mesh = mesh::generate<2>(data.mesh);
  const auto loads = site::make_surface_loads<2>(data, mesh);
  ASSERT_EQ(loads.size(), 1u);
  double force = 0, moment = 0;
  for (std::size_t s = 0; s < loads[0].sides.size(); ++s) {
    const auto &a = mesh.nodes[loads[0].sides[s][0]], &b = mesh.nodes[loads[0].sides[s][1]];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]), ta = loads[0].traction[s][0][1],
                 tb = loads[0].traction[s][1][1];
    force += length * (ta + tb) / 2;
    moment += length * (a[0] * (2 * ta + tb) + b[0] * (ta + 2 * tb)) / 6;
  }
  const double width = 10.1 - 3.3;
  EXPECT_NEAR(force, -12500 * width, 1e-9 * 12500 * width);
  EXPECT_NEAR(moment / force, 3.3 + width * (20 + 2 * 5) / (3 * 25), 1e-9);
}

/// Largest pull on a side, and the largest difference of `pressure` from what its ends bear [Pa].
std::pair<double, double> measure_loads(const input::Case& data, const std::function<double(const Vec<2>&)>& pressure) {
  const site::Site site(data);
  const mesh::Mesh<2> mesh = mesh::generate<2>(site::conform_to_loads(site, data.mesh));
  double pull = 0, off = 0;
  for (const auto& load : site::make_surface_loads<2>(site, mesh))
    for (std::size_t s = 0; s < load.sides.size(); ++s)
      for (std::size_t k = 0; k < 2; ++k) {
        const Vec<2>&at = mesh.nodes[load.sides[s][k]], &other = mesh.nodes[load.sides[s][1 - k]];
        const Vec<2>& t = load.traction[s][k];
        pull = std::max(pull, t[1]);
        // Just inside the side: the load may end at the node.
        const Vec<2> inside{at[0] + 1e-9 * (other[0] - at[0]), at[1] + 1e-9 * (other[1] - at[1])};
        off = std::max(off, std::abs(std::hypot(t[0], t[1]) - pressure(inside)));
      }
  return {pull, off};
}

TEST(MethodsGround, LoadsAreExactOnTheSidesOfAMeshThatConformsToThem) {
  const input::Case shed =
      read(write_case("\"fem\"", "[[surcharge]]\nname = \"shed\"\nx = [3.3, 10.1]\nload = [20, 5]\n"));
  const auto [pull, off] = measure_loads(shed, [](const Vec<2>& x) { return 20e3 - 15e3 * (x[0] - 3.3) / 6.8; });
  EXPECT_LE(pull, 1e-9);
  EXPECT_LE(off, 1e-3);
  const input::Case pond =
      read(write_case("\"fem\"", "[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, 7.3], [44, 7.3]]\n"));
  const double weight = 1000 * pond.gravity.acceleration;
  const auto [up, apart] = measure_loads(pond, [&](const Vec<2>& x) { return weight * std::max(0.0, 7.3 - x[1]); });
  EXPECT_LE(up, 1e-9);
  EXPECT_LE(apart, 1e-3);
}

TEST(MethodsGround, ACircleMadeIntoASlipLineKeepsItsFactor) {
  const input::Case data = read(write_case("\"lem\"", few_circles));
  const run::PreparedSlope prepared = run::prepare_slope(data);
  lem::SearchOptions options = run::make_search_options(data, 1);
  lem::Surface circle;
  circle.circle = lem::Circle{{30, 35}, 30};
  const auto arcs = lem::find_arcs(*prepared.slope, *circle.circle);
  ASSERT_FALSE(arcs.empty());
  circle.from = arcs.front()[0];
  circle.to = arcs.front()[1];
  const double factor = run::solve_surface(*prepared.slope, circle, lem::Method::spencer, options).solution.factor;
  // Points along the arc that stop short of the ground, from right to left, with noise of a millimetre.
  site::Polyline line;
  for (int i = 1; i < 60; ++i) {
    const double x = circle.to - (circle.to - circle.from) * i / 60;
    line.push_back({x, 35 - std::sqrt(900 - (x - 30) * (x - 30)) + 1e-3 * (i % 2)});
  }
  const auto surface = run::make_surface(*prepared.slope, line);
  ASSERT_TRUE(surface.has_value());
  EXPECT_LT(surface->line.size(), 25u);
  EXPECT_NEAR(run::solve_surface(*prepared.slope, *surface, lem::Method::spencer, options).solution.factor, factor,
              0.01 * factor);
  EXPECT_LT(run::find_mean_distance(line, surface->line), 0.1);
}

TEST_F(MethodsTest, APassiveForceIsAtMostTheResistance) {
  const std::string nails = R"([lem]
methods = ["spencer"]
search = "none"
referee = false
yield_acceleration = false
[[lem.surface]]
name = "circle"
centre = [30, 35]
radius = 31
[support.nails]
kind = "nail"
heads = [[16, 13], [20, 11]]
inclination = 10
length = 14
out_of_plane_spacing = 1.5
tensile_strength = 30
plate = 30
bond = 40
sense = "passive"
)";
  for (const double friction : {12, 38}) {
    const json summary =
        run(write_case("\"lem\"", nails), {{"materials.sand.friction_angle", fmt::format("{}", friction)}});
    const json& surface = summary.at("lem").at("given").at(0);
    const double factor = surface.at("factor");
    EXPECT_EQ(factor < 1, friction < 20) << factor;
    ASSERT_EQ(surface.at("supports").size(), 2u);
    for (const json& nail : surface.at("supports")) {
      const double resistance = nail.at("resistance"), force = nail.at("force");
      EXPECT_NEAR(force, resistance / std::max(1.0, factor), 1e-9 * resistance);
      ASSERT_EQ(nail.contains("required"), factor < 1);
      EXPECT_NEAR(nail.value("required", force), resistance / factor, 1e-9 * resistance);
    }
  }
}

}  // namespace
}  // namespace talus
