// SPDX-License-Identifier: MIT
#pragma once
// A body partitioned among ranks for a stage, and its load balance.

#include <functional>
#include <vector>

#include "mpm/state/body.hpp"

namespace talus::run {

/// Returns the largest value over all ranks.
template <int D>
double find_largest(const mpm::Body<D>& body, double here);

/// The part of a body that this rank steps. The load balance migrates chunks between ranks when the times of the ranks
/// differ, as soil moves or a part of it costs more. Results do not depend on which rank owns a chunk, so timings
/// affect the wall-clock time only. All functions are collective.
template <int D>
class PartitionedBody {
 public:
  /// Partitions the body of rank 0. `whole`: the body, which every rank has (`all_have_it`) or rank 0 alone; null on
  /// the others. `description`: of the body (mpm::copy_description).
  PartitionedBody(mpm::Body<D>* whole, mpm::Body<D> description, bool all_have_it);

  mpm::Body<D>& part() { return part_; }
  /// Measures the time of each rank at every look, and repartitions the body if that saves time.
  void rebalance();
  /// Runs work that is no part of the steps, such as an output, and excludes its waiting time from the measurement.
  void leave_out(const std::function<void()>& work);
  /// Gathers the whole body from a state of the parts on rank 0, and calls `work` with it there. All ranks throw what
  /// `work` throws.
  void lead(const mpm::Body<D>& part, const std::function<void(const mpm::Body<D>&)>& work);
  /// Brings the whole body up to date where it is.
  void finish();

 private:
  mpm::Body<D>* whole_;
  bool all_have_it_;
  mpm::Body<D> part_;
  int looks_ = 0;
  double spent_ = 0, sent_ = 0;  ///< at the last measurement [s]
  double cost_ = 0;              ///< of the last rebalance [s]
};

}  // namespace talus::run
