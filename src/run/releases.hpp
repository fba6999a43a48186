// SPDX-License-Identifier: MIT
#pragma once
// MPM that starts from times of a timeline: at the release, and beside it at an earlier and a later time.

#include <memory>
#include <vector>

#include "results/run.hpp"
#include "run/case_methods.hpp"

namespace talus::run {

template <int D>
class Releases {
 public:
  Releases(const CaseContext& context, CaseMethods<D>& methods) : context_(context), methods_(methods) {}

  /// Prepares MPM of the run at the time of release, if the timeline finds one.
  void prepare(results::RunResult& run);
  /// Runs the releases at other times, each in a folder of its own.
  void run_beside();
  /// Adds the releases to the timeline. `run`: the results of MPM at the release. `is_complete`: it did not fail.
  void add_results(const results::RunResult& run, bool is_complete);

 private:
  void run_one(ReleaseCase& other);

  const CaseContext& context_;
  CaseMethods<D>& methods_;
  std::unique_ptr<const ReleaseCase> released_;
  std::vector<ReleaseCase> beside_;
  std::vector<results::Release> results_beside_;  ///< of those that ran
};

}  // namespace talus::run
