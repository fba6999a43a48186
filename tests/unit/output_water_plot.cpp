// SPDX-License-Identifier: MIT
// Soil-water curves: drawn and tabulated values equal closed forms, and the axes show the whole range of change.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "output/plots/water_plot.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace {

namespace fs = std::filesystem;
using namespace talus;

input::Material make_loam() {
  input::Material loam;
  loam.water.retention = input::RetentionCurve::van_genuchten;
  loam.water.minimum_saturation = 0.1;
  loam.water.maximum_saturation = 1;
  loam.water.reference_pressure = 5e3;
  loam.water.lambda = 0.5;
  loam.water.conductivity = 2e-6;
  loam.water.relative_conductivity = input::ConductivityCurve::mualem;
  loam.water.measure = input::SaturationShare::effective;
  return loam;
}

input::Case make_case(const input::Material& material) {
  input::Case data;
  data.title = "A slope_with 'odd' {name}";
  data.materials["loam"] = material;
  data.materials["bedrock"] = {};  // dry: not drawn
  return data;
}

/// Sample of `curve` nearest to a suction [Pa] that is a whole power of ten.
double at(const output::WaterCurves& soil, const std::vector<double>& curve, double suction) {
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (std::abs(soil.suction[i] / suction - 1) < 1e-9) return curve[i];
  ADD_FAILURE() << "no sample at " << suction;
  return 0;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream text(line);
  for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
  return fields;
}

TEST(SoilWaterCurves, AreVanGenuchtensOwnFormInSuction) {
  // With λ = m = 1/2, n = 2: S_e = (1 + x²)^-1/2 and k_r = √S_e [1 - x (1 + x²)^-1/2]², x = s/p_ref.
  const std::vector<output::WaterCurves> soils = output::sample_water_curves(make_case(make_loam()));
  ASSERT_EQ(soils.size(), 1u);
  EXPECT_EQ(soils[0].material, "loam");
  for (const double s : {1e2, 1e3, 1e4, 1e5}) {
    const double x = s / 5e3, effective = 1 / std::sqrt(1 + x * x);
    EXPECT_NEAR(at(soils[0], soils[0].saturation, s), 0.1 + 0.9 * effective, 1e-12);
    EXPECT_NEAR(at(soils[0], soils[0].slope, s), -0.9 * x / 5e3 * std::pow(effective, 3), 1e-15);
    const double relative = std::sqrt(effective) * std::pow(1 - x * effective, 2);
    EXPECT_NEAR(at(soils[0], soils[0].relative, s) / relative, 1, 1e-9);
  }
  EXPECT_NE(soils[0].retention.find("p_ref = 5 kPa, λ = 0.5, S from 1 to 0.1"), std::string::npos);
  EXPECT_NE(soils[0].conductivity.find("Mualem in S_e, λ = 0.5, k = 2e-6 m/s"), std::string::npos);
}

TEST(SoilWaterCurves, OfAPermeabilityHaveTheConductivityOfTheWater) {
  input::Material loam = make_loam();
  loam.water.conductivity.reset();
  loam.water.permeability = 1e-12;
  const output::WaterCurves soil = output::sample_water_curves(make_case(loam)).at(0);
  EXPECT_NEAR(soil.saturated_conductivity, 1000 * 9.81 * 1e-12 / 1.002e-3, 1e-12);  // ρ g κ/μ (3.2)
}

TEST(SoilWaterCurves, HaveAnAxisWithAllPairsOfTheTables) {
  input::Material loam = make_loam();
  loam.water.retention = input::RetentionCurve::table;
  loam.water.retention_table = {{0, 1}, {3, 0.9}, {2e4, 0.5}, {6e7, 0.1}};
  const output::WaterCurves soil = output::sample_water_curves(make_case(loam)).at(0);
  EXPECT_NEAR(soil.suction.front(), 1, 1e-12);
  EXPECT_NEAR(soil.suction.back() / 1e8, 1, 1e-12);
}

TEST(SoilWaterCurves, LeaveOutDecadesInWhichNothingHappens) {
  input::Material loam = make_loam();
  loam.water.retention = input::RetentionCurve::linear;
  loam.water.dry_suction = 50e3;  // S falls by 0.9/50 per kPa: visible from 1 kPa on, and dry at 50 kPa
  loam.water.relative_conductivity = input::ConductivityCurve::constant;
  const output::WaterCurves soil = output::sample_water_curves(make_case(loam)).at(0);
  EXPECT_NEAR(soil.suction.front() / 1e2, 1, 1e-12);
  EXPECT_NEAR(soil.suction.back() / 1e5, 1, 1e-12);
  EXPECT_EQ(soil.saturation.back(), 0.1);
}

