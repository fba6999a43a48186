// SPDX-License-Identifier: MIT
// Stiffness and conductivity of clay from the settlements and pore pressures of a fill: they are those with which the
// measurements were computed.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "input/read.hpp"
#include "laboratory/calibration.hpp"
#include "laboratory/stage_history.hpp"
#include "run/construction/stage_record.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

constexpr double day = 86400, year = 365.25 * day;

/// A fill as a surcharge on clay that drains to its ground. `monitors`: lines of the plate and of the cell.
std::string write_fill(const std::string& plate, const std::string& cell) {
  return R"(
title = "Fill"
[[geometry.polygon]]
name = "clay"
points = [[0, 0], [12, 0], [12, 4], [0, 4]]
[[geometry.line]]
name = "ground"
points = [[0, 4], [12, 4]]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 17
porosity = 0.5
cohesion = 40
friction_angle = 20
dilatancy_angle = 0
tensile_strength = 40
young_modulus = "3 MPa"
poisson_ratio = 0.3
[materials.clay.water]
retention = "saturated"
conductivity = "2e-9 m/s"
[regions]
clay = "clay"
[[surcharge]]
name = "fill"
x = [0, 4]
load = [30, 30]
[initial]
stress = "k0"
k0 = 0.6
pore_pressure = "water_table"
water_table = [[0, 4], [12, 4]]
[[hydraulic]]
on = "ground"
condition = "total_head"
head = 4
[analysis]
methods = ["fem"]
[fem]
size = 1.3
meshes = 1
[[construction]]
name = "load"
duration = 2
add = ["fill"]
factor = false
[[construction]]
name = "rest"
duration = "3 year"
factor = false
[[output.monitor]]
name = "plate"
at = [0.5, 4]
)" + plate +
         "[[output.monitor]]\nname = \"cell\"\nat = [1, 2]\n" + cell;
}

const std::string fit = R"(
[calibration]
starts = 1
[[calibration.parameter]]
key = "materials.clay.young_modulus"
min = "1 MPa"
max = "10 MPa"
start = "6 MPa"
scale = "log"
[[calibration.parameter]]
key = "materials.clay.water.conductivity"
min = "1e-10 m/s"
max = "1e-7 m/s"
start = "1e-8 m/s"
scale = "log"
[[calibration.monitor]]
name = "plate"
error = "1 mm"
[[calibration.monitor]]
name = "cell"
quantity = "pressure"
error = "0.5 kPa"
)";

std::string list_rows(const laboratory::StageHistory& history, std::size_t monitor, input::MonitoredQuantity quantity,
                      const char* unit, double si) {
  const std::vector<double> values = history.list_values(monitor, quantity);
  std::string rows;
  for (const double time : {2 * day, 30 * day, 90 * day, 0.5 * year, year, 2.5 * year})
    rows += fmt::format("{}[\"{:.17g} s\", \"{:.17g} {}\"]", rows.empty() ? "" : ", ", time,
                        run::read_in_time(history.times(), values, time) / si, unit);
  return "[" + rows + "]\n";
}

TEST(ConstructionFit, FindsTheSoilThatWasMeasured) {
  const input::LoadedCase truth = input::read_case_text(write_fill("", ""), "fill.toml");
  const laboratory::StageHistory history(truth.data);
  const std::string text =
      write_fill("measured_settlement = " + list_rows(history, 0, input::MonitoredQuantity::settlement, "mm", 1e-3),
                 "measured_pressure = " + list_rows(history, 1, input::MonitoredQuantity::pressure, "kPa", 1e3)) +
      fit;
  laboratory::CalibrationRun run;
  run.folder = support::make_scratch("construction_fit");
  const results::Calibration found = laboratory::run_calibration(input::read_case_text(text, "fill.toml"), run);
  ASSERT_EQ(found.parameters.size(), 2u);
  EXPECT_NEAR(found.parameters[0].value, 3e3, 0.01 * 3e3);
  EXPECT_NEAR(found.parameters[1].value, 2e-9, 0.03 * 2e-9);
  EXPECT_TRUE(found.parameters[0].error.has_value());
  ASSERT_EQ(found.curves.size(), 2u);
  const results::CalibratedCurve& plate = found.curves[0];
  EXPECT_EQ(plate.x.unit, "day");
  EXPECT_EQ(plate.y.unit, "mm");
  EXPECT_EQ(plate.at.size(), 6u);
  EXPECT_LT(plate.rms, 0.3);
  EXPECT_GT(plate.rms_before, 5);
  EXPECT_GT(plate.line.size(), 20u);
  EXPECT_EQ(found.curves[1].y.unit, "kPa");
  EXPECT_TRUE(std::filesystem::exists(run.folder / "calibration" / "calibration.json"));
  EXPECT_TRUE(std::filesystem::exists(run.folder / "construction_monitors.csv")) << "the stages of the fitted soil";
}

