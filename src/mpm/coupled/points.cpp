// The one pass of the coupled step over the points: both velocities, position, strain, stress, volume, water and
// pressure, and the nodal sums of the next step.

#include "base/parallel.hpp"
#include "mpm/body/rows.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/kernels.hpp"
#include "mpm/coupled/water_lanes.hpp"
#include "mpm/step/full_element.hpp"

namespace talus::mpm {
namespace {

/// Everything a block's pass needs that does not change from block to block.
template <int D>
struct Pass {
  Body<D>& body;
  const StepOptions<D>& options;
  std::vector<Mover>& movers;
  std::vector<int>& newly_full;
  double density;        ///< ρ_w at zero pressure [kg/m³]
  Pack dissipated{0.0};  ///< plastic work of this pass, by lane [J]
  Pack pressed_in{0.0};  ///< see Water::pressed_in [kg]
};

/// See prefetch_block() of one phase.
template <int D>
TALUS_KERNEL void prefetch_block(const Body<D>& body, int b) {
  const Points<D>& points = body.points;
  const char* data = reinterpret_cast<const char*>(points.slot(points.block_start[b]));
  const std::int64_t bytes = static_cast<std::int64_t>(points.block_used[b]) * points.fields * lane_width * 8;
  for (std::int64_t i = 0; i < bytes; i += 64) __builtin_prefetch(data + i, 1, 3);
  const int* rows = &body.layout->connectivity[static_cast<std::size_t>(b) * (D + 1) * lane_width];
  for (int i = 0; i < (D + 1) * lane_width; ++i) {
    const double* motion = &body.water.motion[static_cast<std::size_t>(rows[i]) * wet_motion_stride<D>];
    const double* sums = &body.water.sums[static_cast<std::size_t>(rows[i]) * wet_sums_stride<D>];
    for (int c = 0; c < wet_motion_stride<D>; c += 8) __builtin_prefetch(motion + c, 0, 3);
    for (int c = 0; c < wet_sums_stride<D>; c += 8) __builtin_prefetch(sums + c, 1, 3);
  }
  const std::size_t moments = static_cast<std::size_t>(b) * moment_size<D> * lane_width;
  for (int i = 0; i < moment_size<D>; ++i) {
    __builtin_prefetch(&body.elements.moments[moments] + i * lane_width, 1, 3);
    __builtin_prefetch(&body.water.moments[moments] + i * lane_width, 1, 3);
  }
}

/// What an element's water does in a step.
struct WaterIncrement {
  Pack divergence;  ///< Δt div θ(w-v) [-]
  Pack surplus;     ///< of pressure smoothing [-]
  Pack volumetric;  ///< Δε_s [-]

