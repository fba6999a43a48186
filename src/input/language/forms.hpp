// SPDX-License-Identifier: MIT
#pragma once
// How a value is written where its C++ type alone does not say: a block wraps its member in one of these.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/language/time_table.hpp"

namespace talus::input {

// A number with the unit that the user gave it.

/// A number as the user writes it, with its unit: 1.58, "212 mm", "5 %".
struct Amount {
  double number = 0;
  std::string unit;  ///< empty for a plain number
  std::string text;  ///< as in the file, for people
};

/// Two opposite corners of a box: [[x_min, y_min], [x_max, y_max]].
struct Corners {
  std::array<double, 2>& min;
  std::array<double, 2>& max;
};

/// Any TOML values, kept as TOML texts.
struct TomlTexts {
  std::vector<std::string>& texts;
};

/// A number, or a text with a number and a unit, kept as TOML text: what another key would be set to.
struct TomlText {
  std::string& text;
};

/// A quantity that may change with time: one value, or rows [[time, value], ...] whose times do not decrease; two rows
/// at one time are a jump. The unit and the range of the key are those of the value. Or { file, column } of a table.
struct Series {
  TimeTable& table;
};

/// A day of the calendar, with a time of day: a TOML date, or a text of its form.
struct Date {
  double seconds = 0;  ///< since the start of 1970
};

/// Measured pairs [[suction, share], ...]: the unit of the key is that of the suction, the share lies from 0 to 1.
struct SuctionCurve {
  std::vector<std::array<double, 2>>& pairs;
};

/// A content that the program keeps in per cent: a plain number is per cent, and so is "0.88 %". T is double or
/// std::optional<double>.
template <class T>
struct PerCent {
  T& value;
};

/// Rows [[place, share], ...] whose first numbers increase: over a depth, a length or an age, whose unit is that of the
/// key. Shares are at least 0.
struct ShareTable {
  std::vector<std::array<double, 2>>& rows;
};

/// A number, or the list of numbers that a test passes one after the other.
struct Turns {
  std::vector<double>& values;
};

/// A key of the test's material with another value, as --set writes it.
struct PointSetting {
  std::string key;    ///< dotted path within the material
  std::string value;  ///< TOML text
};

}  // namespace talus::input
