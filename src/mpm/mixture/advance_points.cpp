// SPDX-License-Identifier: MIT
// The one pass over the points of the mixture: as heavy as soil and water, under effective stresses, with the water
// that solve_pressures() leaves them.

#include "mpm/coupled/kernels.hpp"
#include "mpm/coupled/water_lanes.hpp"
#include "mpm/mixture/mixture_step.hpp"
#include "mpm/step/chunk_pass.hpp"

namespace talus::mpm {
namespace {

template <int D>
struct MixturePass;

template <int D, class Law>
struct MixtureBlock {
  using W = WaterFields<D>;
  using Nodes = NodeVectors<Body<D>, 2, motion_stride<D>>;
  WaterLanes<Law> lanes;
  int first_field;
  double density;
  ElementMotion<D, Pack> motion;
  Pack volumetric, growth;
  Pack pushed;      ///< strain that the pressures work on, which is not smoothed [-]
  Pack stretch;     ///< V_e/Σ V_p of full elements
  Pack share;       ///< what every pore loses [-]
  Pack content;     ///< of every pore of a full element, at the start [-]
  Pack saturation;  ///< at the element's pressure at the start of the step
  Pack pressure;    ///< and that at its end [Pa]
  Pack seeping[D];  ///< the water against the grains [m/s]
  Mask wet;

  TALUS_KERNEL MixtureBlock(const MixturePass<D>& pass, const BlockPlace<Body<D>>& at)
      : MixtureBlock(pass, at, Nodes(pass.body.nodes.motion.data(), at.rows)) {}
  TALUS_KERNEL MixtureBlock(const MixturePass<D>& pass, const BlockPlace<Body<D>>& at, const Nodes& nodes)
      : lanes(get_block_water<Law>(pass.body, at.b, pass.options.conductivity_factor)),
        first_field(pass.body.water.first_field),
        density(pass.body.water.density),
        motion(nodes.of[0], nodes.of[1], at.g, pass.options.dt) {
    const Water<D>& water = pass.body.water;
    wet = load<Pack>(&water.volume[at.first]) > Pack(0.0);
    stretch = load<Pack>(&water.stretch[at.first]);
    share = load<Pack>(&water.mixture.share[at.first]);
    saturation = select(wet, load<Pack>(&water.mean_saturation[at.first]), Pack(1.0));
    pressure = load<Pack>(&water.mean_pressure[at.first]);
    for (int d = 0; d < D; ++d) seeping[d] = load<Pack>(&water.mixture.flux[d][at.first]);
    Pack pores(0.0);
    for (const auto& of_material : water.mixture.pores) pores += load<Pack>(&of_material[at.first]);
    content = load<Pack>(&water.mixture.water[at.first]) / select(wet, pores, Pack(1.0));
    pushed = motion.grad[0][0] + motion.grad[1][1];
    if constexpr (D == 3) pushed += motion.grad[2][2];
    pushed = pushed * stretch;
  }
  TALUS_KERNEL void smooth(const MixturePass<D>& pass, const BlockPlace<Body<D>>& at) {
    volumetric = find_node_mean<Body<D>, 1>(pass.body.nodes.smoothed.data(), at.rows);
  }
  TALUS_KERNEL Pack share_water(const MixturePass<D>&, const BlockPlace<Body<D>>&,
                                const FullElement<Body<D>, Law>&) const {
    return saturation;
  }
  TALUS_KERNEL void find_growth() { growth = 1.0 + select(wet, pushed, volumetric); }
  TALUS_KERNEL void add_to_nodes(const MixturePass<D>& pass, const BlockPlace<Body<D>>& at, Pack,
                                 const Pack out[D + 1][1 + 2 * D]) const {
    pass.give_rows(at, out);
  }

  /// The water of the points of a slot.
  struct Slot {
    double* fields;
    Pack old_volume, mass;
    Mask wet;

    TALUS_KERNEL Slot(const MixtureBlock& block, const SlotPoints<Body<D>>& points)
        : fields(points.p + block.first_field * lane_width), old_volume(points.volume) {}
    TALUS_KERNEL void advance_velocity(const MixtureBlock&, const SlotPoints<Body<D>>&) {}
    template <class Update>
    TALUS_KERNEL Pack update_water(MixturePass<D>& pass, const MixtureBlock& block, const Update& update,
                                   const SlotPoints<Body<D>>& points) {
      wet = block.lanes.is_wet(points.material);
      const Pack pores =
          find_pores<Pack>(old_volume, points.mass * block.lanes.get_inverse_grain_density(points.material));
      mass = load<Pack>(fields + W::mass * lane_width);
      if constexpr (Update::mixed) mass = select(update.element.full, block.density * block.content * pores, mass);
      mass = mass - block.density * pores * block.share;
      if (!pass.options.moving) {  // frozen pores hold what they would press out
        const Pack pressed = block.density * old_volume * block.saturation * block.pushed;
        mass = mass - pressed;
        pass.pressed_in -= select(points.active && wet, pressed, Pack(0.0));
      }
      mass = select(wet, mass, Pack(0.0));
      store(fields + W::pressure * lane_width, select(wet, block.pressure, Pack(0.0)));
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) store(fields + (W::velocity + d) * lane_width, points.u[d] + block.seeping[d]);
      return select(wet, block.saturation, Pack(1.0));
    }
    /// Gaps of wet soil are pores: they fill with water and air.
    TALUS_KERNEL Pack find_solid_share(Pack opened) const { return 1.0 - select(wet, Pack(0.0), opened); }
    TALUS_KERNEL void store_fields() const { store(fields + W::mass * lane_width, mass); }
    TALUS_KERNEL void keep(Mask stays) { mass = select(stays, mass, Pack(0.0)); }
    TALUS_KERNEL void add_to(MixtureBlock&, SlotPoints<Body<D>>& points) const { points.mass += mass; }
  };
};

template <int D>
struct MixturePass : OneVelocityPass<D> {
  template <class Law>
  using Block = MixtureBlock<D, Law>;
  using OneVelocityPass<D>::OneVelocityPass;
  Pack pressed_in{0.0};  ///< see Water::pressed_in [kg]

  TALUS_KERNEL void note_full(const BlockPlace<Body<D>>&, Mask) {}
  ChunkSums sum() const { return {sum_lanes(this->dissipated), sum_lanes(pressed_in)}; }
};

}  // namespace

template <int D>
MoverLists advance_points(Mixture, Body<D>& body, const StepOptions<D>& options) {
  return advance_blocks<MixturePass<D>>(body, options);
}

template MoverLists advance_points<2>(Mixture, Body<2>&, const StepOptions<2>&);
template MoverLists advance_points<3>(Mixture, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
