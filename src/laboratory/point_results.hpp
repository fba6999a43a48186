#pragma once
// What is kept of element tests: tables, and what point.json says of each.

#include <optional>
#include <string>

#include "input/case/result_names.hpp"
#include "laboratory/point_test.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

/// The whole curve as comma-separated text, stresses in `stress_unit`.
std::string write_point_table(const PointCurve& curve, const std::string& stress_unit);

/// The row with the largest |q|.
const PointRow& find_peak(const PointCurve& curve);

/// The value of a result [SI]: of the last row, or interpolated where the curve first reaches its strain; nothing when
/// it does not.
std::optional<double> find_point_result(const PointCurve& curve, const input::PointTest& test,
                                        const input::PointResultName& name);

/// Name, path, peak and end of a test; `file` is its table.
results::PointTest describe_point_test(const input::PointTest& test, const PointCurve& curve, const std::string& file);

}  // namespace talus::laboratory