  /// Volume of water lost per volume of soil; in frozen pores those keep what they would press out.
  Pack find_lost(Pack stretch, Pack saturation, bool frozen) const {
    Pack lost = divergence * stretch + surplus;
    if (frozen) lost += saturation * volumetric * stretch;
    return lost;
  }
};

/// Pressure and water that a full element gives to all its points.
struct FullWater {
  PoreState<Pack> pore{Pack(0.0), Pack(0.0), Pack(0.0), Pack(0.0), Pack(-1.0)};
  Pack per_pores{0.0};  ///< m_w over pore volume [kg/m³]
  Pack stretch{1.0};    ///< V_e/Σ V_p
};

template <int D, class Element, class Lanes>
FullWater update_full_water(Pass<D>& pass, const Element& element, const Lanes& lanes, int b, Pack count,
                            const WaterIncrement& increment) {
  using P = Points<D>;
  using W = WaterFields<D>;
  const P& points = pass.body.points;
  const int first = pass.body.water.first_field;
  FullWater full;
  const Mask wet = element.full && lanes.is_wet(element.material);
  if (!any(wet)) return full;
  Pack grains(0.0), water(0.0);
  for (int k = 0; k < points.block_used[b]; ++k) {
    const Mask active = count > Pack(static_cast<double>(k));
    const double* p = points.slot(points.block_start[b] + k);
    const double* w = p + first * lane_width;
    grains += select(active, load<Pack>(p + P::mass * lane_width), Pack(0.0));
    water += select(active, load<Pack>(w + W::mass * lane_width), Pack(0.0));
  }
  grains *= lanes.get_inverse_grain_density(element.material);  // their volume
  const std::size_t block = static_cast<std::size_t>(b) * lane_width;
  const Pack volume = select(wet, element.volume, Pack(1.0));
  full.stretch = select(wet, load<Pack>(&pass.body.layout->volumes[block]) / volume, Pack(1.0));
  const Pack lost =
      increment.find_lost(full.stretch, load<Pack>(&pass.body.water.mean_saturation[block]), !pass.options.moving);
  const double* first_point = points.slot(points.block_start[b]) + first * lane_width;  // it has the others' pressure
  const Pack old_content = water / (pass.density * (volume - grains));
  water -= pass.density * volume * lost;
  if (!pass.options.moving)
    pass.pressed_in -= select(wet,
                              pass.density * volume * full.stretch * increment.volumetric *
                                  load<Pack>(&pass.body.water.mean_saturation[block]),
                              Pack(0.0));
  const Pack growth = pass.options.moving ? 1.0 + increment.volumetric * full.stretch : Pack(1.0);
  full.per_pores = select(wet, water / (volume * growth - grains), Pack(0.0));
  const Pack content = full.per_pores * (1 / pass.density);
  const Pack guess = load<Pack>(first_point + W::pressure * lane_width) +
                     (content - old_content) / load<Pack>(first_point + W::capacity * lane_width);
  full.pore = lanes.find(content, guess, wet, element.material);
  return full;
}

template <bool Mixed, int D, class Law>
void advance_block(Pass<D>& pass, const Law& law, int b) {
  using P = Points<D>;
  using W = WaterFields<D>;
  using C = WetColumns<D>;
  constexpr int NS = P::stress_size;
  Body<D>& body = pass.body;
  const StepOptions<D>& o = pass.options;
  P& points = body.points;
  const auto lanes = get_block_water<Law>(body, b, o.conductivity_factor);
  const std::size_t block = static_cast<std::size_t>(b);
  const int* rows = &body.layout->connectivity[block * (D + 1) * lane_width];
  const int first_water = body.water.first_field;

  Pack a[D + 1][D], aw[D + 1][D], v[D + 1][D], flux[D + 1][D], g[D * D];
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k) {
    Pack motion[4 * D];
    load_rows<4 * D, wet_motion_stride<D>>(body.water.motion.data(), rows + k * lane_width, motion);
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      a[k][d] = motion[d];
      aw[k][d] = motion[D + d];
      v[k][d] = motion[2 * D + d];
      flux[k][d] = motion[3 * D + d];
    }
  }
  TALUS_UNROLL
  for (int i = 0; i < D * D; ++i) g[i] = load<Pack>(&body.layout->gradients[(block * D * D + i) * lane_width]);
  const ElementMotion<D, Pack> motion(a, v, g, o.dt);
  const WaterMotion<D, Pack> water_motion(aw, flux, g, o.dt);
  Rotation<D, Pack> rotation;
  if (o.objective) rotation = Rotation<D, Pack>(motion.grad);
  const Pack count = load<Pack>(&points.count[block * lane_width]);

