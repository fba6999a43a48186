// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety in time: one transient seepage solution, and searches of slices at many of its times
// (docs/theory/24-timeline.md).

#include <memory>
#include <optional>

#include "ground/tell_seepage.hpp"
#include "results/run.hpp"
#include "run/options.hpp"

namespace talus::run {

class TimelineRun {
 public:
  TimelineRun(const input::Case& data, const RunOptions& options);
  ~TimelineRun();

  /// `first`: what slices found at time 0. Throws what seepage in time throws, and Error (interrupted).
  void calculate(const results::SliceResult& first);
  void tell(results::RunResult& run) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus::run
