// SPDX-License-Identifier: MIT
// Cam-clay and external models: rejected input and its messages.

#include <filesystem>
#include <fstream>

#include "rooted_slope.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

namespace fs = std::filesystem;

std::string at_soil(const std::string& text) {
  return change(text, "[materials.loess]", "@@[materials.loess]");
}

TEST(CamClay, SwellsLessThanItIsCompressed) {
  expect_root_fault("kappa = 0.04", "kappa = @@0.155",
                    "'kappa' is 0.155 and 'lambda' is 0.155; κ must be smaller than λ");
  expect_root_fault("kappa = 0.04", "kappa = @@0", "'kappa' is 0; it must be above 0");
}

TEST(CamClay, NeedsOneOfThePreconsolidations) {
  expect_fault(
      change(at_soil(change(rooted_slope, "preconsolidation_ratio = 3\n", "")), "equilibrium = \"gravity\"\n", ""),
      "material 'loess' is Cam-clay; give its 'preconsolidation', for example 125 (kPa), or its "
      "'preconsolidation_ratio'");
  expect_root_fault("preconsolidation_ratio = 3", "preconsolidation = 125\npreconsolidation_ratio = @@3",
                    "material 'loess' has both a preconsolidation and a preconsolidation_ratio");
  expect_root_fault("preconsolidation_ratio = 3", "preconsolidation_ratio = @@0.9", "it must be at least 1");
}

TEST(CamClay, HasNoYoungsModulusAndNoOtherStrength) {
  for (const char* key : {"young_modulus", "cohesion", "friction_angle", "tensile_strength"})
    expect_root_fault(
        "kappa = 0.04", "kappa = 0.04\n" + std::string(key) + " = @@1",
        "'" + std::string(key) + "' in [materials.loess] has a meaning only with model = \"mohr_coulomb\"");
  expect_fault(
      "cohesion = 2", "cohesion = 2\nlambda = @@0.1",
      "'lambda' in [materials.sand] has a meaning only with model = \"modified_cam_clay\" or \"rooted_cam_clay\"");
  expect_fault(
      at_soil(change(rooted_slope, "lambda = 0.155\n", "")),
      "missing key 'lambda' in [materials.loess], for example lambda = 0.089; model = \"rooted_cam_clay\" needs it");
}

TEST(CamClay, BareSoilAcceptsNoRootKeys) {
  const std::string bare = change(rooted_slope, "model = \"rooted_cam_clay\"", "model = \"modified_cam_clay\"");
  const std::string without = change(change(change(bare, "root_hardening = 0.4\n", ""), "root_strength = 0.18\n", ""),
                                     "[[roots]]\nground = \"face\"\ndepth = 0.5\ncontent = 0.94\n", "");
  EXPECT_TRUE(find_faults(without).empty());
  expect_fault(change(without, "kappa = 0.04", "kappa = 0.04\nroot_hardening = @@0.4"),
               "'root_hardening' in [materials.loess] has a meaning only with model = \"rooted_cam_clay\"");
}

TEST(RootBreakage, NeedsItsStart) {
  expect_root_fault("root_strength = 0.18", "root_strength = 0.18\nroot_residual_share = @@0.5",
                    "'root_residual_share' has no meaning without 'root_breaking_strain'");
  EXPECT_TRUE(find_faults(change(rooted_slope, "root_strength = 0.18",
                                 "root_strength = 0.18\nroot_breaking_strain = 0.3\nroot_residual_share = 0.5"))
                  .empty());
}

TEST(VoidRatio, ReplacesThePorosity) {
  expect_root_fault("void_ratio = 0.6", "void_ratio = 0.6\nporosity = @@0.4",
                    "'porosity' in [materials.loess] has no meaning where 'void_ratio' is given");
  expect_fault(at_soil(change(rooted_slope, "void_ratio = 0.6\n", "")),
               "missing key 'porosity' in [materials.loess], for example porosity = 0.2, or give 'void_ratio'");
  const Case data = read_case_text(change(slope, "porosity = 0.2", "void_ratio = 0.25"), "slope.toml").data;
  EXPECT_NEAR(data.materials.at("sand").porosity, 0.2, 1e-15) << "of any model";
}

TEST(VoidRatio, MayReplaceAPorosityOfTheResult) {
  const JsonTree before = read_case_text(slope, "slope.toml").echo;
  const auto start = [](const char* ratio) {
    return read_case_text(change(slope, "porosity = 0.2", "void_ratio = " + std::string(ratio)), "slope.toml");
  };
  EXPECT_NO_THROW(check_against_result(start("0.25"), before));
  try {
    check_against_result(start("0.3"), before);
    FAIL() << "soil of another mass was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'void_ratio' of material 'sand' is 0.3, but the masses are those of"),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("was given 0.25"), std::string::npos) << error.what();
  }
}

TEST(VoidRatio, OfCamClayIsAboveZero) {
  expect_root_fault("void_ratio = 0.6", "void_ratio = @@0", "material 'loess' has no pores, but the stiffness");
  EXPECT_TRUE(find_faults(change(slope, "porosity = 0.2", "void_ratio = 0")).empty()) << "dry sand may do without";
}

