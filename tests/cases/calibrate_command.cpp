// SPDX-License-Identifier: MIT
// `talus calibrate` as a command: exit codes, tables, the example and the report.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus::laboratory {
namespace {

namespace fs = std::filesystem;

using support::Outcome;
using support::run_program;

// Mohr and Coulomb's strength by hand: q = (N - 1) σ₃ + 2c √N, with c = 4 kPa and N = 3.
const std::string tested_soil =
    support::write_slope("sand", {"title=Sand", "materials.sand.cohesion=1", "materials.sand.friction_angle=25"}) + R"(
[[test]]
name = "50 kPa"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 50
axial_strain = 0.05
steps = 100

[[test]]
name = "200 kPa"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 200
axial_strain = 0.05
steps = 100

[calibration]
starts = 3

[[calibration.parameter]]
key = "materials.sand.cohesion"
min = 0
max = 20

[[calibration.parameter]]
key = "materials.sand.friction_angle"
min = 15
max = 45

[[calibration.curve]]
test = "50 kPa"
x = "axial_strain"
y = "q"
file = "cell_50.csv"

[[calibration.curve]]
test = "200 kPa"
x = "axial_strain"
y = "q"
data = [[4, 413.856], [5, 413.856]]
x_unit = "%"
)";

class CalibrateCommand : public testing::Test {
 protected:
  void SetUp() override {
    file_ = write("sand.toml", tested_soil);
    write("cell_50.csv", "axial_strain [%],q [kPa]\n4,113.856\n5,113.856\n");
  }

  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static std::string read(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  static nlohmann::json read_json(const fs::path& path) { return nlohmann::json::parse(read(path)); }

  const fs::path folder_ = support::make_scratch("calibrate");
  std::string file_;
};

TEST_F(CalibrateCommand, FindsTheStrengthAndWritesTablesTestsAndReport) {
  const fs::path out = folder_ / "out";
  const Outcome outcome = run_program("calibrate " + file_ + " --out " + out.string());
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const nlohmann::json found = read_json(out / "calibration" / "calibration.json");
  EXPECT_NEAR(found["parameters"][0]["value"].get<double>(), 4, 0.02) << "kPa";
  EXPECT_NEAR(found["parameters"][1]["value"].get<double>(), 30, 0.02) << "degrees";
  EXPECT_EQ(found["starts"].size(), 3u);
  EXPECT_TRUE(found["findings"].empty()) << found["findings"];
  const std::string table = read(out / "calibration" / "parameters.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')), "parameter,unit,start,fitted,standard_error,min,max,limit");
  EXPECT_NE(table.find("\nmaterials.sand.friction_angle,deg,25,"), std::string::npos) << table;
  EXPECT_NE(read(out / "calibration" / "curves.csv").find("\n50 kPa,axial_strain,%,q,kPa,4,113.856,"),
            std::string::npos);
  EXPECT_NE(read(out / "calibration" / "solver.txt").find("Solver Summary"), std::string::npos);
  // The element tests beside it are those of the fitted soil.
  EXPECT_NEAR(read_json(out / "point" / "point.json")["tests"][1]["peak_q"].get<double>(), 413.856e3, 200);
  const std::string page = read(out / "report.html");
  EXPECT_NE(page.find("\"calibration\":{"), std::string::npos);
  EXPECT_NE(page.find("\"point_tests\""), std::string::npos);
  // The parameters that it recommends are those that it found.
  EXPECT_NE(outcome.text.find("--set materials.sand.cohesion=" + found["parameters"][0]["text"].get<std::string>()),
            std::string::npos)
      << outcome.text;
}

TEST_F(CalibrateCommand, TheSameSeedGivesTheSameBytes) {
  for (const char* name : {"a", "b"})
    ASSERT_EQ(run_program("calibrate " + file_ + " -q --no-report --threads " + (*name == 'a' ? "1" : "3") + " -o " +
                          (folder_ / name).string())
                  .code,
              0);
  for (const char* table : {"parameters.csv", "correlation.csv", "curves.csv"})
    EXPECT_EQ(read(folder_ / "a" / "calibration" / table), read(folder_ / "b" / "calibration" / table)) << table;
  const auto starts = [&](const char* name) { return read_json(folder_ / name / "calibration" / "calibration.json"); };
  EXPECT_EQ(starts("a")["starts"], starts("b")["starts"]);
  EXPECT_EQ(
      run_program("calibrate " + file_ + " -q --no-report --set calibration.seed=2 -o " + (folder_ / "c").string())
          .code,
      0);
  EXPECT_NE(starts("a")["starts"][1]["from"], starts("c")["starts"][1]["from"]);
}

TEST_F(CalibrateCommand, AParameterAtItsLimitIsReportedAtTheTerminal) {
  const Outcome outcome = run_program("calibrate " + file_ + " --no-report --set calibration.parameter.1.max=28 -o " +
                                      (folder_ / "out").string());
  EXPECT_EQ(outcome.code, 0) << "a warning, no error: " << outcome.text;
  EXPECT_NE(outcome.text.find("AT ITS LIMIT"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("warning: 'materials.sand.friction_angle' ended at its largest value, 28 deg"),
            std::string::npos)
      << outcome.text;
}

TEST_F(CalibrateCommand, MistakesAreSentencesAndNothingIsWritten) {
  const std::string out = " -o " + (folder_ / "out").string();
  Outcome outcome =
      run_program("calibrate " + write("bare.toml", tested_soil.substr(0, tested_soil.find("[calibration]"))) + out);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.text.find("there is nothing to calibrate in"), std::string::npos) << outcome.text;
  outcome = run_program("calibrate " + file_ + out +
                        " --set calibration.parameter.0.start=30 --set calibration.curve.0.file=none.csv"
                        " --set 'calibration.curve.1.test=100 kPa'");
  EXPECT_EQ(outcome.code, 2);
  for (const char* part : {"begins at 30 kPa, outside", "there is no table", "there is no test '100 kPa'"})
    EXPECT_NE(outcome.text.find(part), std::string::npos) << part << "\n" << outcome.text;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_EQ(run_program("check " + file_).code, 0);
}

TEST_F(CalibrateCommand, TheExampleComesBackToTable4_1) {
  const Outcome outcome = run_program("calibrate " TALUS_SOURCE_DIR
                                      "/examples/calibrate_loess/case.toml --no-report "
                                      "--set calibration.starts=1 -o " +
                                      (folder_ / "out").string());
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const nlohmann::json found = read_json(folder_ / "out" / "calibration" / "calibration.json");
  const std::array<double, 4> truth{0.089, 0.022, 0.28, 0.18};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(found["parameters"][i]["value"].get<double>(), truth[i], 0.01 * truth[i]) << i;
  EXPECT_LT(std::abs(found["correlation"][0][1].get<double>()), 0.5) << "λ and κ, told apart by unloading";
}

}  // namespace
}  // namespace talus::laboratory
