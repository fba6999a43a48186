// SPDX-License-Identifier: MIT
// A run with a rapid drawdown: the summary has its stages, and the report satisfies its contract.

#include <fstream>

#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "support/run_json.hpp"

namespace talus::report {
namespace {

TEST(DrawdownReport, HasTheFactorAfterItBesideThatBefore) {
  const std::filesystem::path folder = make_test_folder("drawdown");
  std::ifstream file(TALUS_SOURCE_DIR "/examples/rapid_drawdown/case.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  const auto summary = support::run_case(input::read_case_text(text, "case.toml", {{"lem.search", "'none'"}}), options);
  const auto& lem = summary.at("lem");
  EXPECT_EQ(lem.at("drawdown"), "three_stage");
  const auto& given = lem.at("given")[0];
  const auto& drawn = given.at("drawdown");
  // Figures of tests/physics/lem_drawdown.cpp, in SI.
  EXPECT_NEAR(given.at("factor").get<double>(), 1.435, 0.002);
  EXPECT_NEAR(drawn.at("factor_before").get<double>(), 2.204, 0.004);
  EXPECT_NEAR(drawn.at("undrained_factor").get<double>(), 1.515, 0.002);
  EXPECT_TRUE(given.at("yield_acceleration").is_null());
  const auto& slices = given.at("slices");
  ASSERT_EQ(drawn.at("counts").size(), slices.at("left").size());
  // The table of slices has the undrained strength where it counts; each base is in one of both states.
  for (std::size_t i = 0; i < drawn.at("counts").size(); ++i) {
    const bool is_undrained = drawn.at("counts")[i] == "undrained";
    EXPECT_EQ(slices.at("tan_friction")[i] == 0.0, is_undrained);
    if (is_undrained) {
      EXPECT_EQ(slices.at("cohesion")[i], drawn.at("strength")[i]);
    }
  }
  const ReadPage page(read_text(write_report(folder)));
  const nlohmann::json& document = page.document;
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_EQ(document.at("slices").at("drawdown"), "three stages, Duncan, Wright and Wong");
  EXPECT_NE(document.at("answer").at("sentences").dump().find("after a rapid drawdown"), std::string::npos);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
