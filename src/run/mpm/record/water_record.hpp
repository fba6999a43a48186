// SPDX-License-Identifier: MIT
#pragma once
// Columns of pore water in the history of a run.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/solver/observe.hpp"
#include "output/files/history.hpp"

namespace talus::run {

/// Names of the hydraulic conditions; a repeated name is made unique.
std::vector<std::string> name_surfaces(const std::vector<mpm::SurfaceCondition>& surfaces);

/// The water columns of a history and their rows; flows are means since the previous row.
template <int D>
class WaterRecord {
 public:
  WaterRecord(const input::Case& data, const mpm::Body<D>& body);
  std::vector<output::Column> list_columns() const;
  /// Appends the values of the columns to `row`, and starts the next interval.
  void append(const mpm::Body<D>& body, const mpm::WaterState<D>& state, std::vector<double>& row);
  /// The state at the start of the interval, for a checkpoint.
  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  void begin_interval(const mpm::Body<D>& body);
  std::vector<std::string> names_;
  std::vector<bool> is_rain_;
  double density_, stress_;
  std::string stress_unit_;
  bool has_roots_ = false;
  double time_ = 0, transpired_ = 0;
  std::vector<mpm::SurfaceBudget> budgets_;
};

}  // namespace talus::run
