// SPDX-License-Identifier: MIT
#pragma once
// The results of a case, however its run ended: those of its methods, their comparison, and the files of the run.

#include <chrono>

#include "run/case_methods.hpp"
#include "run/releases.hpp"

namespace talus::run {

inline constexpr const char* summary_file = "summary.json";

/// The times at which a run began.
struct RunStart {
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  double cpu = find_process_seconds();  ///< [s]
};

/// Completes `run`, whose status is known, and writes summary.json and the fields of the water. `has_points`: MPM was
/// completed. After a finished run it removes the files that only a resumed run needs.
template <int D>
void write_case_results(const CaseContext& context, CaseMethods<D>& methods, Releases<D>& releases,
                        const RunStart& start, bool has_points, results::RunResult& run);

/// Writes the results so far of a run in progress.
template <int D>
void write_present_results(const CaseContext& context, const CaseMethods<D>& methods, results::RunResult run);

}  // namespace talus::run
