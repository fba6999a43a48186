// SPDX-License-Identifier: MIT
// `talus study` and `talus collect` as commands: exit codes and files.

#include <sys/wait.h>

#include <array>
#include <cstdio>

#include "output/files/frames_reader.hpp"
#include "study_slope.hpp"
#include "support/program.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;

using support::Outcome;
using support::run_program;

std::string write_case(const fs::path& folder, const std::string& text) {
  fs::create_directories(folder);
  std::ofstream(folder / "slope.toml") << text;
  return (folder / "slope.toml").string();
}

TEST(StudyProgram, AWrongKeyIsOneErrorBeforeAnythingIsWritten) {
  const fs::path folder = make_test_folder();
  std::string text = cohesion_study;
  text.replace(text.find("key = \"materials.sand.cohesion\""), 31, "key = \"materials.sand.cohesoin\"");
  const std::string file = write_case(folder, text);
  const Outcome outcome = run_program("study " + file + " -o " + (folder / "out").string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(std::count(outcome.text.begin(), outcome.text.end(), '\n'), 1) << outcome.text;
  EXPECT_NE(outcome.text.find("did you mean 'cohesion'?"), std::string::npos) << outcome.text;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(StudyProgram, PrintsTheTableAndExitsWithTheGravestCode) {
  const fs::path folder = make_test_folder();
  const std::string out = (folder / "out").string();
  const std::string good = write_case(folder / "good", cohesion_study);
  Outcome outcome = run_program("study " + good + " --threads 2 -o " + out);
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("| cohesion = 8 | 8 |"), std::string::npos) << outcome.text;
  EXPECT_EQ(run_program("study " + good + " -q -o " + out).code, 3) << "the folder is in use";
  EXPECT_EQ(run_program("study " + good + " -q --resume -o " + out).code, 0);
  const std::string bad =
      write_case(folder / "bad", coarse_slope + "\n[[study.vary]]\nkey = \"gravity.acceleration\"\nvalues = [1e9]\n");
  outcome = run_program("study " + bad + " --overwrite -o " + out);
  EXPECT_EQ(outcome.code, 4) << outcome.text;
  EXPECT_NE(outcome.text.find("1 of 2 variants did not finish"), std::string::npos) << outcome.text;
}

TEST(CollectProgram, MakesResultsOfTheFramesOfAKilledRun) {
  const fs::path folder = make_test_folder();
  const auto leave_frames = [](const fs::path& run, int count) {
    output::ResultsWriter writer = output::ResultsWriter::start(run);
    for (int i = 0; i < count; ++i) {
      output::Frame frame;
      frame.time = 0.5 * i;
      frame.step = 100 * i;
      frame.stage = "gravity";
      frame.ids = frame.materials = {0, 1};
      frame.positions = {0, 0, 0, 1.5, 0.25 * i, 0};
      writer.write(frame);
    }
  };
  leave_frames(folder, 3);
  leave_frames(folder / "trials" / "srf_1.4000", 1);
  const Outcome outcome = run_program("collect " + folder.string());
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_FALSE(fs::exists(folder / "frames"));
  const output::ResultsReader reader(folder);
  EXPECT_EQ(reader.times(), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(output::ResultsReader(folder / "trials" / "srf_1.4000").size(), 1);
  EXPECT_EQ(run_program("collect " + folder.string()).code, 0) << "collecting twice does no harm";
  EXPECT_EQ(run_program("collect " + (folder / "nowhere").string()).code, 2);
  EXPECT_EQ(run_program("collect " + (folder / "trials").string()).code, 0) << "trials that are complete already";
}

}  // namespace
}  // namespace talus::study
