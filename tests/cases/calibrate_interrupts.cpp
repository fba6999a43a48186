// SPDX-License-Identifier: MIT
// A calibration that is interrupted at any time ends with its sentence and code, and what it has found is not lost; a
// folder that cannot be used is refused before the search.

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/progress.hpp"
#include "input/read.hpp"
#include "laboratory/calibration.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus::laboratory {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Requests the end at one of the checks for signals.
struct Looks {
  static inline long count = 0, last = -1;  ///< checks so far; the check at which the end is requested, -1: none
  static inline fs::path file;              ///< at whose existence the end is requested

  static void look() {
    if (++count == last || (!file.empty() && fs::exists(file))) request_interrupt();
  }
  static void begin(long end, const fs::path& at = {}) {
    count = 0;
    last = end;
    file = at;
    watch_interrupts(look);
  }
  static void end() {
    watch_interrupts(nullptr);
    request_interrupt(false);
  }
};

/// Two triaxial tests on sand with c = 4 kPa and φ = 30°, by hand.
const std::string measured_soil =
    support::write_slope("sand", {"title=Sand", "materials.sand.cohesion=1", "materials.sand.friction_angle=25"}) + R"(
[[test]]
name = "a"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 50
axial_strain = 0.05
steps = 30
[[test]]
name = "b"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 200
axial_strain = 0.05
steps = 30
[calibration]
starts = 1
[[calibration.parameter]]
key = "materials.sand.cohesion"
min = 0
max = 20
[[calibration.parameter]]
key = "materials.sand.friction_angle"
min = 15
max = 45
[[calibration.curve]]
test = "a"
x = "axial_strain"
y = "q"
data = [[4, 113.856], [5, 113.856]]
x_unit = "%"
[[calibration.curve]]
test = "b"
x = "axial_strain"
y = "q"
data = [[4, 413.856], [5, 413.856]]
x_unit = "%"
)";

/// A fill on clay, with the settlement of a plate; one iteration, since only its course matters.
const std::string filled = R"(
title = "Fill"
geometry.polygon = [{ name = "clay", points = [[0, 0], [12, 0], [12, 4], [0, 4]] }]
geometry.line = [{ name = "ground", points = [[0, 4], [12, 4]] }]
regions.clay = "clay"
surcharge = [{ name = "fill", x = [0, 4], load = [30, 30] }]
initial = { stress = "k0", k0 = 0.6, pore_pressure = "water_table", water_table = [[0, 4], [12, 4]] }
hydraulic = [{ on = "ground", condition = "total_head", head = 4 }]
analysis.methods = ["fem"]
fem = { size = 2, meshes = 1 }
construction = [{ name = "load", duration = 2, add = ["fill"], factor = false }]
output.monitor = [{ name = "plate", at = [0.5, 4], measured_settlement = [["1 day", 12], ["2 day", 14]] }]
[calibration]
starts = 1
iterations = 1
parameter = [{ key = "materials.clay.young_modulus", min = "1 MPa", max = "10 MPa", start = "6 MPa", scale = "log" }]
monitor = [{ name = "plate", error = "1 mm" }]
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
)";

class CalibrateInterrupts : public testing::Test {
 protected:
  void TearDown() override { Looks::end(); }

  /// The sentence with which a calibration ends; "" without an error.
  std::string calibrate(const std::string& text, const fs::path& folder, long last, const fs::path& file = {},
                        bool resume = false) {
    CalibrationRun run;
    run.folder = folder;
    run.options.threads = 1;
    run.resume = resume;
    const input::LoadedCase loaded = input::read_case_text(text, "soil.toml", {}, input::CaseScope::whole_or_tests);
    Looks::begin(last, file);
    std::string sentence;
    testing::internal::CaptureStderr();
    try {
      run_calibration(loaded, run);
    } catch (const Error& error) {
      code_ = error.code();
      sentence = error.what();
    }
    Looks::end();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "a library writes no message of its own";
    return sentence;
  }

