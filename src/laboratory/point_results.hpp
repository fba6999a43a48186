// SPDX-License-Identifier: MIT
#pragma once
// Output of element tests: tables, groups of tests in one chart, and their summaries in point.json.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/case/result_names.hpp"
#include "laboratory/point_test.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

/// Groups the tests of a case in the order of the first test of each group, without pictures; each has four panels.
/// Tests with the same settings have the same colour.
std::vector<results::PointGroup> group_tests(const std::vector<input::PointTest>& tests);

/// Formats the whole curve as comma-separated text, stresses in `stress_unit`.
std::string write_point_table(const PointCurve& curve, const std::string& stress_unit);

/// A displayed quantity: stresses in a unit of the case, strains in per cent.
struct Shown {
  results::ShownQuantity summary;
  double factor = 1;  ///< one of its unit in SI
};
Shown show_quantity(const std::string& name, const std::string& stress_unit);

/// Returns about `most` rows for a chart, including all turning points and the end.
std::set<std::size_t> choose_drawn(const PointCurve& curve, std::size_t most);

/// Returns the value of a result [SI]: that of the last row, or interpolated where the curve first reaches the strain
/// of the result; nullopt if it does not.
std::optional<double> find_point_result(const PointCurve& curve, const input::PointTest& test,
                                        const input::PointResultName& name);

/// Summarises name, path, peak and end of a test; `file` is its table, `stress` the unit of its path.
results::PointTest describe_point_test(const input::PointTest& test, const PointCurve& curve, const std::string& file,
                                       const ShownUnit& stress);

}  // namespace talus::laboratory
