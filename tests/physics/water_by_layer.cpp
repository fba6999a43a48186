// SPDX-License-Identifier: MIT
// Piezometric lines of single soils and grids of pore pressures: the same water in another form gives the same factor,
// and every slice has the pressure of its soil.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810;

/// A slope of 45° in clay on sand, with the pore pressure of `water`.
std::string write_slope(const std::string& methods, const std::string& water,
                        const std::string& search = "entry_exit = { entries = 12, exits = 12, depths = 8 }") {
  return fmt::format(R"(
analysis.methods = [{}]
mesh.size = 0.7
bounds = {{ gap = 0.1, size = 0.7 }}
lem = {{ methods = ["spencer"], referee = false, {} }}
fem = {{ meshes = 1, flow = "associated" }}
geometry.polygon = [
  {{ name = "top", points = [[0, 3], [0, 8], [5, 8], [10, 3]] }}, {{ name = "foot", points = [[0, 0], [16, 0], [16, 3], [0, 3]] }}]
regions = {{ top = "clay", foot = "sand" }}
{}
[materials.clay]
model = "mohr_coulomb"
unit_weight = 18
saturated_unit_weight = 20
cohesion = 12
friction_angle = 25
dilatancy_angle = 25
tensile_strength = 0
young_modulus = 3e4
poisson_ratio = 0.3
[materials.sand]
model = "mohr_coulomb"
unit_weight = 18
saturated_unit_weight = 20
cohesion = 3
friction_angle = 30
dilatancy_angle = 30
tensile_strength = 0
young_modulus = 3e4
poisson_ratio = 0.3
)",
                     methods, search, water);
}

class WaterByLayer : public ::testing::Test {
 protected:
  nlohmann::json run(const std::string& text) {
    run::RunOptions options;
    options.folder = folder_ / "run";
    options.overwrite = true;
    return support::run_case(input::read_case_text(text, (folder_ / "slope.toml").string()), options);
  }
  /// Writes a table for [initial.pressure_grid] on a grid of points.
  void write_table(const std::string& head, auto&& value) {
    std::ofstream file(folder_ / "grid.csv");
    file << "x [m], y [m], " << head << "\n";
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 12; ++j) file << fmt::format("{}, {}, {:.17g}\n", i, j, value(1.0 * i, 1.0 * j));
  }
  const std::filesystem::path folder_ = support::make_scratch("water_by_layer");
};

constexpr const char* table = R"(initial = { pore_pressure = "water_table", water_table = [[0, 6], [10, 2.5]] })";

