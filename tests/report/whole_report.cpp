// SPDX-License-Identifier: MIT
// The report of a real run satisfies its contract, and its numbers agree with the result files.

#include "report/report.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "small_run.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// One run for all tests of this file.
class WholeReport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = make_test_folder("whole");
    summary_ = run_small_case(folder_);
    const fs::path path = write_report(folder_);
    EXPECT_EQ(path, folder_ / "report.html");
    html_ = read_text(path);
    page_ = std::make_unique<ReadPage>(html_);
  }
  static void TearDownTestSuite() {
    fs::remove_all(folder_);
    page_.reset();
  }
  const json& document() const { return page_->document; }

  static inline fs::path folder_;
  static inline json summary_;
  static inline std::string html_;
  static inline std::unique_ptr<ReadPage> page_;
};

TEST_F(WholeReport, KeepsTheContractWithThePage) {
  EXPECT_EQ(find_schema_faults(*page_), "");
  json spoiled = document();
  spoiled["model"]["dimension"] = "two";
  EXPECT_NE(find_schema_faults(spoiled), "") << "the schema lets everything pass";
}

TEST_F(WholeReport, ATitleCannotEndItsScript) {
  EXPECT_EQ(document().at("title"), "Small </script><b>slope");
  EXPECT_EQ(html_.find("</script><b>"), std::string::npos);
  EXPECT_EQ(html_.find("<b>slope"), std::string::npos) << "the title stands unescaped somewhere";
}

TEST_F(WholeReport, NeedsNothingFromOutside) {
  for (const char* outside : {" src=\"http", " href=\"http", "@import", "url(http"})
    EXPECT_EQ(html_.substr(0, html_.find("<script type=\"application/json\"")).find(outside), std::string::npos)
        << outside;
}

TEST_F(WholeReport, FactorsAreThoseOfTheSummary) {
  const json& factors = document().at("answer").at("factors");
  const double frozen = summary_.at("factor_of_safety").at("frozen").at("factor");
  EXPECT_EQ(factors[0].at("name"), "factor_of_safety.frozen");
  EXPECT_EQ(factors[0].at("value"), frozen);
  EXPECT_EQ(factors[0].at("main"), true);
  EXPECT_TRUE(factors[0].at("lower").is_null()) << "one mesh: the bracket of its search is no interval of the factor";
  EXPECT_NE(factors[0].at("note").get<std::string>().find("one mesh, not extrapolated; the mesh error is not known"),
            std::string::npos);
  EXPECT_EQ(factors.size(), 1 + summary_.at("factor_of_safety").at("criteria").size());
  char words[64];
  std::snprintf(words, sizeof words, "The factor of safety is %.3f ", frozen);
  EXPECT_EQ(document().at("answer").at("sentences")[0].get<std::string>().find(words), 0u)
      << document().at("answer").at("sentences")[0];
}

TEST_F(WholeReport, TheResultsAreTheSummary) {
  EXPECT_EQ(page_->results.at("result"), summary_);
}

TEST_F(WholeReport, StrengthAtFailureIsDividedByTheFactor) {
  const double factor = document().at("answer").at("factors")[0].at("value");
  const json& clay = document().at("model").at("materials")[0];
  ASSERT_EQ(clay.at("name"), "clay");
  const auto find = [&](const std::string& key) {
    for (const json& p : clay.at("properties"))
      if (p.at("key") == key) return p;
    return json();
  };
  EXPECT_EQ(find("cohesion").at("characteristic"), 4);
  EXPECT_EQ(find("friction_angle").at("characteristic"), 30);
  EXPECT_NEAR(find("cohesion").at("at_failure").get<double>(), 4 / factor, 1e-9);
  const double degree = std::acos(-1.0) / 180;
  EXPECT_NEAR(find("friction_angle").at("at_failure").get<double>(), std::atan(std::tan(30 * degree) / factor) / degree,
              1e-9);
  EXPECT_TRUE(find("young_modulus").at("at_failure").is_null());
}

TEST_F(WholeReport, FramesDecodeToThoseOfTheResultsFiles) {
  const auto compare = [&](const std::string& id, std::size_t shown, const fs::path& folder, int index) {
    const json& sequence = page_->sequence(id);
    const output::Frame frame = output::ResultsReader(folder).read(index);
    const std::size_t count = sequence.at("point_count");
    ASSERT_EQ(count, frame.ids.size());
    EXPECT_EQ(sequence.at("frames")[shown].at("time"), frame.time);
    const auto positions = page_->values(sequence.at("positions"));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t d = 0; d < 2; ++d)
        // A thousandth of an element of 3 m.
        ASSERT_NEAR(positions[(shown * count + i) * 2 + d], frame.positions[3 * i + d], 0.003);
    const auto ids = page_->values(sequence.at("ids"));
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(ids[i], frame.ids[i]);
    for (const json& f : sequence.at("fields")) {
      if (f.at("name") != "deviatoric_strain") continue;
      const double width = f["values"]["range"][1].get<double>() - f["values"]["range"][0].get<double>();
      const auto values = page_->values(f.at("values"));
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_NEAR(values[shown * count + i], output::find(frame.point_fields, "deviatoric_strain")->values[i],
                    width / 65534);
    }
  };
  compare("stages", 1, folder_, 1);
  compare("curve", 0, folder_ / "trials" / "srf_1.4000", 0);
  const std::size_t frames = page_->sequence("runout_2").at("frames").size();
  compare("runout_2", frames - 1, folder_ / "trials" / "srf_2.0000",
          output::ResultsReader(folder_ / "trials" / "srf_2.0000").size() - 1);
  // The curve shows every factor at the end of the same time.
  const json& curve = page_->sequence("curve").at("frames");
  ASSERT_EQ(curve.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(curve[i].at("factor").get<double>(), 1.4 + 0.2 * static_cast<double>(i), 1e-9);
  EXPECT_NEAR(curve[3].at("time").get<double>(), curve[0].at("time").get<double>(), 0.1);
}

