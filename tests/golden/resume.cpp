// SPDX-License-Identifier: MIT
// A run interrupted by a signal or by kill -9 and then resumed is bitwise identical to an uninterrupted one.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "output/files/frames_reader.hpp"
#include "support/child.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// A slope that fails, small enough for a second or two, with a short curve and a frozen factor behind the stages.
const std::string slope =
    support::write_slope("bank", {"geometry.box=[[0, 0], [20, 8]]",
                                  "geometry.polygon.soil.points=[[0, 0], [20, 0], [20, 2], [14, 2], [6, 7], [0, 7]]",
                                  "mesh.size=0.5", "materials.silt.young_modulus=20 MPa", "materials.silt.cohesion=3",
                                  "materials.silt.friction_angle=22"}) +
    R"(
[[stage]]
name = "gravity"
duration = 3
damping = 0.7
cohesion = "100 kPa"
gravity_ramp = 0.5
[[stage]]
name = "slide"
duration = 6
damping = 0.02
strength_factor = 1.6
reset_displacement = true
[[output.monitor]]
name = "crest"
at = [6, 7]
[output]
frame_interval = 1
checkpoint_interval = 0.05
)";

class Resume : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(folder_ / "case.toml") << slope; }

  /// Starts `talus run` on the case; returns the process.
  pid_t start(const std::string& result, const std::string& flag, const char* threads = "2") {
    const pid_t child = fork();
    if (child == 0) {
      const std::string input = (folder_ / "case.toml").string(), output = (folder_ / result).string();
      execl(TALUS_PROGRAM, "talus", "run", input.c_str(), "-o", output.c_str(), "-q", "--threads", threads,
            flag.empty() ? nullptr : flag.c_str(), nullptr);
      _exit(127);
    }
    return child;
  }
  /// Exit code of the process, or minus the signal that ended it.
  static int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  int run_to_its_end(const std::string& result) { return wait_for(start(result, "--resume")); }

  std::string read(const fs::path& path) const {
    std::ifstream file(folder_ / path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// Every frame, and both histories, are bitwise identical.
  void expect_same_results(const std::string& a, const std::string& b) const {
    const output::ResultsReader first(folder_ / a), second(folder_ / b);
    ASSERT_EQ(first.times(), second.times());
    for (int i = 0; i < first.size(); ++i) {
      const output::Frame p = first.read(i), q = second.read(i);
      EXPECT_TRUE(p.ids == q.ids) << "frame " << i;
      EXPECT_TRUE(p.positions == q.positions) << "frame " << i;
      for (const output::Field& field : p.point_fields)
        EXPECT_TRUE(field.values == output::find(q.point_fields, field.name)->values) << field.name << ", frame " << i;
    }
    EXPECT_TRUE(read(fs::path(a) / "history.csv") == read(fs::path(b) / "history.csv"));
    EXPECT_TRUE(read(fs::path(a) / "monitors.csv") == read(fs::path(b) / "monitors.csv"));
  }

  /// Runs `result`, ends it with `signal` after every `pause` of its own seconds until it finishes by itself; returns
  /// how often it was ended.
  int run_with_interruptions(const std::string& result, int signal, double pause) {
    int ended = 0;
    std::string flag;
    for (int attempt = 0; attempt < 60; ++attempt) {
      const pid_t child = start(result, flag);
      if (attempt == 0)
        support::wait_for_file(folder_ / result / "checkpoint.h5", child);
      else
        support::wait_for_work(child, pause);
      kill(child, signal);
      const int code = wait_for(child);
      if (code == 0) return ended;
      EXPECT_EQ(code, signal == SIGKILL ? -SIGKILL : 5)
          << "SIGTERM must save and end with the code for an interruption";
      ++ended;
      flag = "--resume";
      pause += 0.15;  // so that a slow machine gets on as well
    }
    ADD_FAILURE() << "the run never finished";
    return ended;
  }

  const fs::path folder_ = support::make_scratch("resume");
};

TEST_F(Resume, AfterSignalsEqualsContinuousBitForBit) {
  ASSERT_EQ(wait_for(start("whole", "")), 0);
  EXPECT_GE(run_with_interruptions("parts", SIGTERM, 0.3), 1) << "the case must be long enough to be interrupted";
  expect_same_results("whole", "parts");
}

TEST_F(Resume, AfterKillEqualsContinuousBitForBit) {
  ASSERT_EQ(wait_for(start("whole", "")), 0);
  EXPECT_GE(run_with_interruptions("parts", SIGKILL, 0.3), 1) << "the case must be long enough to be killed";
  expect_same_results("whole", "parts");
}

/// Nails that the soil carries, slip through it and yield are part of its state.
TEST_F(Resume, WithSupportsEqualsContinuousBitForBitOnAnyThreads) {
  std::ofstream(folder_ / "case.toml") << slope << R"(
[support.nails]
kind = "nail"
heads = [[8, 5.75], [10.4, 4.25]]
inclination = 10
length = 4
out_of_plane_spacing = 1.5
tensile_strength = 60
plate = 20
bond = 10
axial_stiffness = 5e4
)";
  ASSERT_EQ(wait_for(start("whole", "")), 0);
  EXPECT_NE(read("whole/history.csv").find("support_work"), std::string::npos);
  ASSERT_EQ(wait_for(start("single", "", "1")), 0);
  expect_same_results("whole", "single");
  EXPECT_GE(run_with_interruptions("parts", SIGKILL, 0.3), 1) << "the case must be long enough to be killed";
  expect_same_results("whole", "parts");
}