TEST_F(WaterByLayer, LinesOfAllSoilsAreAWaterTable) {
  const nlohmann::json one = run(write_slope(R"("lem", "fem", "bounds")", table));
  const nlohmann::json other = run(write_slope(R"("lem", "fem", "bounds")", R"(
initial = { pore_pressure = "water_table", water_table = [[0, 1]], piezometric_line = [
  { materials = ["clay", "sand"], points = [[0, 6], [10, 2.5]] }] })"));
  for (const auto& summary : {one, other}) ASSERT_FALSE(summary.at("lem").at("critical").empty());
  EXPECT_NEAR(other.at("lem").at("critical")[0].at("factor").get<double>(),
              one.at("lem").at("critical")[0].at("factor").get<double>(), 1e-12);
  for (const char* bound : {"lower", "upper"})
    EXPECT_NEAR(other.at("bounds").at(bound).get<double>(), one.at("bounds").at(bound).get<double>(), 1e-12);
  EXPECT_NEAR(other.at("fem").at("runs")[0].at("factor").get<double>(),
              one.at("fem").at("runs")[0].at("factor").get<double>(), 1e-12);
}

TEST_F(WaterByLayer, LinesOfAllSoilsAreAWaterTableForMaterialPoints) {
  const auto write = [](const std::string& water) {
    return write_slope(R"("mpm")", R"(
geometry.box = [[0, 0], [16, 9]]
mesh.points_per_element = 3
boundary = [{ on = "bottom", fix = "full" }, { on = "left", fix = "normal" }, { on = "right", fix = "normal" }]
stage = [{ name = "gravity", duration = 0.3, damping = 0.75, geometry = "frozen" }]
)" + water);
  };
  const nlohmann::json one = run(write(table)), other = run(write(R"(
initial = { pore_pressure = "water_table", water_table = [[0, 1]], piezometric_line = [
  { materials = ["clay", "sand"], points = [[0, 6], [10, 2.5]] }] })"));
  EXPECT_GT(one.at("budgets").at("elastic_energy").get<double>(), 0);
  EXPECT_EQ(other.at("budgets").at("elastic_energy"), one.at("budgets").at("elastic_energy"));
}

TEST_F(WaterByLayer, EverySliceHasThePressureOfItsSoil) {
  const nlohmann::json summary = run(write_slope(R"("lem")", R"(
initial = { pore_pressure = "water_table", water_table = [[0, 6], [10, 3], [16, 3]], piezometric_line = [
  { materials = ["sand"], points = [[0, 7], [16, 5]] }] })",
                                                 R"(search = "none", surface = [
  { name = "deep", points = [[1, 8], [4, 3], [6, 1.5], [10, 1.5], [14, 3]] }])"));
  const nlohmann::json& slices = summary.at("lem").at("given")[0].at("slices");
  int clay = 0, sand = 0;
  for (std::size_t i = 0; i < slices.at("soil").size(); ++i) {
    const auto middle = [&](std::size_t d) {
      return 0.5 * (slices.at("base_left")[i][d].get<double>() + slices.at("base_right")[i][d].get<double>());
    };
    const double x = middle(0), y = middle(1);
    const bool is_sand = slices.at("soil")[i] == "sand";
    EXPECT_EQ(is_sand, y < 3) << y;
    const double level = is_sand ? 7 - x / 8 : std::max(3.0, 6 - 0.3 * x);
    EXPECT_NEAR(slices.at("pore_pressure")[i].get<double>(), std::max(0.0, gamma_w * (level - y)), 1e-3) << x;
    ++(is_sand ? sand : clay);
  }
  EXPECT_GT(clay, 3);
  EXPECT_GT(sand, 3);
}

TEST_F(WaterByLayer, ArtesianWaterLowersTheFactorOfAllMethods) {
  const std::string artesian = R"(
initial = { pore_pressure = "water_table", water_table = [[0, 6], [10, 2.5]], piezometric_line = [
  { materials = ["sand"], points = [[0, 7.5], [10, 2.9]] }] })";
  const nlohmann::json plain = run(write_slope(R"("lem", "bounds")", table)),
                       raised = run(write_slope(R"("lem", "bounds")", artesian));
  const double lem = raised.at("lem").at("critical")[0].at("factor").get<double>();
  EXPECT_LT(lem, 0.98 * plain.at("lem").at("critical")[0].at("factor").get<double>());
  EXPECT_LT(raised.at("bounds").at("upper").get<double>(), plain.at("bounds").at("upper").get<double>());
  // LEM lies within the bounds of the same soil, with the 1 % by which a search may miss.
  EXPECT_GT(lem, 0.99 * raised.at("bounds").at("lower").get<double>());
}

TEST_F(WaterByLayer, AGridOfHydrostaticWaterIsAWaterTable) {
  // A plane water table: its heads and pressures are linear, and so exact in either interpolation.
  const auto level = [](double x) { return 5.2 - 0.3 * x; };
  const nlohmann::json one =
      run(write_slope(R"("lem", "fem", "bounds")",
                      R"(initial = { pore_pressure = "water_table", water_table = [[0, 5.2], [16, 0.4]] })"));
  for (const auto& [kind, quantity] : {std::pair{"linear", "pressure"}, {"thin_plate", "head"}}) {
    const bool is_head = quantity == std::string("head");
    write_table(is_head ? "head [m]" : "pressure [kPa]",
                [&](double x, double y) { return is_head ? level(x) : gamma_w * (level(x) - y) / 1e3; });
    const nlohmann::json other = run(write_slope(
        R"("lem", "fem", "bounds")",
        fmt::format(
            R"(initial = {{ pore_pressure = "grid", pressure_grid = {{ file = "grid.csv", quantity = "{}", interpolation = "{}" }} }})",
            quantity, kind)));
    // LEM weighs soil above and below a traced water table.
    EXPECT_NEAR(other.at("lem").at("critical")[0].at("factor").get<double>() /
                    one.at("lem").at("critical")[0].at("factor").get<double>(),
                1, 2e-3)
        << kind << quantity;
    EXPECT_NEAR(other.at("fem").at("runs")[0].at("factor").get<double>(),
                one.at("fem").at("runs")[0].at("factor").get<double>(), 1e-3);
    // The table is a line of the mesh of limit analysis and a grid is none: the meshes differ, and both intervals hold.
    EXPECT_LT(other.at("bounds").at("lower").get<double>(), one.at("bounds").at("upper").get<double>());
    EXPECT_LT(one.at("bounds").at("lower").get<double>(), other.at("bounds").at("upper").get<double>());
  }
}

