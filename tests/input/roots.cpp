// SPDX-License-Identifier: MIT
// Input of rooted soils and [[roots]]: units, per cent, ages, and values derived from other keys.

#include <cmath>

#include "rooted_slope.hpp"

namespace talus::input {
namespace {

constexpr double year = 31556925.9747;  // the tropical year of UDUNITS [s]

Case read_rooted(const std::string& text) {
  const auto faults = find_faults(text);
  EXPECT_TRUE(faults.empty()) << InputError(faults).what();
  return faults.empty() ? read_case_text(text, "slope.toml").data : Case();
}

TEST(RootedSlope, IsReadAsTable42HasIt) {
  const Case data = read_rooted(rooted_slope);
  const Material& loess = data.materials.at("loess");
  EXPECT_EQ(loess.model, material::model_of<material::RootedCamClay>);
  EXPECT_NEAR(loess.porosity, 0.375, 1e-15) << "e/(1+e)";
  EXPECT_NEAR(loess.density(), 2710 / 1.6, 1e-9);
  EXPECT_NEAR(loess.void_ratio(), 0.6, 1e-15);
  EXPECT_EQ(loess.compression, 0.155);
  EXPECT_EQ(loess.swelling, 0.04);
  EXPECT_EQ(loess.critical_state_slope, 0.827);
  EXPECT_EQ(loess.suction_hardening, 10);
  EXPECT_EQ(loess.preconsolidation_ratio, 3.0);
  EXPECT_FALSE(loess.preconsolidation);
  EXPECT_EQ(loess.smallest_pressure, 1000) << "1 kPa unless the case says otherwise";
  EXPECT_EQ(loess.hardening, 0.4);
  EXPECT_EQ(loess.strength, 0.18);
  EXPECT_FALSE(loess.activation);
  EXPECT_TRUE(std::isinf(loess.breaking_strain)) << "roots never break unless the case says so";
  EXPECT_EQ(loess.water.lambda, 0.288) << "not the λ of Cam-clay";
  ASSERT_EQ(data.roots.size(), 1u);
  EXPECT_EQ(data.roots[0].ground, "face");
  EXPECT_EQ(data.roots[0].content, 0.94);
  EXPECT_EQ(data.initial.equilibrium, "gravity");
}

TEST(RootContent, IsPerCentHoweverItIsWritten) {
  for (const char* text : {"0.88", "\"0.88 %\"", "\"8.8 g/kg\"", "\"0.0088 kg/kg\""}) {
    EXPECT_EQ(read_rooted(change(rooted_slope, "content = 0.94", "content = " + std::string(text))).roots[0].content,
              0.88)
        << text;
    const std::string soil = "root_strength = 0.18\nroot_content = " + std::string(text);
    EXPECT_EQ(read_rooted(change(rooted_slope, "root_strength = 0.18", soil)).materials.at("loess").root_content, 0.88);
  }
  const LoadedCase loaded = read_case_text(rooted_slope, "slope.toml");
  EXPECT_EQ(loaded.echo.get()["roots"][0]["content"],
            (nlohmann::json{{"value", 0.94}, {"unit", "%"}, {"given", true}}));
}

TEST(RootsKeys, HaveTheirUnits) {
  const Case data = read_rooted(with_roots(R"(profile = "table"
depth_table = [[0, 1], ["30 cm", 0.6], [0.5, 0]]
along = [["300 cm", 0], [4, 1]]
age = "18 months"
growth = [[0, 0], ["365 days", 0.2], [10, 1]]
felled = 2
decay = [[0, 1], [5, 0.1]]

[roots.transpiration]
rate = [["-90 days", 2], [0, "5 mm/day"]]
suctions = [1, 2, 30, "1.5 MPa"]
)"));
  const Roots& roots = data.roots[0];
  using Rows = std::vector<std::array<double, 2>>;
  EXPECT_EQ(roots.depth_table, (Rows{{0, 1}, {0.3, 0.6}, {0.5, 0}}));
  EXPECT_EQ(roots.along, (Rows{{3, 0}, {4, 1}}));
  EXPECT_NEAR(*roots.age, 1.5 * year, 1);
  ASSERT_EQ(roots.growth.size(), 3u);
  EXPECT_NEAR(roots.growth[1][0], 365 * 86400.0, 1e-3);
  EXPECT_NEAR(roots.growth[2][0], 10 * year, 1e-3);
  EXPECT_NEAR(*roots.felled, 2 * year, 1e-3);
  EXPECT_EQ(roots.decay[1][1], 0.1);
  const Transpiration& plants = *roots.transpiration;
  EXPECT_EQ(plants.rate.time, (std::vector<double>{-90 * 86400.0, 0}));
  EXPECT_NEAR(plants.rate.value[1], 5e-3 / 86400, 1e-15);
  EXPECT_EQ(plants.series, SeriesShape::linear);
  EXPECT_EQ(plants.suctions, (std::array<double, 4>{1e3, 2e3, 30e3, 1.5e6}));
}

TEST(RootBundle, IsReadWithItsClasses) {
  const Case data = read_rooted(with_cohesion(R"(
[roots.bundle]
model = "fibre_bundle"
diameters = [0.5, "2 mm"]
area_ratios = [2e-4, 4e-4]
strengths = [40, "15000 kPa"]
)"));
  const RootBundle& bundle = *data.roots[0].bundle;
  EXPECT_EQ(bundle.model, RootBundleModel::fibre_bundle);
  EXPECT_EQ(bundle.diameters, (std::vector<double>{5e-4, 2e-3}));
  EXPECT_EQ(bundle.area_ratios, (std::vector<double>{2e-4, 4e-4}));
  EXPECT_EQ(bundle.strengths, (std::vector<double>{40e6, 15e6}));
  EXPECT_EQ(bundle.orientation, 1.2);
  EXPECT_FALSE(data.roots[0].cohesion);
  EXPECT_EQ(*read_rooted(with_cohesion("cohesion = 5\n")).roots[0].cohesion, 5000);
}

TEST(RootBundle, OfWuAndWaldronDoesWithoutDiameters) {
  read_rooted(with_cohesion("[roots.bundle]\nmodel = \"wu_waldron\"\narea_ratios = [1e-3]\nstrengths = [20]\n"));
}

TEST(Roots, ThatOnlyTranspireNeedNoStrength) {
  const auto from = rooted_slope.find("[materials.loess]"), to = rooted_slope.find("[materials.loess.water]");
  const std::string elastic = rooted_slope.substr(0, from) +
                              "[materials.loess]\nmodel = \"linear_elastic\"\ngrain_density = 2710\nporosity = "
                              "0.3\nyoung_modulus = 1e4\npoisson_ratio = 0.3\n\n" +
                              rooted_slope.substr(to);
  const Case data = read_rooted(change(change(elastic, "content = 0.94\n", "[roots.transpiration]\nrate = 4\n"),
                                       "equilibrium = \"gravity\"\n", ""));
  EXPECT_NEAR(data.roots[0].transpiration->rate.value[0], 4e-3 / 86400, 1e-15);
}

TEST(Roots, OfTwoKindsAreInTwoBlocks) {
  const std::string two = change(with_cohesion("cohesion = 5\n"), "[initial]",
                                 "[[roots]]\nground = \"crest\"\ndepth = 1\nprofile = \"exponential\"\ndecay_depth = "
                                 "\"20 cm\"\ncohesion = 2\n\n[initial]");
  const Case data = read_rooted(two);
  ASSERT_EQ(data.roots.size(), 2u);
  EXPECT_EQ(data.roots[1].profile, RootProfile::exponential);
  EXPECT_NEAR(data.roots[1].decay_depth, 0.2, 1e-15);
  EXPECT_FALSE(data.roots[1].bundle || data.roots[1].transpiration);
}

TEST(Roots, AreNamedByTheirGroundInOverrides) {
  const LoadedCase loaded = read_case_text(rooted_slope, "slope.toml", {{"roots.face.content", "1.29"}});
  EXPECT_EQ(loaded.data.roots[0].content, 1.29);
}

TEST(Season, IsCountedInDays) {
  const Case data = read_rooted(change(rooted_slope, "equilibrium =", "season = 30\nequilibrium ="));
  EXPECT_EQ(data.initial.water.season, 30 * 86400.0);
}

TEST(Echo, OfRootsGivesTheCaseBack) {
  const LoadedCase loaded = read_case_text(with_roots("[roots.transpiration]\nrate = 4\n"), "slope.toml");
  const nlohmann::json& soil = loaded.echo.get()["materials"]["loess"];
  EXPECT_FALSE(soil.contains("porosity")) << "the void ratio was given, and both together would be refused";
  EXPECT_EQ(soil["void_ratio"]["value"], 0.6);
  EXPECT_FALSE(soil.contains("young_modulus"));
  EXPECT_FALSE(soil.contains("library"));
  EXPECT_FALSE(loaded.echo.get()["roots"][0].contains("bundle"));
  EXPECT_EQ(loaded.echo.get()["roots"][0]["transpiration"]["rate"]["value"], 4.0);
  EXPECT_TRUE(loaded.echo.get()["roots"][0]["age"]["value"].is_null());
}

}  // namespace
}  // namespace talus::input
