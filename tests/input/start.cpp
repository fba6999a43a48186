// SPDX-License-Identifier: MIT
// [initial] result: input that is rejected before the calculation.

#include <filesystem>
#include <fstream>

#include "slope.hpp"
#include "support/scratch.hpp"
#include "wet_slope.hpp"

namespace talus::input {
namespace {

namespace fs = std::filesystem;

/// A folder with an end state (whose contents nobody reads here), gone at the end.
class StartFromAResult : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "old");
    std::ofstream(folder_ / "old" / "end_state.h5") << "x";
    fs::create_directories(folder_ / "unfinished");
  }

  std::string start(const std::string& keys) const { return slope + "\n[initial]\n" + keys; }
  std::string good() const { return "result = \"" + (folder_ / "old").string() + "\"\n"; }

  const fs::path folder_ = support::make_scratch("start");
};

TEST_F(StartFromAResult, IsTakenWithItsPathRelativeToTheCase) {
  const LoadedCase absolute = read_case_text(start(good()), "case.toml");
  EXPECT_EQ(absolute.data.initial.result_folder, (folder_ / "old").string());
  for (const std::vector<Override>& overrides : {std::vector<Override>{}, {{"initial.result", "old"}}}) {
    const LoadedCase relative = read_case_text(start("result = \"../" + folder_.filename().string() + "/old\"\n"),
                                               (folder_ / "case.toml").string(), overrides);
    EXPECT_EQ(relative.data.initial.result_folder, (folder_ / "old").string());
    EXPECT_EQ(relative.echo.get()["initial"]["result"]["value"], relative.data.initial.result) << "as it was given";
    EXPECT_FALSE(relative.echo.get()["initial"].contains("stress"));
    EXPECT_EQ(relative.data.strength_reduction.frozen.meshes, 1);
  }
}

TEST_F(StartFromAResult, NeedsAFinishedOne) {
  expect_fault(start("result = @@\"no/such\""), "the folder of results 'no/such' does not exist");
  expect_fault(start("result = @@\"" + (folder_ / "unfinished").string() + "\""),
               "/unfinished': was its run finished, and by this version?");
  expect_fault(start("result = @@\"" + (folder_ / "old" / "end_state.h5").string() + "\""),
               "is a file; 'result' names a folder of results");
}

TEST_F(StartFromAResult, NeedsNoOtherInitialState) {
  expect_fault(start(good() + "stress = @@\"k0\""), "'stress' in [initial] has no meaning where 'result' is given");
  expect_fault(start(good() + "pore_pressure = @@\"seepage\""),
               "'pore_pressure' in [initial] has no meaning where 'result' is given");
  expect_fault(start(good() + "velocity = @@{soil = [1, 0]}"),
               "'velocity' in [initial] has no meaning where 'result' is given");
  expect_fault(start(good() + "[strength_reduction.frozen]\nmeshes = @@2"),
               "'meshes' is 2, but the mesh of the result that the case starts from cannot be halved");
  expect_fault(change(start(good()), "duration = 10", "duration = 10\ngravity_ramp = @@1"),
               "'gravity_ramp' has no meaning in the first stage of a case that starts from a result");
  EXPECT_TRUE(find_faults(change(start(good()), "duration = \"3 s\"", "duration = 3\ngravity_ramp = 1")).empty());
}

TEST_F(StartFromAResult, IsCheckedForEveryVariantOfAStudy) {
  const std::string study = start(good()) + "[[study.vary]]\nkey = \"initial.result\"\nvalues = [\"";
  EXPECT_TRUE(find_faults(study + (folder_ / "old").string() + "\"]").empty());
  expect_fault(study + (folder_ / "old").string() + "\", @@\"no/such\"]",
               "the folder of results 'no/such' does not exist");
}

}  // namespace
}  // namespace talus::input