  Pack d_epsilon[NS];
  motion.strain(d_epsilon);
  WaterIncrement increment{water_motion.divergence, Pack(0.0), d_epsilon[0] + d_epsilon[1] + d_epsilon[2]};
  Pack pending(0.0);
  const bool stable = o.smoothing == input::Smoothing::stable;
  if (o.smoothing != input::Smoothing::none) {  // (2.95), recomposed over three components
    Pack mean(0.0), divergence(0.0);
    for (int l = 0; l < lane_width; ++l) {
      double s = 0, q = 0;
      for (int k = 0; k <= D; ++k) {
        const double* node = &body.water.smoothed[static_cast<std::size_t>(rows[k * lane_width + l]) * 4];
        s += node[0];
        q += node[1];
      }
      mean.value[l] = s / (D + 1);
      divergence.value[l] = q / (D + 1);
    }
    const Pack correction = (mean - increment.volumetric) * (1.0 / 3);
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) d_epsilon[i] += correction;
    increment.volumetric = mean;
    increment.divergence = divergence;
    if (stable) pending = load<Pack>(&body.elements.return_pressure[block * lane_width]);
  }
  if (has_surplus(body, o)) increment.surplus = load<Pack>(&body.water.surplus[block * lane_width]);
  double* strain = &body.elements.strain[block * NS * lane_width];
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) store(strain + i * lane_width, load<Pack>(strain + i * lane_width) + d_epsilon[i]);

  const StressIncrement<D> stress_increment{rotation, d_epsilon, pending, body.time};
  FullElement<D, Law> element;
  FullWater full_water;
  if constexpr (Mixed) {
    element = gather_full_elements(body, law, b, count);
    if (any(element.full)) full_water = update_full_water(pass, element, lanes, b, count, increment);
    const Pack saturation = select(lanes.is_wet(element.material), full_water.pore.saturation, Pack(1.0));
    update_full_elements(body, o, law, b, stress_increment, saturation, element);
  }
  // The pores of a full element grow as the flux is integrated, over its whole volume: only so does the work of the
  // pressure in the balance of forces equal that in the balance of water.
  const Pack growth = 1.0 + increment.volumetric * full_water.stretch;
  const bool none_partial = Mixed && all(element.full || !(count > Pack(0.0)));

  ElementSums<D, Pack> sums;
  WaterSums<D, Pack> water_sums;
  Pack staying_volume(0.0), all_volume(0.0), plastic_mean(0.0), dissipated(0.0), first_material(-1.0);
  Mask uniform(true);
  for (int k = 0; k < points.block_used[b]; ++k) {
    const std::int64_t slot = points.block_start[b] + k;
    double* p = points.slot(slot);
    double* water = p + first_water * lane_width;
    const Mask active = count > Pack(static_cast<double>(k));
    Pack xi[D], u[D], w[D], s[NS], q[material::max_state_size];
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      xi[d] = load<Pack>(p + (P::xi + d) * lane_width);
      u[d] = load<Pack>(p + (P::velocity + d) * lane_width);
      w[d] = load<Pack>(water + (W::velocity + d) * lane_width);
    }
    Pack volume = load<Pack>(p + P::volume * lane_width), mass = load<Pack>(p + P::mass * lane_width);
    const Pack old_volume = volume;
    motion.advance_velocity(xi, u);
    water_motion.advance_velocity(xi, w);
    if (o.moving) {
      motion.advance_position(xi);
      volume *= growth;
    }
    Pack material(0.0);
    if constexpr (!Law::is_single) material = lane_materials(points, slot);
    const Mask wet = lanes.is_wet(material);
    const Pack grains = mass * lanes.get_inverse_grain_density(material);  // their volume
    const Pack pores = volume - grains;
    PoreState<Pack> pore = full_water.pore;
    Pack water_mass = full_water.per_pores * pores;
    if (!none_partial) {
      const Mask own = Mixed ? active && wet && !element.full : active && wet;
      if (any(own)) {
        const Pack pressure = load<Pack>(water + W::pressure * lane_width);
        const Pack old_mass = load<Pack>(water + W::mass * lane_width);
        const Pack saturation = o.moving ? Pack(0.0) : lanes.find_saturation(pressure, material);
        const Pack m = old_mass - pass.density * old_volume * increment.find_lost(Pack(1.0), saturation, !o.moving);
        if (!o.moving)
          pass.pressed_in -= select(own, pass.density * old_volume * saturation * increment.volumetric, Pack(0.0));
        const Pack content = select(own, m / (pass.density * pores), Pack(1.0));
        const Pack old_content = old_mass / (pass.density * (old_volume - grains));
        const Pack guess = pressure + (content - old_content) / load<Pack>(water + W::capacity * lane_width);
        const PoreState<Pack> mine = lanes.find(content, guess, own, material);
        water_mass = select(own, m, water_mass);
        pore.pressure = select(own, mine.pressure, pore.pressure);
        pore.saturation = select(own, mine.saturation, pore.saturation);
        pore.bishop = select(own, mine.bishop, pore.bishop);
        pore.relative = select(own, mine.relative, pore.relative);
        pore.capacity = select(own, mine.capacity, pore.capacity);
      }
    }
    const int* ids = &points.id[static_cast<std::size_t>(slot * lane_width)];
    const material::Response<Pack> response =
        update_point_stress<Mixed>(o, law, element, stress_increment, p, ids, none_partial, active, material,
                                   select(wet, pore.saturation, Pack(1.0)), s, q);
    if constexpr (Law::is_plastic) {
      if (response.any_plastic) {
        const Pack v_p = select(active, volume, Pack(0.0));
        dissipated += v_p * select(active, response.dissipation, Pack(0.0));
        plastic_mean += v_p * select(active, response.plastic_mean_stress, Pack(0.0));
      }
      if (stable) all_volume += select(active, volume, Pack(0.0));
    }
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      store(p + (P::velocity + d) * lane_width, u[d]);
      store(water + (W::velocity + d) * lane_width, w[d]);
      if (o.moving) store(p + (P::xi + d) * lane_width, xi[d]);
    }
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) store(p + (P::stress + i) * lane_width, s[i]);
    if (o.moving) store(p + P::volume * lane_width, volume);
    store(water + W::pressure * lane_width, pore.pressure);
    store(water + W::capacity * lane_width, pore.capacity);
    store(water + W::mass * lane_width, water_mass);
    if (Mixed || response.any_plastic) {
      for (int i = 0; i < law.state_size; ++i) store(p + (P::state + i) * lane_width, q[i]);
    }

    Mask stays = active;
    if (o.moving) {
      const Mask outside = active && smallest_shape<D>(xi) < Pack(0.0);
      if (any(outside)) {
        pass.movers.push_back({b, k, to_bits(outside)});
        stays = active && !outside;
      }
    }
    if (!all(stays)) {  // empty lanes may hold anything, also what is no number
      const Pack none(0.0);
      mass = select(stays, mass, none);
      volume = select(stays, volume, none);
      water_mass = select(stays, water_mass, none);
      pore.pressure = select(stays, pore.pressure, none);
      pore.saturation = select(stays, pore.saturation, none);
      pore.bishop = select(stays, pore.bishop, none);
      pore.relative = select(stays, pore.relative, none);
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) {
        xi[d] = select(stays, xi[d], none);
        u[d] = select(stays, u[d], none);
        w[d] = select(stays, w[d], none);
      }
      TALUS_UNROLL
      for (int i = 0; i < NS; ++i) s[i] = select(stays, s[i], none);
    }
    if constexpr (!Law::is_single) {
      uniform = uniform && (!stays || first_material < Pack(0.0) || material == first_material);
      first_material = select(stays && first_material < Pack(0.0), material, first_material);
    }
    staying_volume += volume;
    TALUS_UNROLL
    for (int i = 0; i < D; ++i) s[i] += pore.bishop;
    sums.add(mass, volume, xi, u, s);
    water_sums.add(water_mass, select(wet, volume, Pack(0.0)), xi, w, pore.pressure, pore.saturation,
                   lanes.get_resistance(material), pore.relative);
  }

  Pack stretch(1.0);
  if constexpr (Mixed) {  // a full element's internal force is taken over its whole volume (2.92)
    const Pack V_e = load<Pack>(&body.layout->volumes[block * lane_width]);
    const Mask full = staying_volume > load<Pack>(&body.elements.fill_limit[block * lane_width]) && uniform;
    stretch = select(full, V_e / select(full, staying_volume, Pack(1.0)), Pack(1.0));
    TALUS_UNROLL
    for (int i = 0; i < force_size<D>; ++i) sums.stress[i] *= stretch;
    const Mask newly = full && !element.full;
    if (any(newly)) {
      for (int l = 0; l < lane_width; ++l) {
        if (newly[l]) pass.newly_full.push_back(b * lane_width + l);
      }
    }
  }
  if (stable) {
    const Mask some = all_volume > Pack(0.0);
    store(&body.elements.plastic_mean[block * lane_width],
          select(some, plastic_mean / select(some, all_volume, Pack(1.0)), Pack(0.0)));
    store(&body.elements.force_volume[block * lane_width], staying_volume * stretch);
  }
  if constexpr (Law::is_plastic) {
    pass.dissipated += dissipated;
  }
  Pack solid[D + 1][1 + 2 * D], out[D + 1][C::count];
  sums.to_nodes(g, solid);
  copy_solid_columns<D>(solid, out);
  water_sums.to_nodes(g, stretch, out);
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k)
    add_rows<C::count, 0, wet_sums_stride<D>>(body.water.sums.data(), rows + k * lane_width, out[k]);
  const Pack wet_volume = water_sums.volume[0];
  const Mask some = wet_volume > Pack(0.0);
  const Pack inverse = 1.0 / select(some, wet_volume, Pack(1.0));
  store(&body.water.volume[block * lane_width], wet_volume);
  store(&body.water.stretch[block * lane_width], stretch);
  store(&body.water.mean_saturation[block * lane_width], water_sums.saturation * inverse);
  store(&body.water.mean_pressure[block * lane_width], water_sums.pressure * inverse);
  store(&body.water.mean_resistance[block * lane_width],
        water_sums.resistance[0] / select(some, water_sums.relative[0], Pack(1.0)));
  double* moments = &body.elements.moments[block * moment_size<D> * lane_width];
  double* water_moments = &body.water.moments[block * moment_size<D> * lane_width];
  TALUS_UNROLL
  for (int i = 0; i < moment_size<D>; ++i) {
    store(moments + i * lane_width, sums.moments[i]);
    store(water_moments + i * lane_width, water_sums.moments[i]);
  }
}

}  // namespace

