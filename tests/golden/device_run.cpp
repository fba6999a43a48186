// SPDX-License-Identifier: MIT
// A run on a device gives the results of one on the processor, and resumes from its checkpoints.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "golden/tested_device.hpp"
#include "input/read.hpp"
#include "mpm/solver/device_stepper.hpp"
#include "output/files/frames_reader.hpp"
#include "run/run_case.hpp"
#include "support/child.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

const std::string soil = support::write_slope(
    "bank", {"geometry.box=[[0, 0], [20, 8]]",
             "geometry.polygon.soil.points=[[0, 0], [20, 0], [20, 2], [14, 2], [6, 7], [0, 7]]", "mesh.size=0.8",
             "materials.silt.young_modulus=20 MPa", "materials.silt.cohesion=3", "materials.silt.friction_angle=22"});

/// A bank that slides. Without damping, whose sign of a velocity near zero is round-off.
const std::string bank = soil +
                         R"(
[[stage]]
name = "gravity"
duration = 3
damping = 0
cohesion = "100 kPa"
gravity_ramp = 0.5
[[stage]]
name = "slide"
duration = 1.5
damping = 0
strength_factor = 1.4
reset_displacement = true
[output]
frame_interval = 0.5
checkpoint_interval = 0.02
)";

/// A bank in the rain, beside a pool, with grass on it, that slides.
const std::string wet_bank = soil +
                             R"(
[materials.silt.water]
conductivity = "1e-3 m/s"
retention = "van_genuchten"
reference_pressure = "8 kPa"
lambda = 0.4
relative_conductivity = "mualem"
[water]
bulk_modulus = "2.2 GPa"
[[geometry.line]]
name = "ground"
points = [[0, 7], [6, 7], [10, 4.5]]
[[geometry.line]]
name = "shore"
points = [[10, 4.5], [14, 2], [20, 2]]
[[hydraulic]]
on = "ground"
condition = "rain"
rate = "2000 mm/h"
[[hydraulic]]
on = "shore"
condition = "total_head"
head = "3 m"
[[roots]]
ground = "ground"
depth = "1 m"
[roots.transpiration]
rate = "500 mm/h"
[initial]
pore_pressure = "water_table"
water_table = [[0, 3], [20, 3]]
[[stage]]
name = "gravity"
duration = 1
damping = 0
cohesion = "100 kPa"
gravity_ramp = 0.5
[[stage]]
name = "slide"
duration = 1
damping = 0
strength_factor = 1.6
reset_displacement = true
[output]
frame_interval = 0.5
checkpoint_interval = 0.02
)";

class DeviceRun : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(folder_ / "case.toml") << bank; }

  pid_t start(const std::string& result, const std::vector<std::string>& more) {
    std::vector<std::string> words{"talus", "run", (folder_ / "case.toml").string(), "-o", (folder_ / result).string(),
                                   "-q"};
    words.insert(words.end(), more.begin(), more.end());
    const pid_t child = fork();
    if (child == 0) {
      std::vector<char*> arguments;
      for (std::string& word : words) arguments.push_back(word.data());
      arguments.push_back(nullptr);
      execv(TALUS_PROGRAM, arguments.data());
      _exit(127);
    }
    return child;
  }
  static int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  /// Runs "there" on the device until its first checkpoint. On a busy machine it may end before it is killed: then it
  /// is run again.
  bool kill_on_the_device() {
    int end = 0;
    for (int attempt = 0; attempt < 20 && end == 0; ++attempt) {
      fs::remove_all(folder_ / "there");
      const pid_t child = start("there", {"--device", golden::find_tested_device()});
      support::wait_for_file(folder_ / "there" / "checkpoint.h5", child);
      kill(child, SIGKILL);
      end = wait_for(child);
    }
    return end == -SIGKILL;
  }

  nlohmann::json read_summary(const std::string& result) const {
    std::ifstream file(folder_ / result / "summary.json");
    return nlohmann::json::parse(file);
  }

  /// Positions of all points in all frames, to a share of the size of the bank: slides amplify round-off.
  void expect_close(const std::string& a, const std::string& b, double tolerance) const {
    const output::ResultsReader first(folder_ / a), second(folder_ / b);
    ASSERT_EQ(first.times().size(), second.times().size());
    for (int i = 0; i < first.size(); ++i) {
      const output::Frame p = first.read(i), q = second.read(i);
      ASSERT_EQ(p.ids, q.ids);
      for (std::size_t k = 0; k < p.positions.size(); ++k)
        EXPECT_NEAR(p.positions[k], q.positions[k], tolerance) << "frame " << i;
    }
  }

  const fs::path folder_ = support::make_scratch("device");
};

/// Returns the program's output and its exit code.
std::pair<std::string, int> tell(const std::string& arguments) {
  FILE* pipe = popen(("'" TALUS_PROGRAM "' " + arguments + " 2>&1").c_str(), "r");
  std::string said;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) said.push_back(static_cast<char>(c));
  return {said, WEXITSTATUS(pclose(pipe))};
}