TEST_F(WaterByLayer, AGridOfOneRatioIsThatOfTheMaterials) {
  std::string text = write_slope(R"("lem", "fem", "bounds")", "");
  for (std::size_t at = 0; (at = text.find("model =", at)) != std::string::npos; at += 40)
    text.insert(at, "pore_pressure_ratio = 0.3\n");
  const nlohmann::json one = run(text);
  write_table("r_u", [](double, double) { return 0.3; });
  const nlohmann::json other = run(
      write_slope(R"("lem", "fem", "bounds")",
                  R"(initial = { pore_pressure = "grid", pressure_grid = { file = "grid.csv", quantity = "r_u" } })"));
  EXPECT_NEAR(other.at("lem").at("critical")[0].at("factor").get<double>(),
              one.at("lem").at("critical")[0].at("factor").get<double>(), 1e-9);
  EXPECT_NEAR(other.at("fem").at("runs")[0].at("factor").get<double>(),
              one.at("fem").at("runs")[0].at("factor").get<double>(), 1e-9);
  EXPECT_NEAR(other.at("bounds").at("upper").get<double>(), one.at("bounds").at("upper").get<double>(), 1e-6);
}

/// A cut in clay (total stresses) with a vertical step, which is partly filled by `liquid`.
std::string write_cut(const std::string& liquid) {
  return R"(
analysis.methods = ["lem", "fem", "bounds"]
mesh.size = 0.7
bounds = { gap = 0.1, size = 0.7 }
lem = { methods = ["spencer"], referee = false, entry_exit = { entries = 14, exits = 14, depths = 8 } }
fem = { meshes = 1, flow = "as_given" }
geometry.polygon = [{ name = "clay", points = [[0, 0], [16, 0], [16, 5], [13, 3], [10, 3], [10, 5], [7, 8], [0, 8]] }]
regions.clay = "clay"
materials.clay = { model = "tresca", unit_weight = 18, undrained_strength = 25, young_modulus = 3e4, poisson_ratio = 0.49 }
)" + liquid;
}

TEST_F(WaterByLayer, SlurryOfWaterIsAPond) {
  const nlohmann::json pond = run(write_cut(R"(initial = { pore_pressure = "water_table", water_table = [[0, 6]] })")),
                       slurry = run(
                           write_cut(R"(slurry = [{ name = "water", x = [7, 16], level = 6, unit_weight = 9.81 }])")),
                       heavy =
                           run(write_cut(R"(slurry = [{ name = "mud", x = [7, 16], level = 6, unit_weight = 12 }])"));
  const auto list = [](const nlohmann::json& summary) {
    return std::array{summary.at("lem").at("critical")[0].at("factor").get<double>(),
                      summary.at("fem").at("runs")[0].at("factor").get<double>(),
                      summary.at("bounds").at("lower").get<double>(), summary.at("bounds").at("upper").get<double>()};
  };
  const auto one = list(pond), other = list(slurry), more = list(heavy);
  // The slices are cut at other places.
  EXPECT_NEAR(other[0], one[0], 2e-4);
  for (std::size_t i = 1; i < one.size(); ++i) EXPECT_NEAR(other[i], one[i], 1e-5) << i;
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_GT(more[i], one[i]) << i;
}

}  // namespace
}  // namespace talus
