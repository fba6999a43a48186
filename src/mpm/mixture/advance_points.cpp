// SPDX-License-Identifier: MIT
// The one pass over the points of the mixture: as heavy as soil and water, under effective stresses, with the water
// that solve_pressures() leaves them.

#include "mpm/mixture/mixture_block.hpp"
#include "mpm/mixture/mixture_step.hpp"
#include "mpm/step/chunk_pass.hpp"

namespace talus::mpm {
namespace {

template <int D>
struct DarcyPass : OneVelocityPass<D> {
  template <class Law>
  using Block = DarcyBlock<DarcyPass, Law>;
  using OneVelocityPass<D>::OneVelocityPass;
  Pack pressed_in{0.0};  ///< see Water::pressed_in [kg]

  TALUS_KERNEL void note_full(const BlockPlace<Body<D>>&, Mask) {}
  ChunkSums sum() const { return {sum_lanes(this->dissipated), sum_lanes(pressed_in)}; }
};

}  // namespace

template <int D>
MoverLists advance_points(Darcy, Body<D>& body, const StepOptions<D>& options) {
  return advance_blocks<DarcyPass<D>>(body, options);
}

template MoverLists advance_points<2>(Darcy, Body<2>&, const StepOptions<2>&);
template MoverLists advance_points<3>(Darcy, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
