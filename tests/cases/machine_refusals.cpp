// SPDX-License-Identifier: MIT
// Limits of the operating system, such as permissions, long names and full disks, end the program with one message and
// an exit code of the manual, not with a crash.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/folder_lock.hpp"
#include "support/external_model.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// A block of soil that settles for a second, in some ten milliseconds.
const char* const block = R"(title = "block"
geometry.box = [[0, 0], [4, 3]]
geometry.polygon = [{ name = "soil", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
mesh.size = 1
regions.soil = "clay"
boundary = [{ on = "bottom", fix = "full" }, { on = "left", fix = "normal" }, { on = "right", fix = "normal" }]
stage = [{ name = "weight", duration = 0.5, damping = 0.3 }]
output = { frame_interval = 0.1, checkpoint_interval = 0.05 }
)";
const char* const refused_soil = R"([materials.clay]
model = "linear_elastic"
young_modulus = "5 MPa"
poisson_ratio = 0.3
grain_density = 2700
porosity = 0.37
)";

class Machine : public testing::Test {
 protected:
  void SetUp() override {
    case_ = (folder_ / "block.toml").string();
    std::ofstream(case_) << block << refused_soil;
  }

  /// Runs the shell command, in which $T is the program and $F the folder; what it prints on standard error is `said_`.
  int run(const std::string& command) {
    const std::string whole = "cd '" + folder_.string() + "'; T='" TALUS_PROGRAM "'; F='" + folder_.string() + "'; { " +
                              command + "; } 2>&1 >out.txt";
    FILE* pipe = popen(("bash -c \"" + whole + "\"").c_str(), "r");
    std::array<char, 4096> buffer{};
    message_.clear();
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) message_.append(buffer.data(), n);
    const int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  void expect(int code, const std::string& words, const std::string& command) {
    EXPECT_EQ(run(command), code) << command << "\n" << message_;
    EXPECT_NE(message_.find(words), std::string::npos) << command << "\n" << message_;
    EXPECT_EQ(message_.find("internal error"), std::string::npos) << command << "\n" << message_;
  }

  const fs::path folder_ = support::make_scratch("machine");
  std::string case_, message_;
  static constexpr const char* start = "\\$T run block.toml -q --no-report --threads 1 ";
};

TEST_F(Machine, RefusesNamesThatAreTooLong) {
  const std::string longest(300, 'a');
  expect(6, "cannot write '" + longest + "': File name too long", start + ("-o " + longest));
  expect(2, "the case file cannot be opened: File name too long", "\\$T check " + longest);
  expect(2, "File name too long", "\\$T report " + longest);
}

TEST_F(Machine, RefusesFoldersWithoutPermission) {
  if (geteuid() == 0) {
    expect(0, "", "command -v setpriv || exit 1");
    fs::permissions(folder_, fs::perms::others_all, fs::perm_options::add);
  }
  const std::string nobody = geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  ASSERT_EQ(run(start + std::string("-o shut; chmod 000 shut")), 0) << message_;
  expect(6, "cannot write 'shut': Permission denied", nobody + start + "-o shut");
  expect(2, "Permission denied", nobody + "\\$T report shut");
  expect(2, "the case file cannot be opened: Permission denied", nobody + "\\$T check shut/x.toml");
  run("chmod 755 shut");
}

TEST_F(Machine, LetsFilesGrowNoFurther) {
  expect(6, "File too large", "ulimit -f 4; " + std::string(start) + "-o cut");
}

TEST_F(Machine, HasAFullStandardOutput) {
  expect(6, "No space left on device", "\\$T schema >/dev/full");
  expect(6, "cannot print: No space left on device", "\\$T check block.toml >/dev/full");
}

TEST_F(Machine, LetsOneRunIntoAFolder) {
  ASSERT_EQ(run(start + std::string("-o one")), 0) << message_;
  FolderLock lock(folder_ / "one");
  lock.take();
  for (const char* way : {"", " --resume", " --overwrite"})
    expect(3, way[0] == '\0' ? "is not empty" : "is in use by process", start + std::string("-o one") + way);
  EXPECT_TRUE(fs::exists(folder_ / "one" / "summary.json")) << "nothing is removed";
}

/// No file is left in the folder itself, nor in that of a part of it.
TEST_F(Machine, LetsNoOtherCommandIntoTheFolderOfARun) {
  ASSERT_EQ(run(start + std::string("-o one")), 0) << message_;
  fs::create_directories(folder_ / "one" / "trials");
  fs::copy(folder_ / "one", folder_ / "part", fs::copy_options::recursive);
  fs::remove(folder_ / "part" / "summary.json");
  fs::rename(folder_ / "part", folder_ / "one" / "trials" / "srf_1.2");
  const char* const commands[] = {"collect", "report", "plot"};
  {
    FolderLock lock(folder_ / "one");
    lock.take();
    for (const std::string command : commands)
      for (const char* in : {" one", " one/", " one/trials/srf_1.2", " one/trials/../"})
        expect(3, "is in use by process", "\\$T " + command + in);
    expect(3, "is in use by process", "\\$T collect .");
    EXPECT_FALSE(fs::exists(folder_ / "one" / "report.html"));
  }
  for (const std::string command : commands)
    for (const char* in : {" one", " one/trials/srf_1.2"}) expect(0, "", "\\$T " + command + in);
  EXPECT_FALSE(fs::exists(folder_ / "one" / lock_file));
  EXPECT_FALSE(fs::exists(folder_ / "one" / "trials" / "srf_1.2" / lock_file));
}

