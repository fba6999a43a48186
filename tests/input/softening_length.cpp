// SPDX-License-Identifier: MIT
// mesh.softening_length is rejected if no soil softens or if it is not a valid length.

#include "rooted_slope.hpp"

namespace talus::input {
namespace {

TEST(SofteningLength, NeedsASoilThatSoftens) {
  expect_fault("[mesh]\n", "[mesh]\nsoftening_length = @@0.3\n",
               "no soil of the case softens; those of model \"softening_mohr_coulomb\", "
               "\"softening_hoek_brown\", \"modified_cam_clay\" or \"rooted_cam_clay\" do");
  EXPECT_TRUE(find_faults(change(rooted_slope, "[mesh]\n", "[mesh]\nsoftening_length = 0.3\n")).empty());
  expect_root_fault("[mesh]\n", "[mesh]\nsoftening_length = @@0\n", "it must be above 0");
}

}  // namespace
}  // namespace talus::input
