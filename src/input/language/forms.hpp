// SPDX-License-Identifier: MIT
#pragma once
// Types for values whose notation does not follow from the C++ type of the member; a block wraps its member in one of
// them.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/language/time_table.hpp"

namespace talus::input {

// A number with the unit given by the user.

/// A number with its unit as in the file: 1.58, "212 mm", "5 %".
struct Amount {
  double number = 0;
  std::string unit;  ///< empty for a plain number
  std::string text;  ///< as in the file, for messages
};

/// Two opposite corners of a box: [[x_min, y_min], [x_max, y_max]].
struct Corners {
  std::array<double, 2>& min;
  std::array<double, 2>& max;
};

/// A list of arbitrary TOML values, stored as TOML texts.
struct TomlTexts {
  std::vector<std::string>& texts;
};

/// A number, or a text of a number and a unit, stored as TOML text: a value for another key.
struct TomlText {
  std::string& text;
};

/// A quantity that may change with time: one value, rows [[time, value], ...] with non-decreasing times (two rows at
/// one time are a jump), or { file, column } of a table. Unit and range of the key are those of the value.
struct Series {
  TimeTable& table;
};

/// Source of points in a file, as given, relative to the case file.
struct PointsFile {
  std::string file;
  std::string x, y;  ///< columns; both empty: columns x and y, or the first two
};

/// Points [[x, y], ...], or { file, x, y } of a table.
struct SurveyPoints {
  std::vector<std::array<double, 2>> points;
  std::optional<PointsFile> source{};  ///< source of points that are not read yet
};

/// A calendar date, optionally with a time of day: a TOML date, or a text of that form.
struct Date {
  double seconds = 0;  ///< since the start of 1970
};

/// Measured pairs [[suction, fraction], ...]: the unit of the key is that of the suction, fractions are from 0 to 1.
struct SuctionCurve {
  std::vector<std::array<double, 2>>& pairs;
};

/// A content stored in per cent: a plain number is in per cent, as is "0.88 %". T is double or std::optional<double>.
template <class T>
struct PerCent {
  T& value;
};

/// Rows [[position, fraction], ...] with increasing positions: depths, lengths or ages in the unit of the key.
/// Fractions are at least 0.
struct ShareTable {
  std::vector<std::array<double, 2>>& rows;
};

/// A number, or a list of turning points of a test.
struct Turns {
  std::vector<double>& values;
};

/// A key of the test's material with another value, as for --set.
struct PointSetting {
  std::string key;    ///< dotted path within the material
  std::string value;  ///< TOML text
};

}  // namespace talus::input