TEST(StrengthReduction, DividesTheStrengthOfEveryBuiltInModel) {
  const std::string reduction = "\n[analysis]\nkind = \"strength_reduction\"\n";
  EXPECT_TRUE(find_faults(rooted_slope + reduction).empty());
  EXPECT_TRUE(find_faults(with_cohesion("cohesion = 5\n") + reduction).empty());
  EXPECT_TRUE(find_faults(change(rooted_slope, "duration = 560", "duration = 560\nstrength_factor = 1.2")).empty());
  expect_root_fault("duration = 560", "duration = 560\ncohesion = @@100",
                    "'cohesion' needs a material with model = \"mohr_coulomb\", \"rooted_mohr_coulomb\", "
                    "\"softening_mohr_coulomb\", \"drucker_prager\" or \"bedding\"");
}

/// A slope of an external model, whose library exists (it is not opened here).
class ExternalSoil : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(library_) << "x"; }

  std::string with(const std::string& keys) const {
    const auto from = slope.find("[materials.sand]"), to = slope.find("[regions]");
    return slope.substr(0, from) + "[materials.sand]\nmodel = \"external\"\ngrain_density = 2500\nporosity = 0.2\n" +
           keys + "\n" + slope.substr(to);
  }
  std::string good(const std::string& more = "") const {
    return with("library = \"" + library_.string() + "\"\nconstrained_modulus = \"60 MPa\"\n" + more);
  }

  const fs::path library_ = support::make_scratch("umat") / "soil.so";
};

TEST_F(ExternalSoil, IsFoundBesideTheCase) {
  const std::string text = with("library = \"" + library_.filename().string() +
                                "\"\nconstrained_modulus = 6e4\nconstants = [45e6, 0.3]\nstates = 2\n"
                                "initial_states = [1e5]\n");
  const std::string file = (library_.parent_path() / "case.toml").string();
  const material::ExternalParameters external = read_case_text(text, file).data.materials.at("sand");
  EXPECT_EQ(external.library_file, library_.string());
  EXPECT_EQ(external.library, library_.filename().string());
  EXPECT_EQ(external.symbol, "umat_");
  EXPECT_EQ(external.constants, (std::vector<double>{45e6, 0.3}));
  EXPECT_EQ(external.states, 2);
  EXPECT_EQ(external.initial_states, (std::vector<double>{1e5}));
  EXPECT_EQ(external.constrained_modulus, 6e7);
}

TEST_F(ExternalSoil, NeedsItsLibraryAndStiffness) {
  expect_fault(with("library = @@\"none.so\"\nconstrained_modulus = 1\n"),
               "there is no library 'none.so'; its path is relative to the case file");
  expect_fault(
      change(with("library = \"" + library_.string() + "\"\n"), "[materials.sand]", "@@[materials.sand]"),
      "missing key 'constrained_modulus' in [materials.sand], for example constrained_modulus = 60000; model = "
      "\"external\" needs it");
  expect_fault(good("poisson_ratio = @@0.3\n"), "has a meaning only with model = \"mohr_coulomb\" or ");
}

TEST_F(ExternalSoil, HasNoMoreStatesThanItDeclares) {
  expect_fault(good("states = @@21\n"), "'states' is 21; it must be at least 0 and at most 20");
  expect_fault(good("states = 1\ninitial_states = @@[1, 2]\n"), "'initial_states' has 2 numbers, but 'states' is 1");
}

TEST_F(ExternalSoil, NeedsK0ForGeostaticStress) {
  expect_fault(good() + "\n[initial]\nstress = @@\"k0\"\n", "stress = \"k0\" needs 'k0' in [initial]");
  EXPECT_TRUE(find_faults(good() + "\n[initial]\nstress = \"k0\"\nk0 = 0.5\n").empty());
}

TEST_F(ExternalSoil, HasNoStrengthToReduce) {
  expect_fault(
      good() + "\n[analysis]\nkind = @@\"strength_reduction\"\n",
      "strength reduction needs a material with a strength: model = \"mohr_coulomb\", \"rooted_mohr_coulomb\", ");
  const std::string sand =
      slope.substr(slope.find("model = \"mohr"), slope.find("[regions]") - slope.find("model = \"mohr"));
  const std::string both = change(
      change(good(), "[regions]", "[materials.other]\n" + sand + "[regions]\nwall = \"other\""), "[[geometry.line]]",
      "[[geometry.polygon]]\nname = \"wall\"\npoints = [[1, 0], [2, 0], [2, 1]]\n\n[[geometry.line]]");
  EXPECT_TRUE(find_faults(both).empty());
  expect_fault(both + "\n[analysis]\nkind = @@\"strength_reduction\"\n",
               "strength reduction is not possible with material 'sand': which of the constants of an external model");
  expect_fault(change(both, "duration = \"3 s\"", "duration = \"3 s\"\nstrength_factor = @@1.2"),
               "'strength_factor' is not possible with material 'sand'");
}

}  // namespace
}  // namespace talus::input
