// SPDX-License-Identifier: MIT
#pragma once
// The points of a body, one after the other.

#include "mpm/solver/observe.hpp"

namespace talus::support {

/// Calls work(view) for every point on the grid.
template <int D, class Work>
void for_each_point(const mpm::Body<D>& body, Work&& work) {
  for (int id = 0; id < body.points.size(); ++id) {
    if (mpm::is_present(body, id)) work(id, mpm::view_point(body, id));
  }
}

}  // namespace talus::support
