// SPDX-License-Identifier: MIT
#pragma once
// Taking single points out of the slots of a block and putting them in: the book-keeping behind relocation.

#include "mpm/body/body.hpp"

namespace talus::mpm {

/// One point, out of its slot.
template <int D>
struct Record {
  int id = -1;
  int element = -1;
  double fields[Points<D>::state + material::max_state_size + D + 3] = {};  ///< the last ones are the water's

  double* xi() { return fields + Points<D>::xi; }
  const double* xi() const { return fields + Points<D>::xi; }
  double* stress() { return fields + Points<D>::stress; }
};

/// Copies the point at `place` (slot * lane_width + lane) of element `e`.
template <int D>
Record<D> read_point(const Points<D>& points, std::int64_t place, int e);

/// Takes the point in slot `k` of lane `lane` of block `b` out; the lane's last point fills the gap.
template <int D>
void remove_point(Points<D>& points, int b, int k, int lane);

/// Puts a point at the end of its element's lane. A block without a free slot moves to the end of the array with room
/// to grow; when that has left too many holes, all blocks are packed again (their points keep their slots' order).
template <int D>
void insert_point(Points<D>& points, const Record<D>& record);

/// Empty slots for `blocks` blocks; `used[b]` slots will be filled in block b.
template <int D>
void allocate_slots(Points<D>& points, const std::vector<int>& used);

}  // namespace talus::mpm