TEST_F(DeviceRun, GivesTheResultsOfTheProcessor) {
  ASSERT_EQ(wait_for(start("here", {"--threads", "1"})), 0);
  ASSERT_EQ(wait_for(start("there", {"--device", golden::find_tested_device()})), 0);
  expect_close("here", "there", 1e-7);
  const std::string name = read_summary("there")["provenance"]["device"];
  EXPECT_TRUE(golden::tests_gpu() ? !name.empty() && name != "emulated" : name == "emulated") << name;
  EXPECT_EQ(read_summary("here")["provenance"]["device"], "");
  const auto work = [this](const char* result) {
    return read_summary(result)["budgets"]["external_work"].get<double>();
  };
  EXPECT_NEAR(work("here"), work("there"), 1e-7 * std::abs(work("here")));
}

TEST_F(DeviceRun, WaterAndRootsGiveTheResultsOfTheProcessor) {
  std::ofstream(folder_ / "case.toml") << wet_bank;
  ASSERT_EQ(wait_for(start("here", {"--threads", "1"})), 0);
  ASSERT_TRUE(kill_on_the_device()) << "the case must be long enough to be killed";
  ASSERT_EQ(wait_for(start("there", {"--resume", "--device", golden::find_tested_device()})), 0);
  expect_close("here", "there", 1e-7);
  EXPECT_EQ(read_summary("there")["messages"], read_summary("here")["messages"]);
  const nlohmann::json here = read_summary("here")["water"], there = read_summary("there")["water"];
  for (const char* of : {"entered", "left", "runoff", "stored", "transpired"})
    EXPECT_NEAR(here[of].get<double>(), there[of].get<double>(), 1e-7 * here["stored"].get<double>()) << of;
  EXPECT_GT(here["transpired"].get<double>(), 0);
  // The soil takes all of the rain: the sign of what rounding leaves depends on the processor.
  EXPECT_NEAR(here["runoff"].get<double>(), 0, 1e-12 * here["stored"].get<double>());
  EXPECT_LT(there["error"].get<double>(), 1e-9);
}

TEST_F(DeviceRun, LeavesWaterWithItsOwnVelocityToTheProcessorAndSaysSo) {
  std::ofstream(folder_ / "case.toml") << wet_bank;
  const auto [said, code] = tell("run '" + (folder_ / "case.toml").string() + "' -o '" + (folder_ / "there").string() +
                                 "' --device " + golden::find_tested_device() +
                                 " --set stage.0.duration=0.5 --set stage.1.duration=0.01 --set stage.1.water=flows");
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(said.find("velocity of its own"), std::string::npos) << said;
}

TEST_F(DeviceRun, ItsCheckpointGoesOnOnTheProcessor) {
  ASSERT_EQ(wait_for(start("here", {})), 0);
  ASSERT_TRUE(kill_on_the_device()) << "the case must be long enough to be killed";
  ASSERT_EQ(wait_for(start("there", {"--resume"})), 0);
  expect_close("here", "there", 1e-7);
}

TEST_F(DeviceRun, ThatLosesItsDeviceGoesOnOnTheProcessor) {
  ASSERT_EQ(wait_for(start("here", {})), 0);
  const input::LoadedCase loaded = input::read_case((folder_ / "case.toml").string(), {});
  run::RunOptions options;
  options.folder = folder_ / "there";
  mpm::use_emulated_device({.launches = 5'000});
  try {
    run::run_case(loaded, options);
    FAIL() << "the device must have failed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::interrupted);
    EXPECT_NE(std::string(error.what()).find("--resume"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fs::exists(folder_ / "there" / "checkpoint.h5"));
  ASSERT_EQ(wait_for(start("there", {"--resume"})), 0);
  expect_close("here", "there", 1e-7);
}

TEST_F(DeviceRun, UnknownOrAbsentDeviceIsASentenceAndNothingIsWritten) {
  const std::string run = "run '" + (folder_ / "case.toml").string() + "' -o '" + (folder_ / "none").string() + "' ";
  const auto [unknown, code] = tell(run + "--device abacus");
  EXPECT_EQ(code, 2);
  EXPECT_NE(unknown.find("expected cpu, gpu, or emulated"), std::string::npos) << unknown;
  EXPECT_FALSE(fs::exists(folder_ / "none"));
  const auto [absent, ended] = tell(run + "--device gpu");
  if (ended == 0) GTEST_SKIP() << "there is a GPU here";
  EXPECT_EQ(ended, 2);
  EXPECT_NE(absent.find("--device gpu: "), std::string::npos) << absent;
  EXPECT_FALSE(fs::exists(folder_ / "none")) << absent;
}

}  // namespace
}  // namespace talus
