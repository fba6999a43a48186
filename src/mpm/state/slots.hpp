// SPDX-License-Identifier: MIT
#pragma once
// Removal of single points from the slots of a block and insertion into them, for relocation.

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Copy of one point outside the slots.
template <int D>
struct Record {
  int id = -1;
  int element = -1;
  double fields[Points<D>::state + material::max_state_size + D + 3] = {};  ///< the last ones are those of its water

  double* xi() { return fields + Points<D>::xi; }
  const double* xi() const { return fields + Points<D>::xi; }
  double* stress() { return fields + Points<D>::stress; }
};

/// Copies the point at `place` (slot * lane_width + lane) of element `e`.
template <int D>
Record<D> read_point(const Points<D>& points, std::int64_t place, int e);

/// Removes the point in slot `k` of lane `lane` of block `b`; the lane's last point fills the vacated slot.
template <int D>
void remove_point(Points<D>& points, int b, int k, int lane);

/// Appends a point to its element's lane. A block without a free slot moves to the end of the array, with spare slots;
/// when moved blocks have left too many holes, all blocks are packed again. The order of points in a block is
/// unchanged.
template <int D>
void insert_point(Points<D>& points, const Record<D>& record);

/// Allocates empty slots for `blocks` blocks; used[b] is the number that block b will use.
template <int D>
void allocate_slots(Points<D>& points, const std::vector<int>& used);

}  // namespace talus::mpm