/// Stages, curve trials, a runout, frozen stages and frozen trials: whatever the kill hits, the factors are the same.
TEST_F(Resume, OfAStrengthReductionAfterKillsGivesTheSameFactors) {
  std::string text = slope;
  text.replace(text.find("size = 0.5"), 10, "size = 0.7");
  text.erase(text.find("strength_factor = 1.6"), 21);
  std::ofstream(folder_ / "case.toml") << text << R"(
[analysis]
kind = "strength_reduction"
[strength_reduction.curve]
smoothing = "none"
from = 1.0
to = 1.4
step = 0.2
refine = false
window = 2
runout = [1.4]
runout_time = 5
[strength_reduction.frozen]
meshes = 1
resolution = 0.05
)";
  ASSERT_EQ(wait_for(start("whole", "")), 0);
  EXPECT_GE(run_with_interruptions("parts", SIGKILL, 0.2), 1);
  const auto whole = nlohmann::json::parse(read("whole/summary.json")),
             parts = nlohmann::json::parse(read("parts/summary.json"));
  EXPECT_EQ(whole.at("factor_of_safety"), parts.at("factor_of_safety"));
  EXPECT_EQ(whole.at("curve"), parts.at("curve"));
  EXPECT_EQ(whole.at("runouts"), parts.at("runouts"));
}

TEST_F(Resume, OfAChangedCaseIsRefused) {
  const pid_t child = start("changed", "");
  support::wait_for_file(folder_ / "changed" / "checkpoint.h5", child);
  kill(child, SIGTERM);
  ASSERT_EQ(wait_for(child), 5);
  std::ofstream(folder_ / "case.toml") << slope + "\n[gravity]\nacceleration = 5\n";
  EXPECT_EQ(wait_for(start("changed", "--resume")), 2);
}

TEST_F(Resume, OfAFinishedRunChangesNothing) {
  ASSERT_EQ(wait_for(start("whole", "")), 0);
  const std::string before = read("whole/summary.json");
  ASSERT_EQ(wait_for(start("whole", "--resume")), 0);
  EXPECT_EQ(read("whole/summary.json"), before);
}

TEST_F(Resume, AnExistingFolderIsNeverOverwrittenUnasked) {
  fs::create_directories(folder_ / "taken");
  std::ofstream(folder_ / "taken" / "notes.txt") << "mine";
  EXPECT_EQ(wait_for(start("taken", "")), 3);
  EXPECT_EQ(read("taken/notes.txt"), "mine");
  EXPECT_EQ(wait_for(start("taken", "--overwrite")), 3) << "no run wrote this folder";
  EXPECT_EQ(wait_for(start("taken", "--resume")), 3);
  EXPECT_EQ(read("taken/notes.txt"), "mine");
}

/// A lost or swapped file that a run resumes from is named, and nothing is changed; after it is put back, the result is
/// bitwise identical.
TEST_F(Resume, FromFilesThatAreLostOrChangedIsRefused) {
  ASSERT_EQ(wait_for(start("whole", "")), 0);
  const pid_t child = start("parts", "");
  support::wait_for_file(folder_ / "parts" / "frames" / "000005.h5", child);
  kill(child, SIGKILL);
  ASSERT_EQ(wait_for(child), -SIGKILL);
  ASSERT_TRUE(fs::exists(folder_ / "parts" / "checkpoint.h5"));
  const auto expect_refused = [&](const std::string& folder, const std::string& file) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_to_its_end(folder), 2) << file;
    const std::string message = testing::internal::GetCapturedStderr();
    EXPECT_NE(message.find("/" + folder + "/" + file + "' is "), std::string::npos) << message;
  };
  const auto damage = [&](const std::string& folder, const std::string& file) {
    const fs::path path = folder_ / folder / file, aside = folder_ / "aside";
    const std::string before = read(fs::path(folder) / file);
    fs::rename(path, aside);
    expect_refused(folder, file);
    std::string changed = before;
    changed[changed.size() / 2] ^= 1;
    std::ofstream(path) << changed;
    expect_refused(folder, file);
    fs::rename(aside, path);
    EXPECT_TRUE(read(fs::path(folder) / file) == before);
  };
  for (const char* file :
       {"frames/000002.h5", "history.csv", "monitors.csv", "stages.json", "checkpoint.h5", "mesh.h5"})
    damage("parts", file);
  const fs::path frames = folder_ / "parts" / "frames";
  fs::rename(frames / "000001.h5", folder_ / "aside");
  fs::rename(frames / "000002.h5", frames / "000001.h5");
  fs::rename(folder_ / "aside", frames / "000002.h5");
  expect_refused("parts", "frames/000001.h5");
  fs::rename(frames / "000001.h5", folder_ / "aside");
  fs::rename(frames / "000002.h5", frames / "000001.h5");
  fs::rename(folder_ / "aside", frames / "000002.h5");
  fs::rename(frames / "000003.h5", folder_ / "aside");
  testing::internal::CaptureStderr();
  EXPECT_EQ(std::system(("'" TALUS_PROGRAM "' collect '" + (folder_ / "parts").string() + "'").c_str()) >> 8, 2);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("frames/000003.h5' is missing"), std::string::npos);
  fs::rename(folder_ / "aside", frames / "000003.h5");
  ASSERT_EQ(run_to_its_end("parts"), 0);
  expect_same_results("whole", "parts");
  for (const char* file : {"history.csv", "results.vtkhdf", "summary.json"}) damage("parts", file);
  std::ofstream(folder_ / "parts" / "end_state.h5", std::ios::app) << "x";
  expect_refused("parts", "end_state.h5");
  fs::remove(folder_ / "parts" / "end_state.h5");
  fs::remove(folder_ / "parts" / "report.html");
  EXPECT_EQ(run_to_its_end("parts"), 0);
}

}  // namespace
}  // namespace talus
