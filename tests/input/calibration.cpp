// SPDX-License-Identifier: MIT
// [calibration]: the fitted parameters and curves of `talus calibrate`, and the messages on wrong input.

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "slope.hpp"

#include "input/case/uncertain_number.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

const std::string triaxial = R"(
[[test]]
name = "cell 100"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 100
axial_strain = 0.2
)";

const std::string fit = R"(
[calibration]
starts = 3

[[calibration.parameter]]
key = "materials.sand.cohesion"
start = 3
min = 0
max = "20 kPa"

[[calibration.parameter]]
key = "materials.sand.friction_angle"
start = 25
min = 10
max = "0.7 rad"

[[calibration.curve]]
test = "cell 100"
x = "axial_strain"
y = "q"
data = [[1, 0.1], [2, 0.15], [5, 0.2]]
x_unit = "%"
y_unit = "MPa"
error = "4 kPa"
)";

const std::string whole = slope + triaxial + fit;

std::string alter(const std::string& from, const std::string& to) {
  return slope + triaxial + change(fit, from, to);
}

/// All faults, a line each.
std::string list_faults(const std::string& text) {
  try {
    read_case_text(text, "case.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class CalibrationTable : public testing::Test {
 protected:
  /// The points of a curve whose table is `text`; the fault when there is one.
  std::vector<std::array<double, 2>> read(const std::string& text, std::string* fault = nullptr) {
    std::ofstream(folder_ / "curve.csv") << text;
    std::string changed = fit.substr(0, fit.find("data = ")) + "file = \"curve.csv\"\n";
    try {
      return read_case_text(slope + triaxial + changed, (folder_ / "case.toml").string())
          .data.calibration->curves[0]
          .points;
    } catch (const InputError& error) {
      if (fault != nullptr) *fault = error.what();
      return {};
    }
  }
  std::string find_table_fault(const std::string& text) {
    std::string fault;
    read(text, &fault);
    return fault;
  }

  const std::filesystem::path folder_ = support::make_scratch("table");
};

TEST(CalibrationInput, NumbersComeInTheUnitsOfTheirKeysAndQuantities) {
  const LoadedCase loaded = read_case_text(whole, "case.toml");
  ASSERT_TRUE(loaded.data.calibration.has_value());
  const Calibration& c = *loaded.data.calibration;
  EXPECT_DOUBLE_EQ(c.parameters[0].high, 20e3);
  EXPECT_DOUBLE_EQ(c.parameters[0].first, 3e3);
  EXPECT_NEAR(c.parameters[1].low, 10 * M_PI / 180, 1e-12);
  EXPECT_NEAR(c.parameters[1].high, 0.7, 1e-12);
  EXPECT_EQ(c.parameters[1].unit, "deg");
  ASSERT_EQ(c.curves[0].points.size(), 3u);
  EXPECT_DOUBLE_EQ(c.curves[0].points[1][0], 0.02);
  EXPECT_DOUBLE_EQ(c.curves[0].points[1][1], 0.15e6);
  EXPECT_DOUBLE_EQ(c.curves[0].deviation, 4e3);
  // Without an error it is 1 % of the largest value; without a start the search begins where the material is.
  const LoadedCase plain =
      read_case_text(slope + triaxial + change(change(fit, "error = \"4 kPa\"", ""), "start = 3\n", ""), "case.toml");
  EXPECT_DOUBLE_EQ(plain.data.calibration->curves[0].deviation, 2e3);
  EXPECT_DOUBLE_EQ(plain.data.calibration->parameters[0].first, plain.data.materials.at("sand").cohesion);
  // A case without the block has the input, and so the hash, that it always had.
  EXPECT_FALSE(read_case_text(slope, "case.toml").echo.get().contains("calibration"));
}

TEST(CalibrationInput, FaultsAreReportedWithTheirPlace) {
  expect_fault(alter("\"materials.sand.cohesion\"", "@@\"materials.sand.cohesoin\""),
               "material 'sand' has no number 'cohesoin'; did you mean 'cohesion'?");
  expect_fault(alter("\"materials.sand.cohesion\"", "@@\"materials.snad.cohesion\""),
               "there is no material 'snad'; did you mean 'sand'?");
  expect_fault(alter("\"materials.sand.cohesion\"", "@@\"gravity.acceleration\""), "is not a number of a material");
  expect_fault(alter("\"materials.sand.cohesion\"", "@@\"materials.sand.kappa\""),
               "material 'sand' has no number 'kappa'");
  expect_fault(whole + "[[calibration.parameter]]\nkey = @@\"materials.sand.cohesion\"\nmin = 0\nmax = 9\n",
               "'materials.sand.cohesion' is fitted twice");
  expect_fault(alter("start = 3", "start = @@30"),
               "'materials.sand.cohesion' begins at 30 kPa, outside 'min' and 'max', 0 kPa to 20 kPa");
  expect_fault(alter("max = \"20 kPa\"", "max = @@\"20 m\""), "'20 m' is a length");
  expect_fault(alter("max = \"0.7 rad\"", "max = @@95"),
               "'max' is 95 deg; 'friction_angle' must be at least 0 deg and");
  expect_fault(alter("max = \"0.7 rad\"", "max = @@5"), "'max' is 5 deg; it must be above 'min', 10 deg");
  expect_fault(alter("start = 3", "start = 3\nscale = @@\"log\""),
               "scale = \"log\" needs a 'min' above 0; it is 0 kPa");
  expect_fault(alter("\"cell 100\"", "@@\"cell 200\""), "there is no test 'cell 200'; did you mean 'cell 100'?");
  expect_fault(alter("y = \"q\"", "y = @@\"qq\""), "an element test has no 'qq'");
  expect_fault(alter("y = \"q\"", "y = @@\"axial_strain\""), "'x' and 'y' are both 'axial_strain'");
  expect_fault(alter("\"MPa\"", "@@\"mm\""), "is a length; q needs a stress");
  expect_fault(alter("data = [[1, 0.1], [2, 0.15], [5, 0.2]]", "data = @@[]"), "at least one row");
  expect_fault(slope + triaxial + fit.substr(0, fit.find("data = ")) + "file = @@\"none.csv\"\n",
               "there is no table 'none.csv'");
  expect_fault(alter("error = \"4 kPa\"", "error = @@\"4 m\""), "'4 m' is a length; error needs a stress");
}

TEST(CalibrationInput, ParametersMustBeFeltAndNotMoreThanTheValues) {
  EXPECT_NE(
      list_faults(slope + change(triaxial, "axial_strain = 0.2", "axial_strain = 0.2\nset = { cohesion = 1 }") + fit)
          .find("no curve feels 'materials.sand.cohesion'"),
      std::string::npos);
  EXPECT_NE(list_faults(alter(", [2, 0.15], [5, 0.2]", "")).find("1 measured value cannot fix 2 parameters"),
            std::string::npos);
  EXPECT_NE(list_faults(slope + triaxial + "[calibration]\n").find("has nothing to fit"), std::string::npos);
  // All at once.
  const std::string several = list_faults(change(alter("start = 3", "start = 30"), "y = \"q\"", "y = \"qq\""));
  EXPECT_NE(several.find("begins at 30 kPa"), std::string::npos) << several;
  EXPECT_NE(several.find("no 'qq'"), std::string::npos) << several;
}

TEST_F(CalibrationTable, ColumnsAreFoundByNameWithTheirUnits) {
  const std::vector<std::array<double, 2>> points{{0.01, 100e3}, {0.02, 150e3}};
  EXPECT_EQ(read("axial_strain [%],q [kPa]\n1,100\n2,150\n"), points);
  EXPECT_EQ(read("# a laboratory\nq [MPa],note,axial_strain\n0.1,a,0.01\n\n,b,0.015\n0.15,,0.02\n"), points);
  EXPECT_EQ(read("\xEF\xBB\xBF\"axial_strain [%]\";\"q [kPa]\"\r\n1,0;100\r\n2,0;150,0\r\n"), points)
      << "a spreadsheet's";
  EXPECT_EQ(read("axial_strain [%]\tq [kPa]\n1\t100\n2\t150\n"), points);
}

TEST_F(CalibrationTable, FaultsNameFileLineAndColumn) {
  EXPECT_NE(find_table_fault("axial_strain [%],p [kPa]\n1,100\n").find("curve.csv' has no column 'q'; it has"),
            std::string::npos);
  EXPECT_NE(find_table_fault("axial_strains [%],q [kPa]\n1,100\n").find("is it 'axial_strains'?"), std::string::npos);
  EXPECT_NE(find_table_fault("axial_strain,q\n1,100\n").find("has no unit; head it 'q [kPa]'"), std::string::npos);
  EXPECT_NE(find_table_fault("axial_strain,q [mm]\n1,100\n").find("is a length"), std::string::npos);
  EXPECT_NE(find_table_fault("axial_strain,q [kPa]\n1,100\n2,abc\n").find("curve.csv:3: 'abc' is not a number"),
            std::string::npos);
  EXPECT_NE(find_table_fault("axial_strain,q [kPa]\n").find("has no row"), std::string::npos);
}

TEST(NumberKeys, AreThoseOfTheMaterialsModel) {
  Material soil = read_case_text(slope, "case.toml").data.materials.at("sand");
  EXPECT_FALSE(find_number_key(soil, "kappa")->applies);
  EXPECT_TRUE(find_number_key(soil, "cohesion")->applies);
  EXPECT_FALSE(find_number_key(soil, "model").has_value()) << "no number";
  set_number(soil, "friction_angle", 0.5);
  EXPECT_DOUBLE_EQ(soil.friction_angle, 0.5);
  soil.given_void_ratio = 0.5;
  set_number(soil, "void_ratio", 1);
  EXPECT_DOUBLE_EQ(soil.porosity, 0.5) << "what follows from a number follows it";
}

}  // namespace
}  // namespace talus::input
