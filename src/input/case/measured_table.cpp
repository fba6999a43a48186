// SPDX-License-Identifier: MIT
#include "input/case/measured_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/units.hpp"
#include "input/case/text_table.hpp"

namespace talus::input {
namespace {

[[noreturn]] void fail(const std::string& sentence) {
  throw Error(ExitCode::wrong_input, sentence);
}

struct Column {
  std::size_t number = 0;
  double factor = 1;
};

Column find_column(const TextTable& table, const PointQuantity& quantity) {
  const std::size_t number = table.find_column(quantity.name);
  const std::string& unit = table.header()[number].unit;
  if (unit.empty() && std::string(quantity.unit) == "Pa")
    fail(fmt::format("the column '{0}' of '{1}' has no unit; head it '{0} [kPa]' or with another stress", quantity.name,
                     table.file()));
  try {
    return {number, find_measured_factor(quantity, unit)};
  } catch (const Error& error) {
    fail(fmt::format("the column '{}' of '{}': {}", quantity.name, table.file(), error.what()));
  }
}

}  // namespace

const PointQuantity* find_point_quantity(const std::string& name) {
  const auto& list = list_point_quantities();
  const auto found = std::find_if(list.begin(), list.end(), [&](const PointQuantity& q) { return name == q.name; });
  return found == list.end() ? nullptr : &*found;
}

double find_measured_factor(const PointQuantity& quantity, const std::string& unit) {
  if (unit.empty() || unit == "-") {
    if (std::string(quantity.unit) == "Pa" && unit == "-")
      fail(fmt::format("'{}' is a stress and needs a unit such as kPa", quantity.name));
    return 1;
  }
  const std::string wanted = std::string(quantity.unit) == "Pa" ? "Pa" : "1";
  return units::parse_as_si("1 " + unit, wanted, quantity.name);
}

std::vector<std::array<double, 2>> read_measured_table(const std::filesystem::path& path, const PointQuantity& x,
                                                       const PointQuantity& y) {
  const TextTable table(path);
  std::vector<std::array<double, 2>> rows;
  if (table.rows() == 0) {
    fail(fmt::format("the table '{}' has no row with '{}' and '{}'", table.file(), x.name, y.name));
  }
  const Column columns[2]{find_column(table, x), find_column(table, y)};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.cell(i, columns[0].number).empty() || table.cell(i, columns[1].number).empty()) continue;
    std::array<double, 2>& row = rows.emplace_back();
    for (std::size_t k = 0; k < 2; ++k) row[k] = columns[k].factor * table.number(i, columns[k].number);
  }
  if (rows.empty()) fail(fmt::format("the table '{}' has no row with '{}' and '{}'", table.file(), x.name, y.name));
  return rows;
}

}  // namespace talus::input
