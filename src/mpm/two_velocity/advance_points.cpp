// SPDX-License-Identifier: MIT
// G2P and P2G of the two-velocity formulation: the hooks by which the pass over the points updates velocity, mass and
// pressure of the pore water, and adds it to the nodal sums.

#include "mpm/backend/chunk_pass.hpp"
#include "mpm/kernels/water_lanes.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::mpm {
namespace {

template <int D, class Law>
struct WetBlock;

/// The pass over a chunk of soil with pore water, with the sums of its water.
template <int D>
struct WetPass : ChunkPass<D> {
  static constexpr int far = 30000;
  template <class Law>
  using Block = WetBlock<D, Law>;
  std::vector<int> newly_full;
  double density;        ///< ρ_w at zero pressure [kg/m³]
  Pack pressed_in{0.0};  ///< added to Water::pressed_in [kg]
  Pack pore_work{0.0};   ///< added to Work::pore_water [J]

  WetPass(Body<D>& b, const StepOptions<D>& o) : ChunkPass<D>(b, o), density(b.water.density) {}
  TALUS_KERNEL static void prefetch_node(const Body<D>& body, std::size_t row) {
    const double* motion = &body.water.motion[row * wet_motion_stride<D>];
    const double* sums = &body.water.sums[row * wet_sums_stride<D>];
    for (int c = 0; c < wet_motion_stride<D>; c += 8) __builtin_prefetch(motion + c, 0, 3);
    for (int c = 0; c < wet_sums_stride<D>; c += 8) __builtin_prefetch(sums + c, 1, 3);
  }
  TALUS_KERNEL static void prefetch_moment(const Body<D>& body, std::size_t i) {
    __builtin_prefetch(&body.elements.moments[i], 1, 3);
    __builtin_prefetch(&body.water.moments[i], 1, 3);
  }
  TALUS_KERNEL void note_full(const BlockPlace<Body<D>>& at, Mask newly) {
    if (!any(newly)) return;
    for (int l = 0; l < lane_width; ++l) {
      if (newly[l]) newly_full.push_back(at.b * lane_width + l);
    }
  }
  ChunkSums sum() const { return {sum_lanes(this->dissipated), sum_lanes(pressed_in), sum_lanes(pore_work)}; }
  static void collect_lists(Body<D>& body, const std::vector<std::optional<WetPass>>& passes) {
    std::vector<int>& all = body.water.newly_full;
    all.clear();
    for (const std::optional<WetPass>& pass : passes)
      if (pass) all.insert(all.end(), pass->newly_full.begin(), pass->newly_full.end());
  }
};

/// Pore water of the points of a slot.
template <int D, class Law>
struct WetSlot {
  using W = WaterFields<D>;
  double* fields;
  Pack w[D], old_volume, mass;
  PoreState<Pack> pore;
  Mask wet;

  TALUS_KERNEL WetSlot(const WetBlock<D, Law>& block, const SlotPoints<Body<D>>& points)
      : fields(points.p + block.first_field * lane_width), old_volume(points.volume) {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) w[d] = load<Pack>(fields + (W::velocity + d) * lane_width);
  }
  TALUS_KERNEL void advance_velocity(const WetBlock<D, Law>& block, const SlotPoints<Body<D>>& points) {
    block.water_motion.advance_velocity(points.xi, w);
  }

  /// Updates mass and pressure to the end of the step (T14.7); returns the saturation.
  template <class Update>
  TALUS_KERNEL Pack update_water(WetPass<D>& pass, const WetBlock<D, Law>& block, const Update& update,
                                 const SlotPoints<Body<D>>& points) {
    wet = block.lanes.is_wet(points.material);
    const Pack grains = points.mass * block.lanes.get_inverse_grain_density(points.material);  // volume [m³]
    const Pack pores = points.volume - grains;
    pore = block.shared_pore;
    mass = block.per_pores * pores;
    if (!update.none_partial) {
      const Mask own = Update::mixed ? points.active && wet && !update.element.full : points.active && wet;
      if (any(own)) update_own_water(pass, block, points, own, grains, pores);
    }
    return select(wet, pore.saturation, Pack(1.0));
  }
  TALUS_KERNEL void update_own_water(WetPass<D>& pass, const WetBlock<D, Law>& block, const SlotPoints<Body<D>>& points,
                                     Mask own, Pack grains, Pack pores) {
    const bool moving = pass.options.moving;
    const Pack pressure = load<Pack>(fields + W::pressure * lane_width);
    const Pack old_mass = load<Pack>(fields + W::mass * lane_width);
    const Pack saturation = moving ? Pack(0.0) : block.lanes.find_saturation(pressure, points.material);
    const Pack m = old_mass - pass.density * old_volume * block.find_lost(Pack(1.0), saturation, !moving);
    if (!moving) pass.pressed_in -= select(own, pass.density * old_volume * saturation * block.volumetric, Pack(0.0));
    const Pack content = select(own, m / (pass.density * pores), Pack(1.0));
    const Pack old_content = old_mass / (pass.density * (old_volume - grains));
    const Pack guess = pressure + (content - old_content) / load<Pack>(fields + W::capacity * lane_width);
    pore = select(own, block.lanes.find(content, guess, own, points.material), pore);
    mass = select(own, m, mass);
  }

