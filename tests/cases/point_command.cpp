// SPDX-License-Identifier: MIT
// `talus point` as a command: exit codes, tables, pictures and the report.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "output/files/history.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus::laboratory {
namespace {

namespace fs = std::filesystem;

using support::Outcome;
using support::run_program;

const std::string soil = support::write_slope("sand", {"title=Sand"}) + R"(
[[test]]
name = "cell 100 kPa, 1 %"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 100
axial_strain = 0.05
steps = 100

[[test]]
name = "too much"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 50
control = "stress"
axial_stress = 400
steps = 100

[[test]]
name = "shear"
material = "sand"
kind = "simple_shear"
vertical_stress = 100
k0 = 0.5
shear_strain = 0.1
steps = 500

[[compare]]
name = "test[cell 100 kPa, 1 %].peak_q"
value = "200 kPa"
tolerance = "0.1 %"
source = "(N - 1) times the cell pressure, N = 3"
)";

class PointCommand : public testing::Test {
 protected:
  void SetUp() override { file_ = write("soil.toml", soil); }

  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string read(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  const fs::path folder_ = support::make_scratch("point");
  std::string file_;
};

TEST_F(PointCommand, WritesTablesPicturesSummaryAndReport) {
  const fs::path out = folder_ / "out";
  const Outcome outcome = run_program("point " + file_ + " --out " + out.string());
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const output::HistoryTable table = output::read_history(out / "point" / "cell_100_kPa_1.csv");
  ASSERT_EQ(table.columns.at(10).name, "q");
  EXPECT_EQ(table.columns.at(10).unit, "kPa");
  EXPECT_NEAR(table.values.at(10).back(), 200, 1e-4);
  EXPECT_EQ(table.values.at(0).size(), 101u);
  for (const char* picture : {"drained_triaxial.svg", "simple_shear.svg"})
    EXPECT_NE(read(out / "point" / picture).find("</svg>"), std::string::npos) << picture;
  const auto summary = nlohmann::json::parse(read(out / "point" / "point.json"));
  EXPECT_EQ(summary["tests"].size(), 3u);
  EXPECT_NEAR(summary["tests"][2]["end"]["shear_stress"].get<double>(), 100e3 * std::sin(M_PI / 6), 100);
  ASSERT_EQ(summary["comparisons"].size(), 1u);
  EXPECT_TRUE(summary["comparisons"][0]["passes"].get<bool>());
  // A soil that fails is a result, reported in one sentence.
  EXPECT_EQ(summary["warnings"].size(), 1u);
  EXPECT_NE(outcome.text.find("'too much' ended early: the soil carries an axial stress of 150 kPa and no more"),
            std::string::npos)
      << outcome.text;
  const std::string page = read(out / "report.html");
  EXPECT_NE(page.find("\"kind\":\"tests\""), std::string::npos);
  EXPECT_NE(page.find("\"point_tests\""), std::string::npos);
}

TEST_F(PointCommand, OneTestAndOneOverride) {
  const fs::path out = folder_ / "out";
  const Outcome outcome = run_program("point " + file_ + " -q --no-report --test shear -o " + out.string() +
                                      " --set materials.sand.cohesion=10");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_TRUE(outcome.text.empty()) << outcome.text;
  EXPECT_FALSE(fs::exists(out / "report.html"));
  const auto summary = nlohmann::json::parse(read(out / "point" / "point.json"));
  ASSERT_EQ(summary["tests"].size(), 1u);
  const double strength = 100e3 * 0.5 + 10e3 * std::cos(M_PI / 6);
  EXPECT_NEAR(summary["tests"][0]["end"]["shear_stress"].get<double>(), strength, 1e-3 * strength);
}

TEST_F(PointCommand, MistakesAreOneSentenceAndCodeTwo) {
  const std::string out = " -o " + (folder_ / "out").string();
  Outcome outcome = run_program("point " + file_ + out + " --test shaer");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.text, "talus: error: there is no test 'shaer'; did you mean 'shear'?\n");
  const std::string none = write("none.toml", soil.substr(0, soil.find("[[test]]")));
  EXPECT_EQ(run_program("point " + none + out).code, 2);
  const std::string steep = write("steep.toml", soil.substr(0, soil.find("[[test]]")) +
                                                    "[[test]]\nname = \"steep\"\nmaterial = \"sand\"\n"
                                                    "kind = \"oedometer\"\nvertical_stress = 100\nk0 = 0.1\n"
                                                    "axial_strain = 0.01\n");
  outcome = run_program("point " + steep + out);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.text.find("test 'steep': the soil does not carry the stress at the start"), std::string::npos)
      << outcome.text;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(PointCommand, AFileOfTestsIsCheckedAndNotRun) {
  const Outcome checked = run_program("check " + file_);
  EXPECT_EQ(checked.code, 0) << checked.text;
  EXPECT_NE(checked.text.find("3 element tests"), std::string::npos) << checked.text;
  EXPECT_EQ(run_program("run " + file_ + " -o " + (folder_ / "out").string()).code, 2);
}

}  // namespace
}  // namespace talus::laboratory
