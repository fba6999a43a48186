// SPDX-License-Identifier: MIT
// The one pass over the points of soil of one phase.

#include "mpm/step/block_pass.hpp"

namespace talus::mpm {
namespace {

template <int D>
struct DryPass;

/// A block without pore water, or with water that is held.
template <int D, class Law>
struct DryBlock {
  using Nodes = NodeVectors<D, 2, motion_stride<D>>;
  ElementMotion<D, Pack> motion;
  Pack volumetric, growth, saturation;

  TALUS_KERNEL DryBlock(const DryPass<D>& pass, const BlockPlace<D>& at)
      : DryBlock(pass, at, Nodes(pass.body.nodes.motion.data(), at.rows)) {}
  TALUS_KERNEL DryBlock(const DryPass<D>& pass, const BlockPlace<D>& at, const Nodes& nodes)
      : motion(nodes.of[0], nodes.of[1], at.g, pass.options.dt) {
    const auto& held = pass.body.elements.held_saturation;
    saturation = held.empty() ? Pack(1.0) : load<Pack>(&held[at.first]);
  }
  TALUS_KERNEL void smooth(const DryPass<D>& pass, const BlockPlace<D>& at) {
    volumetric = find_node_mean<D, 1>(pass.body.nodes.smoothed.data(), at.rows);
  }
  TALUS_KERNEL Pack share_water(const DryPass<D>&, const BlockPlace<D>&, const FullElement<D, Law>&) const {
    return saturation;
  }
  TALUS_KERNEL void find_growth() { growth = 1.0 + volumetric; }
  TALUS_KERNEL void add_to_nodes(const DryPass<D>& pass, const BlockPlace<D>& at, Pack,
                                 const Pack out[D + 1][1 + 2 * D]) const {
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k) add_rows<1 + 2 * D>(pass.body.nodes.sums.data(), at.rows + k * lane_width, out[k]);
  }

  /// The points of a slot have no water of their own.
  struct Slot {
    TALUS_KERNEL Slot(const DryBlock&, const SlotPoints<D>&) {}
    TALUS_KERNEL void advance_velocity(const DryBlock&, const SlotPoints<D>&) {}
    template <class Update>
    TALUS_KERNEL Pack update_water(const DryPass<D>&, const DryBlock& block, const Update&, const SlotPoints<D>&) {
      return block.saturation;
    }
    /// Gaps are no volume of the soil.
    TALUS_KERNEL Pack find_solid_share(Pack opened) const { return 1.0 - opened; }
    TALUS_KERNEL void store_fields() const {}
    TALUS_KERNEL void keep(Mask) {}
    TALUS_KERNEL void add_to(DryBlock&, SlotPoints<D>&) {}
  };
};

template <int D>
struct DryPass : OneVelocityPass<D> {
  template <class Law>
  using Block = DryBlock<D, Law>;
  using OneVelocityPass<D>::OneVelocityPass;

  TALUS_KERNEL void note_full(const BlockPlace<D>&, Mask) {}
};

}  // namespace

template <int D>
MoverLists advance_points(Dry, Body<D>& body, const StepOptions<D>& options) {
  return advance_blocks<DryPass<D>>(body, options);
}

template MoverLists advance_points<2>(Dry, Body<2>&, const StepOptions<2>&);
template MoverLists advance_points<3>(Dry, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