template <int D>
MoverLists advance_coupled_points(Body<D>& body, const StepOptions<D>& options) {
  const Layout<D>& layout = *body.layout;
  const std::size_t chunks = static_cast<std::size_t>(layout.chunks);
  MoverLists movers(chunks);
  std::vector<std::vector<int>> newly_full(chunks);
  std::vector<double> dissipated(chunks, 0.0), pressed_in(chunks, 0.0);
  const bool far = body.points.size() > 30000;  // beyond the second-level cache
  constexpr int ahead = D == 2 ? 1 : 3;
  parallel_for(layout.chunks, options.threads, [&](int c) {
    const std::size_t chunk = static_cast<std::size_t>(c);
    Pass<D> pass{body, options, movers[chunk], newly_full[chunk], body.water.density};
    const int begin = layout.chunk_start[c], end = layout.chunk_start[c + 1];
    const auto advance = [&](const auto& law, int b) {
      if (far && b + ahead < end && body.points.block_used[b + ahead] > 0) prefetch_block(body, b + ahead);
      if (body.points.block_used[b] == 0) return;
      if (options.mixed)
        advance_block<true>(pass, law, b);
      else
        advance_block<false>(pass, law, b);
    };
    for (int b = begin; b < end; ++b) {
      visit_laws(body.laws, body.laws.size() == 1 ? 1u : body.points.block_materials[b],
                 [&](const auto& law) { advance(law, b); });
    }
    for (int l = 0; l < lane_width; ++l) {
      dissipated[chunk] += pass.dissipated.value[l];
      pressed_in[chunk] += pass.pressed_in.value[l];
    }
  });
  for (double d : dissipated) body.work.dissipated += d;
  for (double p : pressed_in) body.water.pressed_in += p;
  body.water.newly_full.clear();
  for (const std::vector<int>& list : newly_full)
    body.water.newly_full.insert(body.water.newly_full.end(), list.begin(), list.end());
  return movers;
}

template MoverLists advance_coupled_points<2>(Body<2>&, const StepOptions<2>&);
template MoverLists advance_coupled_points<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
