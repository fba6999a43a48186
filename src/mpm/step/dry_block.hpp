// SPDX-License-Identifier: MIT
#pragma once
// What the pass over the points asks of soil of one phase.

#include "mpm/step/block_pass.hpp"

namespace talus::mpm {

/// A block without pore water, or with water that is held.
template <class Pass, class Law>
struct DryBlock {
  using B = typename Pass::B;
  using T = typename B::Lanes;
  using Place = BlockPlace<B>;
  static constexpr int D = B::dimension;
  using Nodes = NodeVectors<B, 2, motion_stride<D>>;
  ElementMotion<D, T> motion;
  T volumetric, growth, saturation;

  TALUS_KERNEL DryBlock(const Pass& pass, const Place& at)
      : DryBlock(pass, at, Nodes(pass.body.nodes.motion.data(), at.rows)) {}
  TALUS_KERNEL DryBlock(const Pass& pass, const Place& at, const Nodes& nodes)
      : motion(nodes.of[0], nodes.of[1], at.g, pass.options.dt) {
    const auto& held = pass.body.elements.held_saturation;
    saturation = held.empty() ? T(1.0) : load<T>(&held[at.first]);
  }
  TALUS_KERNEL void smooth(const Pass& pass, const Place& at) {
    volumetric = find_node_mean<B, 1>(pass.body.nodes.smoothed.data(), at.rows);
  }
  TALUS_KERNEL T share_water(const Pass&, const Place&, const FullElement<B, Law>&) const { return saturation; }
  TALUS_KERNEL void find_growth() { growth = 1.0 + volumetric; }
  TALUS_KERNEL void add_to_nodes(const Pass& pass, const Place& at, T, const T out[D + 1][1 + 2 * D]) const {
    pass.give_rows(at, out);
  }

  /// The points of a slot have no water of their own.
  struct Slot {
    TALUS_KERNEL Slot(const DryBlock&, const SlotPoints<B>&) {}
    TALUS_KERNEL void advance_velocity(const DryBlock&, const SlotPoints<B>&) {}
    template <class Update>
    TALUS_KERNEL T update_water(const Pass&, const DryBlock& block, const Update&, const SlotPoints<B>&) {
      return block.saturation;
    }
    /// Gaps are no volume of the soil.
    TALUS_KERNEL T find_solid_share(T opened) const { return 1.0 - opened; }
    TALUS_KERNEL void store_fields() const {}
    TALUS_KERNEL void keep(MaskOf<T>) {}
    TALUS_KERNEL void add_to(DryBlock&, SlotPoints<B>&) {}
  };
};

}  // namespace talus::mpm
