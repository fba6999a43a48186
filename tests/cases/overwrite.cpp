// SPDX-License-Identifier: MIT
// --overwrite replaces the files of runs and studies, and no others.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "cases/sampling_slope.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string text;  ///< both output streams
};

const std::string circles = sampling_slope::write_case("");

/// A bank that slides, with a section and a curve of one factor.
const std::string points = support::write_slope("bank", {"mesh.size=1.5"}) + R"(
[[stage]]
name = "gravity"
duration = 1
damping = 0.7
[[output.section]]
name = "cut"
from = [5, 0]
to = [5, 4]
[output]
cells = true
[analysis]
kind = "strength_reduction"
[strength_reduction.curve]
smoothing = "none"
from = 1.0
to = 1.2
step = 0.2
refine = false
window = 0.3
[strength_reduction.frozen]
enabled = false
)";
const std::string motion = support::write_slope("bank", {"mesh.size=1.5"}) + R"(
[[stage]]
name = "slide"
duration = 1.5
damping = 0.02
[[output.monitor]]
name = "crest"
at = [3, 5]
)";
const std::string elements = sampling_slope::write_case(R"(
[fem]
size = 5
meshes = 1
resolution = 0.3
)");
const std::string study = sampling_slope::write_case(R"(
[[study.vary]]
key = "materials.soil.cohesion"
values = ["20 kPa", "25 kPa"]
)");
const std::string fewer = sampling_slope::write_case(R"(
[[study.vary]]
key = "materials.soil.cohesion"
values = ["20 kPa"]
)");
const std::string samples =
    sampling_slope::write_case("[study]\nmode = \"sample\"\nsamples = 4\n" + sampling_slope::deviations);

class Overwrite : public testing::Test {
 protected:
  std::string write_case(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / (name + ".toml")) << text;
    return (folder_ / (name + ".toml")).string();
  }

  Outcome run_program(const std::string& arguments, const std::string& before = "") const {
    Outcome outcome;
    FILE* pipe = popen(
        ("cd '" + folder_.string() + "' && " + before + " '" TALUS_PROGRAM "' " + arguments + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer{};
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
      outcome.text.append(buffer.data(), n);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
    return outcome;
  }

  void expect_refused(const std::string& arguments, const std::string& sentence, const std::string& before = "") const {
    const std::map<std::string, std::string> files = read_all(".");
    const Outcome outcome = run_program(arguments, before);
    EXPECT_EQ(outcome.code, 3) << outcome.text;
    EXPECT_EQ(std::count(outcome.text.begin(), outcome.text.end(), '\n'), 1) << outcome.text;
    EXPECT_NE(outcome.text.find(sentence), std::string::npos) << outcome.text;
    EXPECT_TRUE(read_all(".") == files) << arguments;
  }

  void put(const std::string& name, const std::string& text = "mine") const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  /// Names and contents of all files of a folder.
  std::map<std::string, std::string> read_all(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / name)) {
      if (entry.is_directory()) continue;
      std::string text(entry.file_size(), ' ');
      std::ifstream(entry.path(), std::ios::binary).read(text.data(), static_cast<std::streamsize>(text.size()));
      files[fs::relative(entry.path(), folder_ / name)] = std::move(text);
    }
    return files;
  }

  std::set<std::string> list_names(const std::string& name) const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / name))
      if (!entry.is_directory()) names.insert(fs::relative(entry.path(), folder_ / name));
    return names;
  }

  const fs::path folder_ = support::make_scratch("overwrite");
};

/// One kind of calculation after the other in the same folder, among files of the user.
TEST_F(Overwrite, RemovesFilesOfRunsAndNoOthers) {
  const std::vector<std::string> strewn{
      "thesis.txt",       "IMG_0012.png",    "site_2023.png",           "curve.png",   "curve.svg",
      "section.gp",       "notes.json",      "frames/photo.jpg",        "frames/x.h5", "sections/mine.csv",
      "trials/a/b.txt",   "trials/c.csv",    "trials/srf_1.0000/d.txt", "frozen/e.h5", "elements_1/f.txt",
      "released_later/g", "case/notes.md",   "jobs/offer.txt",          "jobs/0/log",  "results.vtkhdf.bak",
      "base/h.txt",       "mine/history.csv"};
  const std::string timeline = fs::path(TALUS_SOURCE_DIR) / "examples/reservoir_drawdown/case.toml";
  const std::string short_timeline = timeline +
                                     " --set mesh.size=4 --set 'timeline.times=[\"1 day\"]' --set lem.referee=false" +
                                     " --set 'lem.methods=[\"bishop\"]' --set lem.noncircular=false" +
                                     " --set lem.entry_exit.entries=6 --set lem.entry_exit.exits=6";
  const std::vector<std::string> commands{
      "run " + write_case("points", points),
      "run " + write_case("elements", elements) +
          " --set 'analysis.methods=[\"lem\", \"fem\"]' --set 'materials.soil.young_modulus=\"20 MPa\"' --set "
          "materials.soil.poisson_ratio=0.3 --set materials.soil.dilatancy_angle=0 --set "
          "materials.soil.tensile_strength=0",
      "run " + write_case("motion", motion),
      "study " + write_case("study", study),
      "study " + write_case("fewer", fewer),
      "run " + short_timeline,
      "study " + write_case("samples", samples),
      "study " + write_case("jobs", study) + " --prepare",
      "run " + write_case("circles", circles)};
  const auto calculate = [&](const std::string& command, const std::string& folder, const std::string& flag) {
    const bool prepares = command.ends_with("--prepare");
    const Outcome outcome =
        run_program(command + (prepares ? " " : " -o ") + folder + " -q " + flag + (prepares ? "" : " --threads 1"));
    EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.text;
    if (!prepares) return;
    EXPECT_EQ(run_program("study " + folder + " --job 0 -q --threads 1").code, 0);
  };
  calculate(commands.back(), "out", "");
  for (const std::string& name : strewn) put("out/" + name, "content of " + name);
  for (const std::string& command : commands) {
    SCOPED_TRACE(command);
    fs::remove_all(folder_ / "fresh");
    calculate(command, "fresh", "");
    calculate(command, "out", "--overwrite");
    std::set<std::string> expected = list_names("fresh");
    std::map<std::string, std::string> files = read_all("out");
    for (const std::string& name : strewn) {
      EXPECT_TRUE(expected.insert(name).second) << name << " is no file of the user";
      EXPECT_EQ(files[name], "content of " + name);
    }
    EXPECT_EQ(list_names("out"), expected);
    run_program("plot out");
  }
}