  const fs::path folder_ = support::make_scratch("calibrate_interrupts");
  ExitCode code_ = ExitCode::success;
};

TEST_F(CalibrateInterrupts, EndItAnywhereWithTheBestParameters) {
  ASSERT_EQ(calibrate(measured_soil, folder_ / "whole", -1), "");
  const long looks = Looks::count;
  ASSERT_GT(looks, 5);
  std::string sentence;
  for (long last = 1; last <= looks; ++last) {
    sentence = calibrate(measured_soil, folder_ / "out", last);
    EXPECT_EQ(code_, ExitCode::interrupted) << last;
    EXPECT_THAT(sentence, HasSubstr("interrupted")) << last;
    EXPECT_FALSE(fs::exists(folder_ / "out" / "calibration" / "calibration.json")) << last;
  }
  // The last check is after the search: the best values are those of the soil.
  const std::string key = " --set calibration.parameter.1.start=";
  ASSERT_THAT(sentence, HasSubstr(key));
  EXPECT_NEAR(std::stod(sentence.substr(sentence.find(key) + key.size())), 30, 0.05);
}

TEST_F(CalibrateInterrupts, AResumedSearchHasTheResultOfAWholeOne) {
  const auto read = [](const fs::path& folder) {
    auto result = nlohmann::json::parse(support::read_text(folder / "calibration" / "calibration.json"));
    result.erase("wall");
    return result;
  };
  ASSERT_EQ(calibrate(measured_soil, folder_ / "whole", -1), "");
  const long looks = Looks::count;
  const fs::path out = folder_ / "parts", file = out / "calibration" / "evaluations.jsonl";
  std::uintmax_t size = 0;
  for (const long last : {3L, looks / 2, looks - 1}) {
    EXPECT_THAT(calibrate(measured_soil, out, last, {}, true), HasSubstr("--resume")) << last;
    EXPECT_GT(fs::file_size(file), size) << last;
    size = fs::file_size(file);
  }
  // A kill cuts the last line.
  fs::resize_file(file, size - 5);
  ASSERT_EQ(calibrate(measured_soil, out, -1, {}, true), "");
  EXPECT_EQ(read(out), read(folder_ / "whole"));
  EXPECT_THAT(calibrate(measured_soil + "weight = 2\n", out, -1, {}, true), HasSubstr("another input"));
}

TEST_F(CalibrateInterrupts, AfterTheSearchKeepItsResult) {
  const fs::path out = folder_ / "fill";
  const std::string sentence = calibrate(filled, out, -1, out / list_file);
  EXPECT_EQ(code_, ExitCode::interrupted);
  EXPECT_THAT(sentence, HasSubstr("the fitted parameters are in '" + (out / "calibration").string() + "'"));
  const auto found = nlohmann::json::parse(support::read_text(out / "calibration" / "calibration.json"));
  EXPECT_GT(found.at("parameters")[0].at("value").get<double>(), 1e3);
}

TEST_F(CalibrateInterrupts, FoldersAreRefusedBeforeTheSearch) {
  EXPECT_THAT(calibrate(filled, "/", -1), HasSubstr("'/'"));
  EXPECT_EQ(code_, ExitCode::folder_exists);
  EXPECT_EQ(Looks::count, 0) << "nothing is calculated";
  std::ofstream(folder_ / "file") << "text";
  for (const std::string& text : {filled, measured_soil}) {
    EXPECT_THAT(calibrate(text, folder_ / "file", -1), HasSubstr((folder_ / "file").string()));
    EXPECT_EQ(Looks::count, 0);
    EXPECT_THAT(calibrate(text, folder_ / "file" / "below", -1), HasSubstr((folder_ / "file").string()));
    EXPECT_EQ(Looks::count, 0);
  }
}

}  // namespace
}  // namespace talus::laboratory
