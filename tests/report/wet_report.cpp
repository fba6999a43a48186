// SPDX-License-Identifier: MIT
// The report of a wet run: water and hydraulic laws agree with the result files and with MPM, and the statements on the
// drained and two-velocity stages, reduced bulk modulus and scaled conductivity agree with the case.

#include <algorithm>
#include <cmath>
#include <map>

#include "output/files/frames_reader.hpp"
#include "report/folder/numbers.hpp"
#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "small_run.hpp"
#include "small_wet_run.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string join_all(const json& sentences) {
  std::string text;
  for (const json& s : sentences) text += s.get<std::string>() + "\n";
  return text;
}

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)
#define EXPECT_LACKS(text, part) EXPECT_EQ((text).find(part), std::string::npos) << (text)

/// One run for all tests of this file; a test may change a copy of its summary.
class WetReport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = make_test_folder("wet");
    summary_ = run_wet_case(folder_);
    page_ = std::make_unique<ReadPage>(read_text(write_report(folder_)));
  }
  static void TearDownTestSuite() {
    fs::remove_all(folder_);
    page_.reset();
  }
  static const json& document() { return page_->document; }
  static const json& find_material(const std::string& name) {
    for (const json& m : document().at("model").at("materials"))
      if (m.at("name") == name) return m;
    throw std::runtime_error("there is no material " + name);
  }
  static std::vector<double> read_field(const std::string& name) {
    for (const json& f : document().at("sequences")[0].at("fields"))
      if (f.at("name") == name) return page_->values(f.at("values"));
    throw std::runtime_error("there is no field " + name);
  }
  /// Returns the text that a report would have with this summary.
  static json collect_with(const json& summary) {
    const fs::path folder = make_test_folder("wet_changed");
    std::ofstream(folder / "summary.json") << summary;
    const json changed = collect_report(folder).document.get();
    fs::remove_all(folder);
    EXPECT_EQ(find_schema_faults(changed), "");
    return changed;
  }

  static inline fs::path folder_;
  static inline json summary_;
  static inline std::unique_ptr<ReadPage> page_;
};

TEST_F(WetReport, KeepsTheContract) {
  EXPECT_EQ(find_schema_faults(*page_), "");
  ASSERT_TRUE(document().contains("water"));
}

TEST_F(WetReport, TheCurvesAreTheLawsOfTheSoil) {
  const json& curves = find_material("silt").at("water").at("curves");
  const double lambda = 0.3, low = 0.15;
  for (std::size_t i = 0; i < curves.at("suction").size(); i += 10) {
    const double s = curves["suction"][i].get<double>();
    const double effective = std::pow(1 + std::pow(s / 6000, 1 / (1 - lambda)), -lambda);
    EXPECT_NEAR(curves["saturation"][i].get<double>(), low + (1 - low) * effective, 1e-12);
    const double bracket = 1 - std::pow(1 - std::pow(effective, 1 / lambda), lambda);
    const double k = 1e-4 * std::sqrt(effective) * bracket * bracket;
    EXPECT_NEAR(curves["conductivity"][i].get<double>(), k, 1e-9 * k + 1e-18) << "at " << s << " Pa";
  }
  const double largest = curves.at("largest_suction").get<double>();
  EXPECT_EQ(largest, summary_.at("water").at("largest_suction").get<double>());
  EXPECT_LT(curves["suction"][0].get<double>(), largest);
  EXPECT_GT(curves["suction"].back().get<double>(), largest) << "the chart does not reach the model's suction";
  EXPECT_FALSE(find_material("basalt").contains("water"));
}

TEST_F(WetReport, WeightsAreThoseOfGrainsAndWater) {
  const json& rows = find_material("silt").at("properties");
  const auto value = [&](const std::string& key) {
    for (const json& r : rows)
      if (r.at("key") == key) return r.at("characteristic").get<double>();
    return std::nan("");
  };
  EXPECT_NEAR(value("unit_weight"), 0.6 * 2650 * 9.81e-3, 1e-9);
  EXPECT_NEAR(value("unit_weight_saturated"), (0.6 * 2650 + 0.4 * 1000) * 9.81e-3, 1e-9);
  EXPECT_LT(value("unit_weight_moist"), value("unit_weight_saturated"));
  EXPECT_GT(value("unit_weight_moist"), value("unit_weight"));
}