TEST_F(Overwrite, ReportsWhatItKeeps) {
  const std::string run = "run " + write_case("circles", circles) + " --no-report -o out";
  ASSERT_EQ(run_program(run).code, 0);
  EXPECT_EQ(run_program(run + " --overwrite").text.find("kept"), std::string::npos);
  put("out/a.txt");
  put("out/frames/b.txt");
  const Outcome outcome = run_program(run + " --overwrite");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.text.find("kept 'out/a.txt' and 1 other file, which no run wrote or which changed since\n"),
            std::string::npos)
      << outcome.text;
  EXPECT_EQ(run_program(run + " --overwrite -q").text, "");
}

TEST_F(Overwrite, RefusesWhatIsInTheWayBeforeAnythingIsRemoved) {
  const std::string run = "run " + write_case("points", points) + " -q -o out";
  ASSERT_EQ(run_program(run).code, 0);
  const auto refuse = [&](const std::string& name, const std::string& text) {
    const fs::path file = folder_ / "out" / name;
    const bool was_there = fs::exists(file);
    if (was_there) fs::rename(file, folder_ / "aside");
    put("out/" + name, text);
    expect_refused(run + " --overwrite", "'out/" + name + "' is in the way");
    fs::remove(file);
    if (was_there) fs::rename(folder_ / "aside", file);
  };
  refuse("curve.csv", "edited");
  refuse("checkpoint.h5", "mine");
  refuse("results.vtkhdf.part", "mine");
  refuse("sections/cut.csv", "edited");
  refuse("frames/000003.h5", "mine");
  refuse("frozen", "a file");
  fs::remove(folder_ / "out/frames");
  // An edit that keeps the size is found when the files are read.
  std::fstream(folder_ / "out/curve.csv", std::ios::in | std::ios::out) << "X";
  expect_refused(run + " --overwrite", "'out/curve.csv' is in the way");
}

/// A run that the user made in the folder of a study is none of its variants.
TEST_F(Overwrite, OfAStudyKeepsRunsThatItDidNotMake) {
  const std::string calculate = "study " + write_case("study", study) + " -q --threads 1 -o out";
  ASSERT_EQ(run_program("study " + write_case("fewer", fewer) + " -q --threads 1 -o out").code, 0);
  ASSERT_EQ(run_program("run " + write_case("circles", circles) + " -q -o out/cohesion_25_kPa").code, 0);
  expect_refused(calculate + " --overwrite", "'out/cohesion_25_kPa/lem.json' is in the way");
  fs::rename(folder_ / "out/cohesion_25_kPa", folder_ / "out/mine");
  EXPECT_EQ(run_program(calculate + " --overwrite").code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/mine/lem.json"));
}

TEST_F(Overwrite, RefusesFoldersWithoutAList) {
  const std::string file = write_case("circles", circles);
  put("older/summary.json", "{}");
  put("photos/IMG_0012.png");
  fs::create_directories(folder_ / "empty");
  for (const char* folder : {"older", "photos"}) {
    expect_refused("run " + file + " --overwrite -o " + folder,
                   "has no list of the files that a run wrote (talus.files)");
    expect_refused("run " + file + " --resume -o " + folder, "has no list of the files that a run wrote (talus.files)");
    expect_refused("study " + write_case("study", study) + " --overwrite -o " + folder, "has no list");
  }
  EXPECT_EQ(run_program("run " + file + " -q --overwrite -o empty").code, 0);
}

TEST_F(Overwrite, RefusesTheCaseTheCurrentFolderAHomeAndARepository) {
  const std::string inner = (folder_ / "p/case/slope.toml").string();
  put("p/case/slope.toml", study);
  put("p/case/notes.txt");
  put("p/jobs/offer.txt");
  expect_refused("study case/slope.toml --prepare . --overwrite", "'.' holds 'case/slope.toml'", "cd p && ");
  expect_refused("run " + inner + " --overwrite -o p", "'p' holds '");
  const std::string run = "run " + write_case("circles", circles) + " -q -o ";
  ASSERT_EQ(run_program(run + "out").code, 0);
  expect_refused(run + ". --overwrite", "is or holds the current folder", "cd out && ");
  expect_refused(run + ".. --overwrite", "holds '", "cd out && ");
  put("out/sub/x");
  expect_refused(run + folder_.string() + "/out --overwrite", "is or holds the current folder", "cd out/sub && ");
  expect_refused(run + "out --overwrite", "is or holds the home folder", "HOME=" + (folder_ / "out/sub").string());
  put("out/sub/.git/HEAD");
  expect_refused(run + "out --overwrite", "'out' holds a repository");
  fs::rename(folder_ / "out/sub/.git", folder_ / "out/.git");
  expect_refused(run + "out --overwrite", "'out' is a repository");
  fs::remove_all(folder_ / "out/.git");
  EXPECT_EQ(run_program(run + "out --overwrite").code, 0);
}

}  // namespace
}  // namespace talus
