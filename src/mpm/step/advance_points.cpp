// SPDX-License-Identifier: MIT
// The one pass over the points of soil of one phase.

#include "mpm/step/chunk_pass.hpp"
#include "mpm/step/dry_block.hpp"

namespace talus::mpm {
namespace {

template <int D>
struct DryPass : OneVelocityPass<D> {
  template <class Law>
  using Block = DryBlock<DryPass, Law>;
  using OneVelocityPass<D>::OneVelocityPass;

  TALUS_KERNEL void note_full(const BlockPlace<Body<D>>&, Mask) {}
};

}  // namespace

template <int D>
MoverLists advance_points(Dry, Body<D>& body, const StepOptions<D>& options) {
  return advance_blocks<DryPass<D>>(body, options);
}

template MoverLists advance_points<2>(Dry, Body<2>&, const StepOptions<2>&);
template MoverLists advance_points<3>(Dry, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
