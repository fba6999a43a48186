// SPDX-License-Identifier: MIT
// The pore water of a cut in a reservoir after drawdown in its report: states with their fields, and outflow by side.

#include <fstream>

#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "support/run_json.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class WaterStates : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = make_test_folder("water_states");
    std::ifstream file(TALUS_SOURCE_DIR "/tests/data/misleading/drawdown.toml");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    run::RunOptions options;
    options.folder = folder_;
    options.overwrite = true;
    summary_ = support::run_case(input::read_case_text(text, "drawdown.toml",
                                                       {{"mesh.size", "2"},
                                                        {"lem.noncircular", "false"},
                                                        {"lem.methods", "[\"bishop\"]"},
                                                        {"lem.entry_exit.entries", "8"},
                                                        {"lem.entry_exit.exits", "8"}}),
                                 options);
    page_ = std::make_unique<ReadPage>(read_text(write_report(folder_)));
  }
  static void TearDownTestSuite() {
    fs::remove_all(folder_);
    page_.reset();
  }
  static const json& document() { return page_->document; }
  static std::string join_answer() {
    std::string text;
    for (const std::string sentence : document().at("answer").at("sentences")) text += sentence + "\n";
    return text;
  }

  static inline fs::path folder_;
  static inline json summary_;
  static inline std::unique_ptr<ReadPage> page_;
};

TEST_F(WaterStates, KeepTheContract) {
  EXPECT_EQ(find_schema_faults(*page_), "");
}

TEST_F(WaterStates, AreThoseOfTheResults) {
  const json &result = summary_.at("water_states"), &shown = document().at("model").at("water");
  ASSERT_EQ(result.size(), 11u);
  ASSERT_EQ(shown.size(), result.size());
  EXPECT_EQ(shown.front().at("title"), "steady seepage, 3 days before the start");
  EXPECT_EQ(shown[5].at("title"), "transient seepage, 1.5 days before the start");
  EXPECT_EQ(shown.back().at("title"), "transient seepage, at the start");
}

TEST_F(WaterStates, HaveTheFieldsOfTheFile) {
  const json file = json::parse(std::ifstream(folder_ / "water.json"));
  const json& model = document().at("model");
  const std::vector<double> nodes = page_->values(model.at("water_mesh").at("nodes"));
  ASSERT_EQ(nodes.size(), 2 * file.at("nodes").size());
  for (std::size_t i = 0; i < model.at("water").size(); ++i) {
    const json &packed = model["water"][i].at("fields").at("pressure"), &result = file.at("states")[i].at("pressure");
    const std::vector<double> pressure = page_->values(packed);
    ASSERT_EQ(pressure.size(), result.size());
    const double step = (packed.at("range")[1].get<double>() - packed["range"][0].get<double>()) / 65534;
    for (std::size_t n = 0; n < result.size(); n += 7) EXPECT_NEAR(pressure[n], result[n].get<double>(), step);
  }
}

TEST_F(WaterStates, InflowAndOutflowAreInTheAnswer) {
  const std::string text = join_answer();
  for (const char* part :
       {"At the end of the transient seepage water enters with ", " through 'left', and leaves with ",
        " through 'face', up to the exit point (", "No water passes 'bottom' and 'right'.",
        "Water stands on the ground up to y = 9 m.", "In the steady seepage before the season "})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

}  // namespace
}  // namespace talus::report