TEST_F(Machine, OpensFewFiles) {
  ASSERT_EQ(run(start + std::string("-o one")), 0) << message_;
  // The loader of libraries needs some as well, and a test may inherit others.
  const std::string close = "exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-; ";
  for (const std::string files : {"6", "12"})
    for (const std::string command : {"check block.toml", "run block.toml -o few", "report one"})
      expect(7, "raise the limit (ulimit -n)", close + "ulimit -n " + files + "; \\$T " + command);
  EXPECT_FALSE(fs::exists(folder_ / "few"));
  expect(0, "", "ulimit -n 32; " + std::string(start) + "-o enough");
}

TEST_F(Machine, StartsNoThreadsWithoutEnd) {
  for (const std::string threads : {"1025", "2000000000", "99999999999999999999"})
    expect(2, "must be a whole number of at most 1024", start + std::string("--threads ") + threads);
  for (const std::string threads : {"0", "-3", "-99999999999999999999", "two", "3.5"})
    expect(2, "must be a whole number of at least 1", start + std::string("--threads ") + threads);
}

/// Names of a case reach the terminal, tables and pictures without escape sequences and formulas.
TEST_F(Machine, PrintsHostileNames) {
  const std::string hostile = "\\u001b]0;owned\\u0007\\u001b[31m \\u202ertl\\uffff";
  std::ofstream(folder_ / "names.toml")
      << "title = \"" << hostile << "\"\ngeometry.box = [[0, 0], [4, 3]]\n"
      << "geometry.polygon = [{ name = \"" << hostile << "\", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]\n"
      << "mesh.size = 1\nregions.\"" << hostile << "\" = \"clay\"\nboundary = [{ on = \"bottom\", fix = \"full\" }]\n"
      << "stage = [{ name = \"" << hostile << "\", duration = 0.5 }]\n"
      << "output = { frame_interval = 0.1, monitor = [{ name = \"=1+2\", at = [2, 2] }, { name = \"" << hostile
      << "\", at = [3, 2] }] }\n"
      << "[[study.vary]]\nkey = \"gravity.acceleration\"\nvalues = [5, 6]\nnames = [\"" << hostile
      << "\", \"@SUM(A1)\"]\n"
      << refused_soil;
  for (const std::string command :
       {"check names.toml", "run names.toml -o one", "plot one", "report one", "study names.toml -o study"}) {
    EXPECT_EQ(run("\\$T " + command), 0) << command << message_;
    message_ += support::read_text(folder_ / "out.txt");
    EXPECT_EQ(message_.find_first_of("\x1b\a"), std::string::npos) << command;
    EXPECT_EQ(message_.find("\u202e"), std::string::npos) << command;
  }
  EXPECT_EQ(run("\\$T check names.toml --set title="), 0);
  int texts = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".csv" && ending != ".svg" && ending != ".gp" && ending != ".md" && ending != ".html") continue;
    const std::string text = support::read_text(entry.path());
    EXPECT_EQ(text.find_first_of("\x1b\a"), std::string::npos) << entry.path();
    if (ending != ".html") {  // XML forbids it
      EXPECT_EQ(text.find("\uffff"), std::string::npos) << entry.path();
    }
    EXPECT_EQ(text.find("\n@"), std::string::npos) << entry.path();
    EXPECT_EQ(text.find(",=1+2"), std::string::npos) << entry.path();
    ++texts;
  }
  EXPECT_GT(texts, 5);
  EXPECT_NE(support::read_text(folder_ / "one" / "monitors.csv").find(",'=1+2.displacement_x [mm]"), std::string::npos);
}

TEST_F(Machine, HoldsFilesThatAreNoResults) {
  ASSERT_EQ(run(start + std::string("-o one")), 0) << message_;
  std::ofstream(folder_ / "one" / "summary.json") << "[]";
  expect(2, "it should hold one JSON object", "\\$T report one");
  expect(2, "'one/summary.json' is not as the run wrote it", start + std::string("-o one --resume"));
}

TEST_F(Machine, WouldNotSurviveAKeyOfAHundredThousandParts) {
  std::string deep = "a";
  for (int i = 0; i < 100000; ++i) deep += ".a";
  std::ofstream(folder_ / "deep.toml") << "# a.b\ntitle = \"" << std::string(1000, '.') << "\"\n" << deep << " = 1\n";
  expect(2, "deep.toml:3:202: error: this key has more than 100 parts", "\\$T check deep.toml");
  expect(2, "the key has more than 100 parts", "\\$T check block.toml --set " + deep.substr(0, 1001) + "=1");
}

TEST_F(Machine, RunsASoilModelThatEndsIt) {
  const auto write = [&](const std::string& symbol) {
    std::ofstream(case_) << block << "[materials.clay]\nmodel = \"external\"\nlibrary = \""
                         << support::find_umat("failing") << "\"\nsymbol = \"" << symbol
                         << "\"\nconstants = [0]\nconstrained_modulus = \"8 MPa\"\n"
                         << "grain_density = 2700\nporosity = 0.37\n";
  };
  write("exit_");
  expect(4, "umat_failing.so) ended the program, as STOP or exit() do", start + std::string("-o exit"));
  EXPECT_TRUE(fs::exists(folder_ / "exit" / "frames" / "000000.h5"));
  write("abort_");
  expect(4, "failed in point 0", start + std::string("-o abort"));
  EXPECT_NE(message_.find("it crashed (Aborted)"), std::string::npos) << message_;
  EXPECT_TRUE(fs::exists(folder_ / "abort" / "summary.json"));
}

}  // namespace
}  // namespace talus
