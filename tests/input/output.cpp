// SPDX-License-Identifier: MIT
// [output] and [study]: sections, the clock, names of variants.

#include "slope.hpp"

namespace talus::input {
namespace {

TEST(Output, ChecksTheStageOfItsClock) {
  expect_fault(slope + "[output]\ncount_from = @@\"storm\"\n", "there is no stage 'storm'");
}

TEST(Output, SectionsHaveALengthAndTheNameOfAFile) {
  const std::string section = slope + "[[output.section]]\nfrom = [1, 0]\n";
  expect_fault(section + "name = \"A\"\nto = @@[1, 0]\n", "are the same point");
  expect_fault(section + "name = @@\"../A\"\nto = [1, 5]\n", "must not be empty, begin with a point");
  expect_fault(section + "name = \"A\"\nto = [1, 5]\n[[output.section]]\nname = @@\"A\"\nfrom = [2, 0]\nto = [2, 5]\n",
               "two sections named 'A'");
}

TEST(Output, AnOnsetIsALengthOrARatio) {
  expect_fault(slope + "[output]\nonset_displacement = \"5 cm\"\nonset_ratio = @@0.02\n",
               "has no meaning where 'onset_displacement' is given");
}

}  // namespace
}  // namespace talus::input