TEST_F(WetReport, TheFlowOfTheWaterIsDarcysAndDrySoilHasNone) {
  const output::ResultsReader reader(folder_);
  const json& sequence = document().at("sequences")[0];
  const std::size_t frames = sequence.at("frames").size(), points = sequence.at("point_count").get<std::size_t>();
  ASSERT_EQ(frames, static_cast<std::size_t>(reader.size())) << "the report leaves out frames of a small run";
  const auto flow = read_field("darcy_velocity_y"), pressure = read_field("pore_pressure"),
             saturation = read_field("saturation");
  double step = 0, largest = 0;
  for (const json& f : sequence.at("fields"))
    if (f.at("name") == "darcy_velocity_y")
      step = (f["values"]["range"][1].get<double>() - f["values"]["range"][0].get<double>()) / 65534;
  std::size_t dry = 0;
  for (std::size_t f = 0; f < frames; ++f) {
    const output::Frame frame = reader.read(static_cast<int>(f));
    ASSERT_EQ(frame.ids.size(), points);
    const auto stored = [&](const char* name, std::size_t at) {
      return output::find(frame.point_fields, name)->values[at];
    };
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t at = f * points + i;
      const double s = stored("saturation", i);
      if (s == 0) {
        EXPECT_TRUE(std::isnan(flow[at]) && std::isnan(pressure[at]) && std::isnan(saturation[at]));
        ++dry;
        continue;
      }
      const double q =
          stored("porosity", i) * s * (stored("water_velocity", 3 * i + 1) - stored("velocity", 3 * i + 1));
      largest = std::max(largest, std::abs(q));
      EXPECT_NEAR(flow[at], q, step);
      EXPECT_NEAR(pressure[at], stored("pore_pressure", i), 1);
    }
  }
  EXPECT_GT(largest, 1000 * step) << "nothing flows, so nothing is tested";
  EXPECT_GT(dry, 0u);
  EXPECT_TRUE(std::none_of(sequence.at("fields").begin(), sequence.at("fields").end(),
                           [](const json& f) { return f.at("name") == "water_velocity"; }));
}

TEST_F(WetReport, TheBudgetClosesWithWhatPassedEachSurface) {
  // The foot of the face is below the water table: all rain there runs off, whatever the rounding of the processor.
  const fs::path folder = make_test_folder("wet_runoff");
  run_wet_case(folder, {{"initial.water_table", "[[0, 2], [7, 1.5]]"}});
  const Content content = collect_report(folder);
  fs::remove_all(folder);
  const json& wet = content.document.get();
  const json& budget = content.results.get().at("result").at("water");
  double change = 0, runoff = 0;
  for (const json& s : budget.at("surfaces")) {
    change += s.at("entered").get<double>() - s.at("left").get<double>();
    runoff += s.at("runoff").get<double>();
  }
  const auto of = [&](const char* key) { return budget.at(key).get<double>(); };
  EXPECT_NEAR(of("stored") - of("initial"), change + of("pressed_in") - of("lost_between") - of("left_grid"),
              1e-9 * of("stored"));
  EXPECT_GT(runoff, 0) << "all rain enters, so runoff is not tested";
  EXPECT_NEAR(of("runoff"), runoff, 1e-12 * runoff);
  EXPECT_CONTAINS(join_all(wet.at("answer").at("sentences")), "of rain ran off; the water budget balances to");
}

