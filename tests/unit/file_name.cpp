// SPDX-License-Identifier: MIT
// Names in a case, a list of jobs or a result cannot leave their folder, denote another file, or exceed the limits of a
// file system.
#include "base/user_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "base/error.hpp"

namespace talus {
namespace {

using namespace std::string_literals;

const std::array hostile{""s,
                         "."s,
                         ".."s,
                         "../../x"s,
                         "/etc/passwd"s,
                         "a/b"s,
                         "a\0b"s,
                         "a\nb"s,
                         "\x1b]0;x\a"s,
                         std::string(300, 'x'),
                         "x/"s + std::string(300, 'y')};

TEST(FileName, RefusesWhatIsNoNameInAFolder) {
  for (const std::string& name : hostile) {
    EXPECT_NE(find_name_fault(name), "") << name;
    try {
      join_name("results", name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::wrong_input);
      EXPECT_NE(std::string(error.what()).find(" in the folder 'results': "), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(join_name("results", "Böschung 1", ".csv"), std::filesystem::path("results/Böschung 1.csv"));
}

TEST(FileName, PathsStayInTheirFolder) {
  EXPECT_EQ(join_path("jobs", "case/station/weather.csv"), std::filesystem::path("jobs/case/station/weather.csv"));
  for (const char* path : {"", "/etc/passwd", "../x", "case/../../x", "case/./x", "case//", "case/"})
    EXPECT_THROW(join_path("jobs", path), Error) << path;
}

TEST(FileName, MakesANameOfEveryText) {
  for (const std::string& text : hostile) {
    const std::string name = make_file_name(text, "empty");
    EXPECT_EQ(find_name_fault(name), "") << name;
    EXPECT_FALSE(is_reserved_name(name)) << name;
    EXPECT_NE(name.front(), '.');
  }
  EXPECT_EQ(make_file_name("100 kPa, 0.22 %", "test"), "100_kPa_0.22");
  EXPECT_EQ(make_file_name("damping_0.01__size_2.5", "base"), "damping_0.01__size_2.5");
  EXPECT_EQ(make_file_name("..", "base"), "base");
  EXPECT_EQ(make_file_name("../../evil", "base"), "evil");
  EXPECT_EQ(make_file_name(std::string(50, 'x'), "base", 40).size(), 40u);
}

TEST(FileName, LeavesNamesOfTheProgramAlone) {
  for (const char* name :
       {"report.html", "REPORT.HTML", "study.json", "study.csv", "study.svg", "jobs", "case", "jobs.slurm",
        "talus.lock", "summary.json.part", "trials", "frames", "elements_3", "point", "con", "NUL.x", "lpt1"}) {
    EXPECT_TRUE(is_reserved_name(name)) << name;
    EXPECT_EQ(make_file_name(name, "base"), std::string(name) + "_");
  }
  for (const char* name : {"base", "elements_", "elements_3.5", "console", "cohesion_4_kPa", "lpt", "com10"})
    EXPECT_FALSE(is_reserved_name(name)) << name;
}

TEST(FileName, NumbersNamesThatAreTaken) {
  std::set<std::string> taken;
  EXPECT_EQ(take_file_name("a b", "test", taken), "a_b");
  EXPECT_EQ(take_file_name("a/b", "test", taken), "a_b_2");
  EXPECT_EQ(take_file_name("a:b", "test", taken), "a_b_3");
}

}  // namespace
}  // namespace talus