TEST(SoilWaterCurves, AreTabledInEngineeringUnits) {
  input::Material loam = make_loam();
  loam.water.chi = input::BishopChi::khalili_khabbaz;
  loam.water.chi_air_entry = 2e3;
  input::Case data = make_case(loam);
  data.materials["silt, grey"] = data.materials.at("loam");
  std::istringstream text(output::make_water_table(output::sample_water_curves(data)));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line,
            "material,suction [kPa],saturation [-],saturation_slope [1/kPa],bishop_chi [-],relative_conductivity [-],"
            "conductivity [m/s]");
  bool found = false, quoted = false;
  while (std::getline(text, line)) {
    quoted = quoted || line.starts_with("\"silt, grey\",");
    const std::vector<std::string> row = split(line);
    if (row[0] != "loam" || std::abs(std::stod(row[1]) - 10) > 1e-9) continue;
    found = true;
    EXPECT_NEAR(std::stod(row[2]), 0.1 + 0.9 / std::sqrt(5.0), 1e-12);
    EXPECT_NEAR(std::stod(row[3]), -0.9 * 2 / 5 * std::pow(5.0, -1.5), 1e-12);
    EXPECT_NEAR(std::stod(row[4]), std::pow(5.0, -0.55), 1e-12);
    EXPECT_NEAR(std::stod(row[6]), 2e-6 * std::stod(row[5]), 1e-18);
  }
  EXPECT_TRUE(found);
  EXPECT_TRUE(quoted);
}

class WaterPictures : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("gnuplot --version > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "gnuplot is not installed: no picture was drawn";
  }
  std::string read(const std::string& name) const { return support::read_text(folder_ / name); }
  const fs::path folder_ = support::make_scratch("water");
};

TEST_F(WaterPictures, ShowEverySoilWithItsLaws) {
  input::Case data = make_case(make_loam());
  input::Material sand = make_loam();
  sand.water.retention = input::RetentionCurve::table;
  sand.water.retention_table = {{0, 1}, {1e3, 0.9}, {2e4, 0.1}};
  sand.water.relative_conductivity = input::ConductivityCurve::hillel;
  sand.water.exponent = 3;
  data.materials["sand_2"] = sand;
  output::draw(output::WaterPlot{data.title, output::sample_water_curves(data)}, folder_ / "water.svg");
  const std::string svg = read("water.svg");
  for (const char* text :
       {"suction [kPa]", "degree of saturation S [-]", "conductivity k [m/s]", "loam", "sand_2", "van Genuchten",
        "table of 3 pairs", "pairs of the table", "Hillel in S_e, r = 3", "A slope_with"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_EQ(svg.find("bedrock"), std::string::npos);
  output::draw(output::WaterPlot{data.title, output::sample_water_curves(data)}, folder_ / "water.png");
  EXPECT_EQ(read("water.png").substr(1, 3), "PNG");
}

TEST_F(WaterPictures, HaveAxesThatHoldTheConductivityCurve) {
  for (const double k : {1e-9, 3e-4, 1.0}) {
    input::Material loam = make_loam();
    loam.water.conductivity = k;
    loam.water.relative_conductivity = input::ConductivityCurve::hillel;  // falls to S_e^3 of S_e = 5e-4 at 10 MPa
    loam.water.exponent = 3;
    const std::vector<output::WaterCurves> soils = output::sample_water_curves(make_case(loam));
    output::draw(output::WaterPlot{"", soils}, folder_ / "water.svg");
    const std::string script = read("water.gp");
    const std::size_t begin = script.find("set yrange [1e");
    ASSERT_NE(begin, std::string::npos);
    const double low = std::stod(script.substr(begin + 12)),
                 high = std::stod(script.substr(script.find(':', begin) + 1));
    EXPECT_LT(low, k * soils[0].relative.back());
    EXPECT_GT(low, 1e-2 * k * soils[0].relative.back());
    EXPECT_GT(high, k);
    EXPECT_LE(high, 20 * k);
  }
}

TEST_F(WaterPictures, OfADryCaseAreOneSentence) {
  EXPECT_TRUE(output::sample_water_curves(make_case({})).empty());
  const std::string command = "cd '" + folder_.string() + "' && '" + TALUS_PROGRAM + "' plot '" + TALUS_SOURCE_DIR +
                              "/examples/dry_slope/case.toml' 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 2);
  EXPECT_NE(text.find("no material of it has pore water, a table [materials.NAME.water]"), std::string::npos) << text;
}

}  // namespace