TEST_F(WetReport, ColumnsOfHistoriesAreDescribed) {
  const auto describe = [](const json& table) {
    std::map<std::string, std::string> described;
    for (const json& c : table.at("columns")) {
      EXPECT_NE(c.at("quantity"), "state") << c.at("name");
      described[c.at("name")] = c.at("quantity").get<std::string>() + (c.at("largest") == true ? " largest" : "") +
                                (c.at("extensive") == true ? " extensive" : "") + " " + c.value("component", "-") +
                                " of " + c.at("of").get<std::string>();
    }
    return described;
  };
  auto body = describe(document().at("tables")[0]);
  EXPECT_EQ(body["largest_suction"], "suction largest - of ");
  EXPECT_EQ(body["water_mass"], "water_mass extensive - of ");
  EXPECT_EQ(body["momentum_y"], "momentum extensive y of ");
  const bool flows = std::any_of(body.begin(), body.end(), [](const auto& c) {
    return c.first.ends_with(".runoff") &&
           c.second == "water_flow extensive - of " + c.first.substr(0, c.first.size() - 7);
  });
  EXPECT_TRUE(flows);
}

TEST_F(WetReport, SeriesAreWrittenAsTheyAct) {
  const json& conditions = document().at("water").at("conditions");
  ASSERT_EQ(conditions.size(), 3u);
  EXPECT_EQ(conditions[0].at("series").at("values"), json({2.0, 2.5}));
  EXPECT_EQ(conditions[1].at("series").at("time"), json({0.0, 1.0, 1.0, 2.0, 2.0}));
  EXPECT_EQ(conditions[1]["series"].at("values"), json({20.0, 20.0, 3600.0, 3600.0, 0.0}));
  EXPECT_EQ(conditions[1]["series"].at("unit").at("name"), "mm/h");
  EXPECT_EQ(conditions[2].at("text"), "720 mm/h, vertical; what does not enter runs off");
  EXPECT_EQ(conditions[2].at("lines"), json({{{4.0, 3.0}, {7.0, 1.0}}}));
  const json& water = page_->results.at("result").at("water_states");
  ASSERT_EQ(water.size(), 1u);
  EXPECT_EQ(water[0].at("flow"), "hydrostatic");
  EXPECT_EQ(water[0].at("water_table"), json({{{0.0, 2.0}, {7.0, 1.0}, {10.0, 1.0}}}))
      << "level to the end of the ground";
}

TEST_F(WetReport, TheAssumptionsAreThoseOfThisWater) {
  const std::string text = join_all(document().at("assumptions"));
  EXPECT_LACKS(text, "Dry soil in one phase");
  EXPECT_CONTAINS(text, "Without pore water of its own: basalt. The given pore pressures are constant in it.");
  EXPECT_CONTAINS(text, "80 MPa, 27.5 times less than that of real water");
  // 1/(1 + n E_c/K_w) with E_c = 20 MPa · 0.7/(1.3 · 0.4), that is 88.1 and 99.5 %.
  EXPECT_CONTAINS(text, "water carries 88 % instead of 100 %");
  EXPECT_CONTAINS(text, "Conductivities are multiplied by 10 in stage 'rain'");
  EXPECT_LACKS(text, "does not fall with suction");
  EXPECT_LACKS(text, "drained:");
  EXPECT_CONTAINS(document().at("model").at("stages")[0].at("text").get<std::string>(),
                  "pore pressures held (drained)");
  EXPECT_CONTAINS(document().at("model").at("stages")[1].at("text").get<std::string>(), "conductivities times 10");
  const json& methods = document().at("methods");
  const auto has = [&](const char* name) { return std::find(methods.begin(), methods.end(), name) != methods.end(); };
  EXPECT_TRUE(has("seeping") && has("soil_water") && has("held_pressures") && has("hydraulic_conditions"));
  EXPECT_FALSE(has("steady_seepage") || has("pressure_smoothing"));
}

