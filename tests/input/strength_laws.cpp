// SPDX-License-Identifier: MIT
// Messages on strength laws: one sentence for each fault, and refusals of methods that cannot carry a law.

#include <gtest/gtest.h>

#include "methods_slope.hpp"

namespace talus::input {
namespace {

/// The slope of methods_slope.hpp with another soil.
std::string with_soil(const std::string& keys) {
  const std::string plain = "model = \"mohr_coulomb\"\nunit_weight = 20\ncohesion = 3\nfriction_angle = 19.6\n";
  return change(slices_alone, plain, "unit_weight = 20\n" + keys);
}

const std::string rock = "model = \"hoek_brown\"\nintact_strength = 30\ngsi = 40\nintact_constant = 10\n";
const std::string clay = "model = \"shansep\"\nstrength_ratio = 0.22\nstrength_exponent = 0.8\n";

std::string write_table(const std::string& normal, const std::string& shear) {
  return with_soil("model = \"strength_table\"\nnormal_stresses = " + normal + "\nshear_strengths = " + shear + "\n");
}

TEST(StrengthLaws, AreSoundInLem) {
  for (const std::string& soil :
       {rock, clay + "ocr = 2\n", clay + "profile_depths = [0, 5]\nprofile_ocr = [3, 1]\n",
        std::string("model = \"tresca\"\nprofile_levels = [35, 20]\nprofile_strengths = [20, 50]\n"),
        std::string("model = \"adp\"\nundrained_strength = 40\ndirect_ratio = 0.7\npassive_ratio = 0.4\n"),
        std::string("model = \"power_curve\"\npower_factor = 1.4\npower_exponent = 0.8\n"),
        std::string("model = \"barton_bandis\"\njoint_roughness = 8\njoint_strength = 50\nresidual_friction = 28\n")})
    EXPECT_TRUE(find_faults(with_soil(soil)).empty()) << soil;
}

TEST(StrengthLaws, NumbersOutOfRange) {
  expect_one_fault(with_soil(change(rock, "gsi = 40", "gsi = 130")),
                   "'gsi' is 130; it must be above 0 and at most 100");
  expect_one_fault(with_soil(rock + "disturbance = 2\n"), "'disturbance' is 2; it must be at least 0 and at most 1");
  expect_one_fault(with_soil(clay + "ocr = 0.5\n"), "'ocr' is 0.5; it must be at least 1");
  expect_one_fault(with_soil("model = \"power_curve\"\npower_factor = 1.4\npower_exponent = 1.2\n"), "at most 1");
}

TEST(StrengthLaws, ProfilesThatDoNotFit) {
  expect_one_fault(with_soil(clay), "needs one of 'ocr', 'profile_ocr' and 'profile_preconsolidation'");
  expect_one_fault(with_soil(clay + "ocr = 2\nprofile_depths = [0, 5]\nprofile_ocr = [2, 1]\n"), "needs only one of");
  expect_one_fault(with_soil(clay + "profile_depths = [0, 5]\nprofile_ocr = [2]\n"), "they belong together");
  expect_one_fault(with_soil(clay + "profile_ocr = [2]\n"), "needs its places");
  expect_one_fault(with_soil(clay + "profile_levels = [5, 8]\nprofile_ocr = [2, 1]\n"), "must fall");
  expect_one_fault(with_soil(clay + "profile_depths = [5, 2]\nprofile_ocr = [2, 1]\n"), "must rise");
  expect_one_fault(with_soil(clay + "profile_depths = [0, 5]\nprofile_levels = [8, 3]\nprofile_ocr = [2, 1]\n"),
                   "has 'profile_levels' and 'profile_depths'; give one of them");
  expect_one_fault(with_soil("model = \"tresca\"\nundrained_strength = 20\nprofile_depths = [0, 5]\n"),
                   "has a profile without strengths");
  expect_one_fault(with_soil("model = \"tresca\"\nundrained_strength = 20\nundrained_gradient = 2\n"),
                   "needs 'undrained_level'");
}

TEST(StrengthLaws, TablesThatAreNoEnvelope) {
  expect_one_fault(write_table("[0, 50, 40]", "[0, 20, 30]"), "must rise: 40 kPa follows 50 kPa");
  expect_one_fault(write_table("[0, 50, 100]", "[0, 20, 10]"), "must not fall: 10 kPa follows 20 kPa");
  expect_one_fault(write_table("[0, 50, 100]", "[0, 20, 60]"), "becomes steeper at 50 kPa");
  expect_one_fault(write_table("[0]", "[0]"), "needs at least two pairs");
  expect_one_fault(write_table("[50, 100]", "[10, 40]"), "give a strength of -20 kPa at σ' = 0");
  expect_one_fault(with_soil("model = \"anisotropic\"\nbase_inclinations = [10, -10]\ninclined_cohesions = [1, "
                             "2]\ninclined_frictions = [20, 20]\n"),
                   "'base_inclinations' of material 'soil' must rise");
  expect_one_fault(with_soil("model = \"bedding\"\ncohesion = 8\nfriction_angle = 30\nbedding_angle = "
                             "20\nbedding_cohesion = 1\nbedding_friction = 10\nbedding_range = 9\nbedding_transition = "
                             "4\n"),
                   "it must not be below 'bedding_range'");
  EXPECT_TRUE(find_faults(with_soil("model = \"bedding\"\ncohesion = 8\nfriction_angle = 30\nbedding_angle = "
                                    "20\nbedding_cohesion = 1\nbedding_friction = 10\n"))
                  .empty());
}

TEST(StrengthLaws, MethodsThatCannotCarryThem) {
  const std::string with_bounds = "[\"lem\", \"bounds\"]";
  const auto with_boundary = [](const std::string& text) {
    return text + "[[boundary]]\non = \"bottom\"\nfix = \"full\"\n";
  };
  EXPECT_TRUE(find_faults(with_boundary(change(with_soil(rock), "[\"lem\"]", with_bounds))).empty());
  expect_one_fault(with_boundary(change(with_soil(rock), "[\"lem\"]", with_bounds)) + "[bounds]\nflow = \"davis\"\n",
                   "(Hoek–Brown) has none; take 'davis' out");
  expect_one_fault(with_boundary(change(
                       with_soil("model = \"adp\"\nundrained_strength = 40\ndirect_ratio = 0.7\npassive_ratio = 0.4\n"),
                       "[\"lem\"]", with_bounds)),
                   "serves LEM only; take \"bounds\" out");
  expect_one_fault(with_soil(rock) + "[partial_factors]\nset = \"DA1-2\"\n",
                   "material 'soil' (Hoek–Brown) does not have");
}

TEST(StrengthLaws, AnUndrainedEnvelopeNeedsMohrCoulomb) {
  expect_one_fault(
      with_soil("model = \"bedding\"\nbedding_range = 0\ncohesion = 8\nfriction_angle = 30\nbedding_angle = "
                "20\nbedding_cohesion = 1\nbedding_friction = 10\n[materials.soil.undrained_envelope]\n"
                "cohesion = 5\nfriction_angle = 15\n"),
      "no friction angle in effective stresses");
}

const std::string soft =
    "model = \"softening_mohr_coulomb\"\ncohesion = 20\nfriction_angle = 25\nresidual_cohesion = "
    "2\nresidual_friction_angle = 14\nlimit_strength = \"residual\"\n";
const std::string cone = "model = \"drucker_prager\"\ncohesion = 5\nfriction_angle = 30\ncone = \"plane_strain\"\n";

/// The same with FEM and its block.
std::string with_fem(const std::string& soil, const std::string& fem) {
  return change(with_soil(soil), "[\"lem\"]", "[\"lem\", \"fem\"]") + "[fem]\nsize = 2\n" + fem;
}

TEST(StrengthLaws, ProgressiveFailureNeedsSoilThatSoftens) {
  const std::string progressive = "softening = \"progressive\"\n", falls = soft + stiffness + "softening_end = 0.1\n";
  EXPECT_TRUE(find_faults(with_fem(falls, progressive)).empty());
  EXPECT_TRUE(find_faults(with_fem(soft + stiffness, "")).empty()) << "all soil at `limit_strength`";
  expect_one_fault(with_fem(soft + stiffness, progressive), "'softening_end' of material 'soil' is missing");
  expect_one_fault(
      with_fem("model = \"mohr_coulomb\"\ncohesion = 3\nfriction_angle = 19.6\n" + stiffness, progressive),
      "no soil of the case softens; those of model \"softening_mohr_coulomb\" or \"softening_hoek_brown\"");
  expect_one_fault(with_fem(falls, progressive + "davis = \"a\"\n"), "those of soil that softens fall");
  expect_one_fault(with_fem(falls, "softening = \"slow\"\n"), "softening");
}

TEST(StrengthLaws, SofteningConesAndSoundings) {
  for (const std::string& soil :
       {soft, cone,
        "model = \"softening_hoek_brown\"\nresidual_gsi = 20\nlimit_strength = \"peak\"\n" +
            rock.substr(rock.find("intact_strength")),
        std::string("model = \"tresca\"\nprofile_x = [0, 40, 90]\nprofile_levels = [35, 20]\nprofile_strengths = "
                    "[20, 50, 25, 60, 22, 55]\n")})
    EXPECT_TRUE(find_faults(with_soil(soil)).empty()) << soil;
  expect_one_fault(with_soil(change(soft, "residual_cohesion = 2", "residual_cohesion = 30")),
                   "'residual_cohesion' is 30 kPa; it must not be above the cohesion, 20 kPa");
  expect_one_fault(with_soil(change(soft, "angle = 14", "angle = 28")),
                   "it must not be above the friction angle, 25 deg");
  expect_one_fault(with_soil(soft + "softening_start = 0.3\nsoftening_end = 0.2\n"),
                   "'softening_end' is 0.2; it must be above 'softening_start', 0.3");
  expect_one_fault(with_soil(change(soft, "limit_strength = \"residual\"\n", "")), "limit_strength");
  expect_one_fault(with_soil(change(soft, "\"residual\"", "\"mean\"")), "limit_strength");
  expect_one_fault(with_soil(change(cone, "\"plane_strain\"", "\"outer\"")), "cone");
  expect_one_fault(with_soil(change(cone, "\"plane_strain\"", "\"compression\"")),
                   "LEM and limit analysis take cone = \"plane_strain\" only");
  expect_one_fault(with_soil("model = \"softening_hoek_brown\"\nresidual_gsi = 60\nlimit_strength = \"peak\"\n" +
                             rock.substr(rock.find("intact_strength"))),
                   "'residual_gsi' is 60; it must not be above 'gsi', 40");
  const std::string soundings = "model = \"tresca\"\nprofile_levels = [35, 20]\nprofile_strengths = [20, 50, 25, 60]\n";
  expect_one_fault(with_soil(soundings + "profile_x = [40, 0]\n"), "'profile_x' of material 'soil' must rise");
  expect_one_fault(with_soil(soundings + "profile_x = [0, 40, 90]\n"),
                   "has 4 values and 'profile_levels' has 2 at each of 3 places in 'profile_x'");
}

TEST(StrengthLaws, SoilThatIsNotReduced) {
  EXPECT_TRUE(find_faults(change(slices_alone, "cohesion = 3\n", "cohesion = 3\n") +
                          "[materials.wall]\nmodel = \"mohr_coulomb\"\nunit_weight = "
                          "24\ncohesion = 300\nfriction_angle = 40\nreduced = false\n")
                  .empty());
  expect_one_fault(with_soil("model = \"mohr_coulomb\"\ncohesion = 3\nfriction_angle = 19.6\nreduced = false\n"),
                   "not excluded by reduced = false");
}

TEST(StrengthLaws, DavisNeedsAnglesAndTrials) {
  const std::string boundary = "[[boundary]]\non = \"bottom\"\nfix = \"full\"\n";
  EXPECT_TRUE(find_faults(with_elements + "davis = \"b\"\n" + boundary).empty());
  expect_one_fault(with_elements + "davis = \"d\"\n" + boundary, "davis");
  expect_one_fault(with_elements + "davis = \"b\"\nflow = \"associated\"\n" + boundary,
                   "'davis' replaces the trials with ψ as given");
}

}  // namespace
}  // namespace talus::input
