// SPDX-License-Identifier: MIT
// Fuzz target: the list of jobs of a study, and the results of a job.
#include <nlohmann/json.hpp>

#include "results/json.hpp"
#include "results/study.hpp"
#include "study/jobs.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto& path = talus::fuzz::as_file({data, size}, "jobs.json");
  talus::fuzz::try_to([&] {
    if (const auto jobs = talus::results::read_file<talus::results::StudyJobs>(path))
      talus::results::to_json(*jobs).dump();
  });
  talus::fuzz::try_to([&] {
    const talus::study::JobFolder folder(path.parent_path());
    for (int job = 0; job < folder.count(); ++job) folder.result_folder(job);
  });
  talus::fuzz::try_to([&] { talus::results::read_file<talus::results::JobResult>(path); });
  return 0;
}
