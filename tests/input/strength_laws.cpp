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
}

TEST(StrengthLaws, TablesThatAreNoEnvelope) {
  expect_one_fault(write_table("[0, 50, 40]", "[0, 20, 30]"), "must rise: 40 kPa follows 50 kPa");
  expect_one_fault(write_table("[0, 50, 100]", "[0, 20, 10]"), "must not fall: 10 kPa follows 20 kPa");
  expect_one_fault(write_table("[0, 50, 100]", "[0, 20, 60]"), "becomes steeper at 50 kPa");
  expect_one_fault(write_table("[0]", "[0]"), "needs at least two pairs");
  expect_one_fault(with_soil("model = \"anisotropic\"\nbase_inclinations = [10, -10]\ninclined_cohesions = [1, "
                             "2]\ninclined_frictions = [20, 20]\n"),
                   "'base_inclinations' of material 'soil' must rise");
  expect_one_fault(with_soil("model = \"bedding\"\ncohesion = 8\nfriction_angle = 30\nbedding_angle = "
                             "20\nbedding_cohesion = 1\nbedding_friction = 10\nbedding_range = 9\nbedding_transition = "
                             "4\n"),
                   "it must not be below 'bedding_range'");
}

TEST(StrengthLaws, MethodsThatCannotCarryThem) {
  const std::string with_bounds = "[\"lem\", \"bounds\"]";
  const auto with_boundary = [](const std::string& text) {
    return text + "[[boundary]]\non = \"bottom\"\nfix = \"full\"\n";
  };
  expect_one_fault(with_boundary(change(with_soil(rock), "[\"lem\"]", with_bounds)), "is curved; take \"bounds\" out");
  expect_one_fault(with_boundary(change(
                       with_soil("model = \"adp\"\nundrained_strength = 40\ndirect_ratio = 0.7\npassive_ratio = 0.4\n"),
                       "[\"lem\"]", with_bounds)),
                   "serves LEM only; take \"bounds\" out");
  expect_one_fault(with_soil(rock) + "[partial_factors]\nset = \"DA1-2\"\n",
                   "material 'soil' (Hoek–Brown) does not have");
}

TEST(StrengthLaws, AnUndrainedEnvelopeNeedsMohrCoulomb) {
  expect_one_fault(with_soil("model = \"bedding\"\ncohesion = 8\nfriction_angle = 30\nbedding_angle = "
                             "20\nbedding_cohesion = 1\nbedding_friction = 10\n[materials.soil.undrained_envelope]\n"
                             "cohesion = 5\nfriction_angle = 15\n"),
                   "no friction angle in effective stresses");
}

}  // namespace
}  // namespace talus::input
