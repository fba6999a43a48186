// SPDX-License-Identifier: MIT
#pragma once
// Runs a problem of examples/verification with some changed keys through `talus run`, and reads its results.

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "input/read.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {

/// A finished run, whose folder goes with it.
class WaterRun {
 public:
  WaterRun(const std::string& file, const std::vector<input::Override>& overrides)
      : folder_(support::name_scratch("water")) {
    run::RunOptions options;
    options.folder = folder_;
    options.threads = 1;
    options.overwrite = true;
    const std::string path = std::string(TALUS_SOURCE_DIR) + "/examples/verification/" + file;
    summary = support::run_case(input::read_case(path, overrides), options);
    // Water is never made or destroyed, whatever the problem; in frozen geometry pores do not count as they are
    // strained.
    budget_error = summary.at("water").at("error").get<double>();
  }
  WaterRun(const WaterRun&) = delete;
  WaterRun& operator=(const WaterRun&) = delete;
  ~WaterRun() { std::filesystem::remove_all(folder_); }

  /// A column of history.csv or monitors.csv by its name without the unit, in the file's unit.
  std::vector<double> column(const std::string& name, const char* file = "history.csv") const {
    const output::HistoryTable table = output::read_history(folder_ / file);
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (table.columns[i].name == name) return table.values[i];
    ADD_FAILURE() << "no column " << name << " in " << file;
    return {0.0};
  }
  double last(const std::string& name) const { return column(name).back(); }
  output::Frame frame(double time) const {
    const output::ResultsReader frames(folder_);
    return frames.read(frames.find_nearest(time));
  }

  std::filesystem::path path(const char* file) const { return folder_ / file; }

  nlohmann::json summary;
  double budget_error = 0;

 private:
  std::filesystem::path folder_;
};

/// Component `c` of `count` of a field, by point.
inline std::vector<double> take(const output::Frame& frame, const std::string& name, int count = 1, int c = 0) {
  const output::Field* field = output::find(frame.point_fields, name);
  std::vector<double> values;
  if (field == nullptr) {
    ADD_FAILURE() << "no field " << name;
    return values;
  }
  for (std::size_t i = static_cast<std::size_t>(c); i < field->values.size(); i += static_cast<std::size_t>(count))
    values.push_back(field->values[i]);
  return values;
}

/// Calls `look(y, value)` with the height of the middle of each element [m] and the element's value. Points are
/// numbered element by element at the start, three to each, and must still be in their elements.
template <class Look>
void for_each_element(const output::Frame& frame, const std::string& name, Look look) {
  const std::vector<double> values = take(frame, name);
  std::vector<std::array<double, 2>> sums(values.size() / 3);
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto& sum = sums.at(static_cast<std::size_t>(frame.ids[i]) / 3);
    sum[0] += frame.positions[3 * i + 1] / 3;
    sum[1] += values[i] / 3;
  }
  for (const auto& sum : sums) look(sum[0], sum[1]);
}

}  // namespace talus
