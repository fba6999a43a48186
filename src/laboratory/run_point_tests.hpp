// SPDX-License-Identifier: MIT
#pragma once
// `talus point`: the element tests of a case, and the files of their results.

#include <filesystem>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "laboratory/point_test.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

struct PointOptions {
  std::filesystem::path folder;    ///< folder of point/
  std::vector<std::string> names;  ///< of the tests to run; empty: all
  std::string pictures = "svg";    ///< "svg" or "png"
};

/// Runs the tests and writes into folder/point: a table NAME.csv for each, a picture for each group, and point.json
/// last. Returns the content of point.json. Throws Error (wrong_input) if the case has no such tests, what
/// run_point_test() throws, and Error (cannot_write).
results::PointTests run_point_tests(const input::LoadedCase& loaded, const PointOptions& options);

/// Formats a short summary for the terminal.
std::string write_point_digest(const results::PointTests& tests);

}  // namespace talus::laboratory