  /// Fraction of the new volume that is soil. Gaps of wet soil are pores: they fill with water and air, and count.
  TALUS_KERNEL Pack find_solid_share(Pack opened) const { return 1.0 - select(wet, Pack(0.0), opened); }
  TALUS_KERNEL void store_fields() const {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) store(fields + (W::velocity + d) * lane_width, w[d]);
    store(fields + W::pressure * lane_width, pore.pressure);
    store(fields + W::capacity * lane_width, pore.capacity);
    store(fields + W::mass * lane_width, mass);
  }
  TALUS_KERNEL void keep(Mask stays) {
    const Pack none(0.0);
    mass = select(stays, mass, none);
    pore = select(stays, pore, PoreState<Pack>{none, none, none, none, none});
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) w[d] = select(stays, w[d], none);
  }
  /// P2G: adds the water to the sums, and χp to the stress of the points, so that the nodes receive the total stress.
  TALUS_KERNEL void add_to(WetBlock<D, Law>& block, SlotPoints<Body<D>>& points) const {
    TALUS_UNROLL
    for (int i = 0; i < D; ++i) points.s[i] += pore.bishop;
    block.sums.add({mass, select(wet, points.volume, Pack(0.0)), pore.pressure, pore.bishop, pore.saturation,
                    block.lanes.get_resistance(points.material), pore.relative},
                   points.xi, w);
  }
};

/// Hooks of the pass for a block of soil with pore water.
template <int D, class Law>
struct WetBlock {
  using W = WaterFields<D>;
  using Nodes = NodeVectors<Body<D>, 4, wet_motion_stride<D>>;
  using Slot = WetSlot<D, Law>;
  WaterLanes<Law> lanes;
  int first_field;
  ElementMotion<D, Pack> motion;
  WaterMotion<D, Pack> water_motion;
  Pack volumetric;    ///< Δε_s [-]
  Pack divergence;    ///< Δt div θ(w-v) [-]
  Pack surplus{0.0};  ///< of pressure smoothing, exchange and root uptake [-]
  Pack growth;
  // State that the points of a full element share.
  PoreState<Pack> shared_pore{Pack(0.0), Pack(0.0), Pack(0.0), Pack(0.0), Pack(-1.0)};
  Pack per_pores{0.0};  ///< m_w over pore volume [kg/m³]
  Pack stretch{1.0};    ///< V_e/Σ V_p
  WaterSums<D, Pack> sums;

  TALUS_KERNEL WetBlock(const WetPass<D>& pass, const BlockPlace<Body<D>>& at)
      : WetBlock(pass, at, Nodes(pass.body.water.motion.data(), at.rows)) {}
  TALUS_KERNEL WetBlock(const WetPass<D>& pass, const BlockPlace<Body<D>>& at, const Nodes& nodes)
      : lanes(get_block_water<Law>(pass.body, at.b, pass.options.conductivity_factor)),
        first_field(pass.body.water.first_field),
        motion(nodes.of[0], nodes.of[2], at.g, pass.options.dt),
        water_motion(nodes.of[1], nodes.of[3], at.g, pass.options.dt),
        divergence(water_motion.divergence) {
    if (has_surplus(pass.body, pass.options)) surplus = load<Pack>(&pass.body.water.surplus[at.first]);
  }
  TALUS_KERNEL void smooth(const WetPass<D>& pass, const BlockPlace<Body<D>>& at) {
    volumetric = find_node_mean<Body<D>, 4>(pass.body.water.smoothed.data(), at.rows);
    divergence = find_node_mean<Body<D>, 4>(pass.body.water.smoothed.data() + 1, at.rows);
  }
  /// Pores of a full element grow by its whole volume V̄, over which the flux is integrated as well. Only then is the
  /// work of the pressure in the momentum balance equal to that in the water balance.
  TALUS_KERNEL void find_growth() { growth = 1.0 + volumetric * stretch; }

  /// Volume of water lost per volume of soil. At frozen geometry the pores keep the water that they would press out.
  TALUS_KERNEL Pack find_lost(Pack soil_stretch, Pack saturation, bool frozen) const {
    Pack lost = divergence * soil_stretch + surplus;
    if (frozen) lost += saturation * volumetric * soil_stretch;
    return lost;
  }

