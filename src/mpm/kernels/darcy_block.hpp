// SPDX-License-Identifier: MIT
#pragma once
// Hooks of the pass over the points in the Darcy (u-p) formulation: points have the mass of soil and water and
// effective stresses, and their water follows from solve_pressures().

#include <utility>

#include "mpm/kernels/g2p_p2g_kernels.hpp"
#include "mpm/kernels/water_lanes.hpp"

namespace talus::mpm {

/// Hooks for a block of soil that moves with its water.
template <class Pass, class Law>
struct DarcyBlock {
  using B = typename Pass::B;
  using T = typename B::Lanes;
  using Place = BlockPlace<B>;
  static constexpr int D = B::dimension, width = B::width;
  using W = WaterFields<D>;
  using Nodes = NodeVectors<B, 2, motion_stride<D>>;
  decltype(get_block_water<Law>(std::declval<const B&>(), 0, 0.0)) lanes;
  int first_field;
  double density;
  ElementMotion<D, T> motion;
  T volumetric, growth;
  T pushed;      ///< Δε_vol without smoothing, on which the pressures do work [-]
  T stretch;     ///< V_e/Σ V_p of full elements
  T share;       ///< water lost per pore volume (T22.6) [-]
  T content;     ///< water per pore volume of a full element, at the start of the step [-]
  T saturation;  ///< at the element's pressure at the start of the step [-]
  T pressure;    ///< at the end of the step [Pa]
  T seeping[D];  ///< Darcy flux, relative to the grains [m/s]
  MaskOf<T> wet;

  TALUS_KERNEL DarcyBlock(const Pass& pass, const Place& at)
      : DarcyBlock(pass, at, Nodes(pass.body.nodes.motion.data(), at.rows)) {}
  TALUS_KERNEL DarcyBlock(const Pass& pass, const Place& at, const Nodes& nodes)
      : lanes(get_block_water<Law>(pass.body, at.b, pass.options.conductivity_factor)),
        first_field(pass.body.water.first_field),
        density(pass.body.water.density),
        motion(nodes.of[0], nodes.of[1], at.g, pass.options.dt) {
    const auto& water = pass.body.water;
    wet = load<T>(&water.volume[at.first]) > T(0.0);
    stretch = load<T>(&water.stretch[at.first]);
    share = load<T>(&water.darcy.share[at.first]);
    saturation = select(wet, load<T>(&water.mean_saturation[at.first]), T(1.0));
    pressure = load<T>(&water.mean_pressure[at.first]);
    for (int d = 0; d < D; ++d) seeping[d] = load<T>(&water.darcy.flux[d][at.first]);
    T pores(0.0);
    for (std::size_t k = 0; k < water.darcy.pores.size(); ++k) pores += load<T>(&water.darcy.pores[k][at.first]);
    content = load<T>(&water.darcy.water[at.first]) / select(wet, pores, T(1.0));
    pushed = motion.grad[0][0] + motion.grad[1][1];
    if constexpr (D == 3) pushed += motion.grad[2][2];
    pushed = pushed * stretch;
  }
  TALUS_KERNEL void smooth(const Pass& pass, const Place& at) {
    volumetric = find_node_mean<B, 1>(pass.body.nodes.smoothed.data(), at.rows);
  }
  TALUS_KERNEL T distribute_water(const Pass&, const Place&, const FullElement<B, Law>&) const { return saturation; }
  TALUS_KERNEL void find_growth() { growth = 1.0 + select(wet, pushed, volumetric); }
  TALUS_KERNEL void add_to_nodes(const Pass& pass, const Place& at, T, const T out[D + 1][1 + 2 * D]) const {
    pass.add_to_nodes(at, out);
  }

  /// Pore water of the points of a slot.
  struct Slot {
    double* fields;
    T old_volume, mass;
    MaskOf<T> wet;

    TALUS_KERNEL Slot(const DarcyBlock& block, const SlotPoints<B>& points)
        : fields(points.p + block.first_field * width), old_volume(points.volume) {}
    TALUS_KERNEL void advance_velocity(const DarcyBlock&, const SlotPoints<B>&) {}
    template <class Update>
    TALUS_KERNEL T update_water(Pass& pass, const DarcyBlock& block, const Update& update,
                                const SlotPoints<B>& points) {
      wet = block.lanes.is_wet(points.material);
      const T pores = find_pores<T>(old_volume, points.mass * block.lanes.get_inverse_grain_density(points.material));
      mass = load<T>(fields + W::mass * width);
      if constexpr (Update::mixed) mass = select(update.element.full, block.density * block.content * pores, mass);
      mass = mass - block.density * pores * block.share;
      if (!pass.options.moving) {  // frozen pores keep the water that they would press out
        const T pressed = block.density * old_volume * block.saturation * block.pushed;
        mass = mass - pressed;
        pass.pressed_in -= select(points.active && wet, pressed, T(0.0));
      }
      mass = select(wet, mass, T(0.0));
      store(fields + W::pressure * width, select(wet, block.pressure, T(0.0)));
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) store(fields + (W::velocity + d) * width, points.u[d] + block.seeping[d]);
      return select(wet, block.saturation, T(1.0));
    }
    /// Fraction of the new volume that is soil. Gaps of wet soil are pores: they fill with water and air, and count.
    TALUS_KERNEL T find_solid_share(T opened) const { return 1.0 - select(wet, T(0.0), opened); }
    TALUS_KERNEL void store_fields() const { store(fields + W::mass * width, mass); }
    TALUS_KERNEL void keep(MaskOf<T> stays) { mass = select(stays, mass, T(0.0)); }
    TALUS_KERNEL void add_to(DarcyBlock&, SlotPoints<B>& points) const { points.mass += mass; }
  };
};

}  // namespace talus::mpm
