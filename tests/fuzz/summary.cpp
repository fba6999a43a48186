// SPDX-License-Identifier: MIT
// Fuzz target: result files in JSON, read for a report.
#include <nlohmann/json.hpp>

#include "results/json.hpp"
#include "results/run.hpp"
#include "results/study.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto& path = talus::fuzz::as_file({data, size}, "summary.json");
  talus::fuzz::try_to([&] {
    if (const auto run = talus::results::read_file<talus::results::RunResult>(path))
      talus::results::to_json(*run).dump();
  });
  talus::fuzz::try_to([&] { talus::results::read_file<talus::results::StudyResult>(path); });
  return 0;
}
