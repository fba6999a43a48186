// SPDX-License-Identifier: MIT
#include "results/present.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, PresentReduction& r) {
  v.key("title", r.title, {"", "flow rule and mesh"});
  v.maybe("stable", r.stable, {"", "largest factor with equilibrium so far"});
  v.maybe("failed", r.failed, {"", "smallest factor without equilibrium so far"});
  v.key("trials", r.trials, {"", "trials so far"});
  v.key("mesh", r.mesh, {"", "mesh, and fields of the last trial"});
}

}  // namespace talus::results