TEST_F(WetReport, DarcyFormulationHasNoWaterInertiaAndDoesNotLimitTheStep) {
  json changed = summary_;
  changed["input"]["stage"][1]["water"] = {{"value", "seeps"}, {"given", true}};
  const json document = collect_with(changed);
  const std::string text = join_all(document.at("assumptions"));
  EXPECT_CONTAINS(text, "though the time step does not depend on it");
  EXPECT_LACKS(text, "water hammer");
  EXPECT_CONTAINS(document.at("model").at("stages")[1].at("text").get<std::string>(), "water by Darcy's law");
  const json& methods = document.at("methods");
  EXPECT_NE(std::find(methods.begin(), methods.end(), "seeping"), methods.end());
  for (const char* other : {"two_phase", "water_storage"})
    EXPECT_EQ(std::find(methods.begin(), methods.end(), other), methods.end()) << other;
}

TEST_F(WetReport, RealWaterAndFallingConductivityAreNotCriticised) {
  json changed = summary_;
  changed["input"]["water"]["bulk_modulus"]["value"] = 2.2e6;
  changed["input"]["stage"][1]["conductivity_factor"]["value"] = 1;
  const std::string text = join_all(collect_with(changed).at("assumptions"));
  EXPECT_LACKS(text, "bulk modulus");
  EXPECT_LACKS(text, "multiplied");
  changed["input"]["water"]["bulk_modulus"]["value"] = nullptr;  // JSON has no infinity
  EXPECT_LACKS(join_all(collect_with(changed).at("assumptions")), "bulk modulus");
  changed["input"]["materials"]["silt"]["water"]["relative_conductivity"]["value"] = "constant";
  EXPECT_CONTAINS(join_all(collect_with(changed).at("assumptions")),
                  "The conductivity of silt does not fall with suction");
}

TEST_F(WetReport, EachFactorIsMarkedDrainedOrCoupled) {
  const auto leaf = [](const json& value) { return json{{"value", value}, {"given", true}}; };
  json changed = summary_;
  changed["input"]["analysis"]["kind"] = leaf("strength_reduction");
  changed["input"]["strength_reduction"] = {
      {"curve", {{"enabled", leaf(true)}, {"water", leaf("seeps")}, {"window", leaf(5)}}},
      {"frozen", {{"enabled", leaf(true)}, {"water", leaf("held")}}}};
  changed["factor_of_safety"] = {{"frozen",
                                  {{"factor", 1.2},
                                   {"uncertainty", 0.0104},
                                   {"mesh_effect", 0.01},
                                   {"meshes", {{{"factor", 1.2}, {"size", 0.7}}}}}},
                                 {"criteria", {{{"name", "jump"}, {"factor", 1.3}, {"note", ""}}}}};
  const json document = collect_with(changed);
  const json& factors = document.at("answer").at("factors");
  EXPECT_EQ(factors[0].at("water"), "held");
  EXPECT_EQ(factors[0].at("lower"), 1.189) << "of 1.1896: an interval is rounded outward";
  EXPECT_EQ(factors[0].at("upper"), 1.211) << "of 1.2104";
  EXPECT_EQ(factors[1].at("water"), "seeps");
  EXPECT_CONTAINS(join_all(document.at("answer").at("sentences")), "and pore pressures held (drained)");
  const std::string text = join_all(document.at("assumptions"));
  EXPECT_CONTAINS(text, "The factor at frozen geometry is drained");
  EXPECT_CONTAINS(text, "in the 5 s of a trial water moves");
}

TEST(DryReport, HasNoWater) {
  const fs::path folder = make_test_folder("dry");
  run_small_case(folder);
  const json document = collect_report(folder).document.get();
  EXPECT_FALSE(document.contains("water"));
  EXPECT_TRUE(document.at("model").at("water").empty());
  EXPECT_CONTAINS(join_all(document.at("assumptions")), "Dry soil in one phase");
  for (const json& m : document.at("model").at("materials")) EXPECT_FALSE(m.contains("water"));
  for (const json& f : document.at("answer").at("factors")) EXPECT_FALSE(f.contains("water"));
  for (const char* wet : {"two_phase", "soil_water", "held_pressures", "hydraulic_conditions"})
    for (const json& m : document.at("methods")) EXPECT_NE(m, wet);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