/// Measurements after a stage that fails are missed, and count so that soil that bears fits better.
TEST(ConstructionFit, MeasurementsAfterAFailureAreMissed) {
  const std::string text = write_fill("measured_settlement = [[\"1 day\", 5], [\"30 day\", 20]]\n", "") +
                           fit.substr(0, fit.rfind("[[calibration.monitor]]"));
  const input::LoadedCase loaded = input::read_case_text(text, "fill.toml",
                                                         {{"materials.clay.cohesion", "1"},
                                                          {"materials.clay.friction_angle", "0"},
                                                          {"materials.clay.tensile_strength", "1"}});
  const laboratory::CalibrationModel model(loaded.data);
  const auto found = model.compare({0.5, 0.5});
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->residuals[1], 100);
  EXPECT_GT(found->missing[0], 0.3);
}

TEST(ConstructionFit, StagesBeginWithoutMovement) {
  const std::string text = write_fill("measured_settlement = [[0, 0], [\"30 day\", 20]]\n", "") +
                           fit.substr(0, fit.rfind("[[calibration.monitor]]"));
  const input::LoadedCase loaded = input::read_case_text(text, "fill.toml");
  const laboratory::CalibrationModel model(loaded.data);
  const auto found = model.compare({0.5, 0.5});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->values[0][0], 0);
  EXPECT_EQ(found->missing[0], 0);
}

TEST(ConstructionFit, ARunIsNotReplaced) {
  const std::string text = write_fill("measured_settlement = [[\"1 day\", 5], [\"30 day\", 20]]\n", "") +
                           fit.substr(0, fit.rfind("[[calibration.monitor]]"));
  laboratory::CalibrationRun run;
  run.folder = support::make_scratch("fit_beside_run");
  write_atomically(run.folder / "summary.json", "{}");
  try {
    laboratory::run_calibration(input::read_case_text(text, "fill.toml"), run);
    FAIL() << "the run would be replaced";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::folder_exists);
  }
}

std::string find_fault(const std::string& text) {
  try {
    input::read_case_text(text, "fill.toml");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ConstructionFit, FaultsHaveOneSentence) {
  const std::string plate = "measured_settlement = [[\"1 day\", 5], [\"30 day\", 20]]\n", sound = write_fill(plate, ""),
                    head = fit.substr(0, fit.find("[[calibration.monitor]]"));
  EXPECT_THAT(find_fault(sound + head + "[[calibration.monitor]]\nname = \"plat\"\n"), HasSubstr("no monitor 'plat'"));
  EXPECT_THAT(find_fault(sound + head + "[[calibration.monitor]]\nname = \"plate\"\nquantity = \"lateral\"\n"),
              HasSubstr("monitor 'plate' has no measured_lateral"));
  EXPECT_THAT(find_fault(sound + head + "[[calibration.monitor]]\nname = \"plate\"\nerror = 3\n"),
              HasSubstr("\"3 mm\""));
  EXPECT_THAT(find_fault(sound + head), HasSubstr("[[calibration.monitor]]"));
}

}  // namespace
}  // namespace talus