  /// Updates water and pressure of full elements, whose points share them; returns their saturation.
  TALUS_KERNEL Pack distribute_water(WetPass<D>& pass, const BlockPlace<Body<D>>& at,
                                     const FullElement<Body<D>, Law>& element) {
    const Mask wet = element.full && lanes.is_wet(element.material);
    if (any(wet)) share_full_water(pass, at, element, wet);
    return select(lanes.is_wet(element.material), shared_pore.saturation, Pack(1.0));
  }
  TALUS_KERNEL void share_full_water(WetPass<D>& pass, const BlockPlace<Body<D>>& at,
                                     const FullElement<Body<D>, Law>& element, Mask wet) {
    using P = Points<D>;
    const P& points = pass.body.points;
    const bool moving = pass.options.moving;
    Pack grains(0.0), water(0.0);
    for (int k = 0; k < points.block_used[at.b]; ++k) {
      const Mask active = at.count > Pack(static_cast<double>(k));
      const double* p = points.slot(points.block_start[at.b] + k);
      const double* w = p + first_field * lane_width;
      grains += select(active, load<Pack>(p + P::mass * lane_width), Pack(0.0));
      water += select(active, load<Pack>(w + W::mass * lane_width), Pack(0.0));
    }
    grains *= lanes.get_inverse_grain_density(element.material);  // volume [m³]
    const Pack volume = select(wet, element.volume, Pack(1.0));
    const Pack saturation = load<Pack>(&pass.body.water.mean_saturation[at.first]);
    stretch = select(wet, load<Pack>(&pass.body.layout->volumes[at.first]) / volume, Pack(1.0));
    const Pack lost = find_lost(stretch, saturation, !moving);
    // The pressure of the first point is that of all points of the element.
    const double* first_point = points.slot(points.block_start[at.b]) + first_field * lane_width;
    const Pack old_content = water / (pass.density * (volume - grains));
    water -= pass.density * volume * lost;
    if (!moving) pass.pressed_in -= select(wet, pass.density * volume * stretch * volumetric * saturation, Pack(0.0));
    const Pack grown = moving ? 1.0 + volumetric * stretch : Pack(1.0);
    per_pores = select(wet, water / (volume * grown - grains), Pack(0.0));
    const Pack content = per_pores * (1 / pass.density);
    const Pack guess = load<Pack>(first_point + W::pressure * lane_width) +
                       (content - old_content) / load<Pack>(first_point + W::capacity * lane_width);
    shared_pore = lanes.find(content, guess, wet, element.material);
  }

  /// Work of the mean pressure of the step on pore growth and flux (T9.2). Exchange and root uptake move water without
  /// a nodal force and do no work here.
  TALUS_KERNEL Pack find_pore_work(const Water<D>& water, std::size_t first, Pack force_stretch) const {
    const Pack before = load<Pack>(&water.volume[first]) * load<Pack>(&water.stretch[first]);
    const Pack on_water = before * load<Pack>(&water.mean_pressure[first]) + sums.pressure * force_stretch;
    const Pack on_soil = before * load<Pack>(&water.mean_bishop[first]) + sums.bishop * force_stretch;
    return 0.5 * (on_water * divergence + on_soil * volumetric);
  }

  TALUS_KERNEL void add_to_nodes(WetPass<D>& pass, const BlockPlace<Body<D>>& at, Pack force_stretch,
                                 const Pack solid[D + 1][1 + 2 * D]) const {
    using C = WetColumns<D>;
    Water<D>& water = pass.body.water;
    Pack out[D + 1][C::count];
    copy_solid_columns<D>(solid, out);
    sums.to_nodes(at.g, force_stretch, out);
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k)
      add_rows<C::count, 0, wet_sums_stride<D>>(water.sums.data(), at.rows + k * lane_width, out[k]);
    pass.pore_work += select(at.count > Pack(0.0), find_pore_work(water, at.first, force_stretch), Pack(0.0));
    const Pack wet_volume = sums.volume[0];
    const Mask some = wet_volume > Pack(0.0);
    const Pack inverse = 1.0 / select(some, wet_volume, Pack(1.0));
    store(&water.volume[at.first], wet_volume);
    store(&water.stretch[at.first], force_stretch);
    store(&water.mean_saturation[at.first], sums.saturation * inverse);
    store(&water.mean_pressure[at.first], sums.pressure * inverse);
    store(&water.mean_bishop[at.first], sums.bishop * inverse);
    store(&water.mean_resistance[at.first], sums.resistance[0] / select(some, sums.relative[0], Pack(1.0)));
    double* moments = &water.moments[at.first * moment_size<D>];
    TALUS_UNROLL
    for (int i = 0; i < moment_size<D>; ++i) store(moments + i * lane_width, sums.moments[i]);
  }
};

}  // namespace

template <int D>
MoverLists advance_points(Wet, Body<D>& body, const StepOptions<D>& options) {
  return advance_blocks<WetPass<D>>(body, options);
}

template MoverLists advance_points<2>(Wet, Body<2>&, const StepOptions<2>&);
template MoverLists advance_points<3>(Wet, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
