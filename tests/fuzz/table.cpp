// SPDX-License-Identifier: MIT
// Fuzz target: tables in text, a measured curve of a laboratory and the history of a run.
#include <cmath>
#include <cstdlib>

#include "input/case/calibration.hpp"
#include "output/files/history.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto& path = talus::fuzz::as_file({data, size}, "table.csv");
  const auto* x = talus::input::find_point_quantity("axial_strain");
  const auto* y = talus::input::find_point_quantity("q");
  if (x == nullptr || y == nullptr) std::abort();
  talus::fuzz::try_to([&] {
    for (const auto& row : talus::input::read_measured_table(path, *x, *y))
      if (!std::isfinite(row[0]) || !std::isfinite(row[1])) std::abort();
  });
  talus::fuzz::try_to([&] { talus::output::read_history(path); });
  return 0;
}