TEST_F(WholeReport, TablesAreTheHistories) {
  const output::HistoryTable history = output::read_history(folder_ / "history.csv");
  const json& tables = document().at("tables");
  const json& first = tables[0];
  EXPECT_EQ(first.at("id"), "history");
  EXPECT_EQ(first.at("x").at("unit"), "s");
  ASSERT_EQ(first.at("columns").size() + 1, history.columns.size());
  EXPECT_EQ(first.at("x").at("values").size(), history.values[0].size());
  EXPECT_EQ(first.at("columns").back().at("values").back(), history.values.back().back());
  for (const json& t : tables)
    for (const json& column : t.at("columns")) {
      EXPECT_NE(column.at("quantity"), "state") << column.at("name") << " is written by no name that is known";
      EXPECT_EQ(column.at("quantity") == "energy", column.contains("part")) << column.at("name");
    }
  std::vector<std::string> ids;
  for (const json& t : tables) {
    ids.push_back(t.at("id"));
    EXPECT_EQ(t.at("sequence"), ids.back().ends_with("_runout_2") ? "runout_2" : "stages");
    EXPECT_EQ(page_->sequence(t.at("sequence")).at("kind"), ids.back().ends_with("_runout_2") ? "runout" : "stages");
  }
  for (const char* id : {"monitors", "history_runout_2", "monitors_runout_2", "profile_runout_2"})
    EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
}

TEST_F(WholeReport, TheMonitorIsThePointThatTheHistoryFollows) {
  const json& monitor = document().at("model").at("monitors")[0];
  const output::HistoryTable history = output::read_history(folder_ / "monitors.csv");
  const output::ResultsReader reader(folder_);
  const output::Frame last = reader.read(reader.size() - 1);
  const auto row = static_cast<std::size_t>(std::find(last.ids.begin(), last.ids.end(), monitor.at("id").get<int>()) -
                                            last.ids.begin());
  ASSERT_EQ(history.columns[2].name, "crest.displacement_y");
  EXPECT_NEAR(history.values[2].back() * 1e-3, output::find(last.point_fields, "displacement")->values[3 * row + 1],
              1e-12);
}

TEST_F(WholeReport, BoundariesLieOnTheBox) {
  const json& boundaries = document().at("model").at("boundaries");
  ASSERT_EQ(boundaries.size(), 3u);
  EXPECT_EQ(boundaries[0].at("lines").size(), 1u);
  const json& bottom = boundaries[0].at("lines")[0];
  ASSERT_EQ(bottom.size(), 2u) << "points on a straight line are left out";
  EXPECT_NEAR(std::abs(bottom[0][0].get<double>() - bottom[1][0].get<double>()), 44, 1e-9);
  EXPECT_EQ(bottom[0][1], 0);
  EXPECT_EQ(document().at("model").at("loads").size(), 2u);
}

TEST_F(WholeReport, AssumptionsFollowTheCase) {
  const auto has_assumption = [](const json& doc, const std::string& part) {
    return std::any_of(doc.at("assumptions").begin(), doc.at("assumptions").end(),
                       [&](const json& s) { return s.get<std::string>().find(part) != std::string::npos; });
  };
  EXPECT_TRUE(has_assumption(document(), "Plane strain"));
  EXPECT_TRUE(has_assumption(document(), "ψ = 0"));
  EXPECT_TRUE(has_assumption(document(), "not extrapolated"));
  EXPECT_TRUE(has_assumption(document(), "without smoothing lock"));
  EXPECT_TRUE(has_assumption(document(), "linear elastic): rock"));
  const json& methods = document().at("methods");
  EXPECT_NE(std::find(methods.begin(), methods.end(), "linear_elastic"), methods.end());
  EXPECT_EQ(std::find(methods.begin(), methods.end(), "mass_scaling"), methods.end());
}

TEST_F(WholeReport, AnUnreadableSummaryIsOneSentence) {
  const fs::path copy = make_test_folder("damaged");
  std::ofstream(copy / "summary.json") << "{\"title\": ";
  try {
    write_report(copy);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(error.what()).find("summary.json"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(copy / "report.html"));
  fs::remove_all(copy);
}

}  // namespace
}  // namespace talus::report
