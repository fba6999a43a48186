// SPDX-License-Identifier: MIT
// Units of values in a case file, and suggestions for misspelled words.

#include "base/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"

namespace talus {
namespace {

constexpr double pi = 3.14159265358979323846;

std::string find_complaint(const std::string& text, const std::string& wanted) {
  try {
    units::parse_as_si(text, wanted, "cohesion");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Units, ConvertEngineersUnitsToSiUnits) {
  EXPECT_DOUBLE_EQ(units::parse_as_si("45 MPa", "kPa", "E"), 45e6);
  EXPECT_DOUBLE_EQ(units::parse_as_si("2kPa", "kPa", "c"), 2e3);
  EXPECT_DOUBLE_EQ(units::parse_as_si("1 bar", "kPa", "c"), 1e5);
  EXPECT_DOUBLE_EQ(units::parse_as_si("2 kN/m2", "kPa", "c"), 2e3);
  EXPECT_DOUBLE_EQ(units::parse_as_si("30 deg", "deg", "phi"), pi / 6);
  EXPECT_DOUBLE_EQ(units::parse_as_si("1e-5 m/s", "m/s", "v"), 1e-5);
  EXPECT_DOUBLE_EQ(units::parse_as_si("36 mm/h", "m/s", "v"), 1e-5);
  EXPECT_DOUBLE_EQ(units::parse_as_si("2.65 g/cm3", "kg/m3", "rho"), 2650);
  EXPECT_DOUBLE_EQ(units::parse_as_si("-1.5 min", "s", "t"), -90);
  EXPECT_DOUBLE_EQ(units::parse_as_si("+981 cm/s2", "m/s2", "g"), 9.81);
}

TEST(Units, GiveTheSiFactorOfAUnit) {
  EXPECT_DOUBLE_EQ(units::get_si_factor("kPa"), 1000);
  EXPECT_DOUBLE_EQ(units::get_si_factor("deg"), pi / 180);
  EXPECT_DOUBLE_EQ(units::get_si_factor("mm"), 1e-3);
  EXPECT_DOUBLE_EQ(units::get_si_factor(""), 1);
}

TEST(Units, NameTheDimensionThatWasGivenAndTheOneThatIsNeeded) {
  EXPECT_EQ(find_complaint("2 kg", "kPa"), "'2 kg' is a mass; cohesion needs a stress such as \"2 kPa\"");
  EXPECT_EQ(find_complaint("30 deg", "kPa"), "'30 deg' is an angle; cohesion needs a stress such as \"2 kPa\"");
  EXPECT_EQ(find_complaint("2 kPa", "deg"), "'2 kPa' is a stress; cohesion needs an angle such as \"30 deg\"");
  EXPECT_EQ(find_complaint("2 A", "kPa"), "'2 A' is of another dimension; cohesion needs a stress such as \"2 kPa\"");
}

TEST(Units, KeepAnglesAndPlainNumbersApart) {
  // UDUNITS would convert 50 % to 0.5 rad.
  EXPECT_EQ(find_complaint("50 %", "deg"), "'50 %' is a number; cohesion needs an angle such as \"30 deg\"");
  EXPECT_NE(find_complaint("30 deg", "1"), "");
}

TEST(Units, KeepTimesAndRatesApart) {
  // UDUNITS would convert 2 Hz to 0.5 s.
  EXPECT_EQ(find_complaint("2 Hz", "s"), "'2 Hz' is a rate; cohesion needs a time such as \"2 s\"");
  EXPECT_EQ(find_complaint("3 s", "Hz"), "'3 s' is a time; cohesion needs a rate such as \"2 Hz\"");
}

TEST(Units, RefuseWhatIsNoQuantity) {
  EXPECT_NE(find_complaint("2", "kPa").find("without a unit"), std::string::npos);
  EXPECT_NE(find_complaint("two kPa", "kPa").find("finite number"), std::string::npos);
  EXPECT_NE(find_complaint("inf kPa", "kPa").find("finite number"), std::string::npos);
  EXPECT_NE(find_complaint("nan kPa", "kPa").find("finite number"), std::string::npos);
  EXPECT_NE(find_complaint("1e999 kPa", "kPa").find("finite number"), std::string::npos);
  EXPECT_NE(find_complaint("", "kPa"), "");
  EXPECT_EQ(find_complaint("2 kpa", "kPa"), "'kpa' is no known unit; did you mean 'kPa'?");
  EXPECT_NE(find_complaint("2 3 kPa", "kPa"), "") << "two numbers are a slip, not six kilopascals";
  EXPECT_NE(find_complaint("2 s since 2000-01-01", "s"), "") << "a date is no duration";
}

TEST(Units, AreSafeToUseFromSeveralThreads) {
  std::vector<std::thread> threads;
  std::vector<double> sums(4, 0.0);
  for (std::size_t i = 0; i < sums.size(); ++i)
    threads.emplace_back([&sums, i] {
      for (int k = 0; k < 200; ++k) sums[i] += units::parse_as_si("2 kPa", "MPa", "c") + units::get_si_factor("mm");
    });
  for (std::thread& thread : threads) thread.join();
  for (const double sum : sums) EXPECT_NEAR(sum, 200 * 2000.001, 1e-6);
}

TEST(Nearest, CountsASwapOfNeighboursAsOneSlip) {
  EXPECT_EQ(measure_edit_distance("cohesion", "cohesion"), 0);
  EXPECT_EQ(measure_edit_distance("cohesoin", "cohesion"), 1);
  EXPECT_EQ(measure_edit_distance("", "abc"), 3);
  EXPECT_EQ(measure_edit_distance("kitten", "sitting"), 3);
}

TEST(Nearest, FindsNothingWhereNothingIsNear) {
  EXPECT_EQ(find_nearest("porosty", {"cohesion", "porosity"}), "porosity");
  EXPECT_EQ(find_nearest("rain", {"cohesion", "porosity"}), "");
}

}  // namespace
}  // namespace talus
