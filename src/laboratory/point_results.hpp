// SPDX-License-Identifier: MIT
#pragma once
// What is kept of element tests: tables, charts, and what point.json says of each.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/case/result_names.hpp"
#include "laboratory/point_test.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

// How element tests are shown: which belong into one picture, over what, and with which line.

/// The groups of a case in the order of their first tests, without their pictures; four panels each. Tests that set the
/// same have one colour.
std::vector<results::PointGroup> group_tests(const std::vector<input::PointTest>& tests);

/// The whole curve as comma-separated text, stresses in `stress_unit`.
std::string write_point_table(const PointCurve& curve, const std::string& stress_unit);

/// A quantity as people read it: stresses in a unit of the case, strains in per cent.
struct Shown {
  results::ShownQuantity summary;
  double factor = 1;  ///< one of its unit in SI
};
Shown show_quantity(const std::string& name, const std::string& stress_unit);

/// Rows of which a chart is drawn, about `most`: turning points and the end are always among them.
std::set<std::size_t> choose_drawn(const PointCurve& curve, std::size_t most);

/// The value of a result [SI]: of the last row, or interpolated where the curve first reaches its strain; nothing when
/// it does not.
std::optional<double> find_point_result(const PointCurve& curve, const input::PointTest& test,
                                        const input::PointResultName& name);

/// Name, path, peak and end of a test; `file` is its table.
results::PointTest describe_point_test(const input::PointTest& test, const PointCurve& curve, const std::string& file);

}  // namespace talus::laboratory
