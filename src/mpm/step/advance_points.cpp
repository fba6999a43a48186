// The one pass over the points: velocity, position, strain, stress and volume, and the nodal sums of the next step.

#include "base/parallel.hpp"
#include "mpm/body/rows.hpp"
#include "mpm/step/full_element.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {
namespace {

/// Everything a block's pass needs that does not change from block to block.
template <int D>
struct Pass {
  Body<D>& body;
  const StepOptions<D>& options;
  std::vector<Mover>& movers;
  Pack dissipated{0.0};  ///< plastic work of this pass, by lane [J]
};

/// Prefetches what block `b` will read and write. Inlined by force: GCC takes a function that only prefetches for one
/// without effect and removes its calls.
template <int D>
TALUS_KERNEL void prefetch_block(const Body<D>& body, int b) {
  const Points<D>& points = body.points;
  const char* data = reinterpret_cast<const char*>(points.slot(points.block_start[b]));
  const std::int64_t bytes = static_cast<std::int64_t>(points.block_used[b]) * points.fields * lane_width * 8;
  for (std::int64_t i = 0; i < bytes; i += 64) __builtin_prefetch(data + i, 1, 3);
  const int* rows = &body.layout->connectivity[static_cast<std::size_t>(b) * (D + 1) * lane_width];
  for (int i = 0; i < (D + 1) * lane_width; ++i) {
    __builtin_prefetch(&body.nodes.motion[static_cast<std::size_t>(rows[i]) * motion_stride<D>], 0, 3);
    __builtin_prefetch(&body.nodes.sums[static_cast<std::size_t>(rows[i]) * sums_stride], 1, 3);
  }
  const double* moments = &body.elements.moments[static_cast<std::size_t>(b) * moment_size<D> * lane_width];
  for (int i = 0; i < moment_size<D>; ++i) __builtin_prefetch(moments + i * lane_width, 1, 3);
  const double* strain = &body.elements.strain[static_cast<std::size_t>(b) * material::stress_size<D> * lane_width];
  for (int i = 0; i < material::stress_size<D>; ++i) __builtin_prefetch(strain + i * lane_width, 1, 3);
}

/// `Mixed` is a template parameter because the second source of stress costs registers that plain points need.
template <bool Mixed, int D, class Law>
void advance_block(Pass<D>& pass, const Law& law, int b) {
  using P = Points<D>;
  constexpr int NS = P::stress_size;
  Body<D>& body = pass.body;
  const StepOptions<D>& o = pass.options;
  P& points = body.points;
  const std::size_t block = static_cast<std::size_t>(b);
  const int* rows = &body.layout->connectivity[block * (D + 1) * lane_width];

  Pack a[D + 1][D], v[D + 1][D], g[D * D];
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k) {
    Pack motion[2 * D];
    load_rows<2 * D, motion_stride<D>>(body.nodes.motion.data(), rows + k * lane_width, motion);
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      a[k][d] = motion[d];
      v[k][d] = motion[D + d];
    }
  }
  TALUS_UNROLL
  for (int i = 0; i < D * D; ++i) g[i] = load<Pack>(&body.layout->gradients[(block * D * D + i) * lane_width]);
  const ElementMotion<D, Pack> motion(a, v, g, o.dt);
  Rotation<D, Pack> rotation;
  if (o.objective) rotation = Rotation<D, Pack>(motion.grad);
  const Pack count = load<Pack>(&points.count[block * lane_width]);

  Pack d_epsilon[NS];
  motion.strain(d_epsilon);
  Pack volumetric = d_epsilon[0] + d_epsilon[1] + d_epsilon[2];
  Pack pending(0.0);
  const bool stable = o.smoothing == input::Smoothing::stable;
  if (o.smoothing != input::Smoothing::none) {  // (2.95), recomposed over three components
    Pack mean(0.0);
    for (int l = 0; l < lane_width; ++l) {
      double s = 0;
      for (int k = 0; k <= D; ++k) s += body.nodes.smoothed[static_cast<std::size_t>(rows[k * lane_width + l])];
      mean.value[l] = s / (D + 1);
    }
    const Pack correction = (mean - volumetric) * (1.0 / 3);
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) d_epsilon[i] += correction;
    volumetric = mean;
    if (stable) pending = load<Pack>(&body.elements.return_pressure[block * lane_width]);
  }
  double* strain = &body.elements.strain[block * NS * lane_width];
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) store(strain + i * lane_width, load<Pack>(strain + i * lane_width) + d_epsilon[i]);

  const StressIncrement<D> increment{rotation, d_epsilon, pending, body.time};
  const Pack saturation = body.elements.held_saturation.empty()
                              ? Pack(1.0)
                              : load<Pack>(&body.elements.held_saturation[block * lane_width]);
  FullElement<D, Law> element;
  if constexpr (Mixed) {
    element = gather_full_elements(body, law, b, count);
    update_full_elements(body, o, law, b, increment, saturation, element);
  }
  const bool none_partial = Mixed && all(element.full || !(count > Pack(0.0)));

  const Pack growth = 1.0 + volumetric;
  ElementSums<D, Pack> sums;
  Pack staying_volume(0.0), all_volume(0.0), plastic_mean(0.0), dissipated(0.0), first_material(-1.0);
  Mask uniform(true);
  for (int k = 0; k < points.block_used[b]; ++k) {
    const std::int64_t slot = points.block_start[b] + k;
    double* p = points.slot(slot);
    const Mask active = count > Pack(static_cast<double>(k));
    Pack xi[D], u[D], s[NS], q[material::max_state_size];
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      xi[d] = load<Pack>(p + (P::xi + d) * lane_width);
      u[d] = load<Pack>(p + (P::velocity + d) * lane_width);
    }
    Pack volume = load<Pack>(p + P::volume * lane_width), mass = load<Pack>(p + P::mass * lane_width);
    motion.advance_velocity(xi, u);
    if (o.moving) {
      motion.advance_position(xi);
      volume *= growth;
    }
    Pack material(0.0);
    if constexpr (!Law::is_single) material = lane_materials(points, slot);
    const int* ids = &points.id[static_cast<std::size_t>(slot * lane_width)];
    const material::Response<Pack> response = update_point_stress<Mixed>(
        o, law, element, increment, p, ids, none_partial, active, material, saturation, s, q);
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
      if (o.moving) store(p + (P::xi + d) * lane_width, xi[d]);
    }
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) store(p + (P::stress + i) * lane_width, s[i]);
    if (o.moving) store(p + P::volume * lane_width, volume);
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
      mass = select(stays, mass, Pack(0.0));
      volume = select(stays, volume, Pack(0.0));
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) {
        xi[d] = select(stays, xi[d], Pack(0.0));
        u[d] = select(stays, u[d], Pack(0.0));
      }
      TALUS_UNROLL
      for (int i = 0; i < NS; ++i) s[i] = select(stays, s[i], Pack(0.0));
    }
    if constexpr (!Law::is_single) {
      uniform = uniform && (!stays || first_material < Pack(0.0) || material == first_material);
      first_material = select(stays && first_material < Pack(0.0), material, first_material);
    }
    staying_volume += volume;
    sums.add(mass, volume, xi, u, s);
  }

  if constexpr (Mixed) {  // a full element's internal force is taken over its whole volume (2.92)
    const Pack V_e = load<Pack>(&body.layout->volumes[block * lane_width]);
    const Mask full = staying_volume > load<Pack>(&body.elements.fill_limit[block * lane_width]) && uniform;
    const Pack factor = select(full, V_e / select(full, staying_volume, Pack(1.0)), Pack(1.0));
    TALUS_UNROLL
    for (int i = 0; i < force_size<D>; ++i) sums.stress[i] *= factor;
    staying_volume *= factor;
  }
  if (stable) {
    const Mask some = all_volume > Pack(0.0);
    store(&body.elements.plastic_mean[block * lane_width],
          select(some, plastic_mean / select(some, all_volume, Pack(1.0)), Pack(0.0)));
    store(&body.elements.force_volume[block * lane_width], staying_volume);
  }
  if constexpr (Law::is_plastic) {
    pass.dissipated += dissipated;
  }
  Pack out[D + 1][1 + 2 * D];
  sums.to_nodes(g, out);
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k) add_rows<1 + 2 * D>(body.nodes.sums.data(), rows + k * lane_width, out[k]);
  double* moments = &body.elements.moments[block * moment_size<D> * lane_width];
  TALUS_UNROLL
  for (int i = 0; i < moment_size<D>; ++i) store(moments + i * lane_width, sums.moments[i]);
}

}  // namespace

template <int D>
MoverLists advance_points(Body<D>& body, const StepOptions<D>& options) {
  const Layout<D>& layout = *body.layout;
  MoverLists movers(static_cast<std::size_t>(layout.chunks));
  std::vector<double> dissipated(static_cast<std::size_t>(layout.chunks), 0.0);
  const bool far = body.points.size() > 50000;  // beyond the second-level cache
  constexpr int ahead = D == 2 ? 1 : 3;
  parallel_for(layout.chunks, options.threads, [&](int c) {
    Pass<D> pass{body, options, movers[static_cast<std::size_t>(c)]};
    const int begin = layout.chunk_start[c], end = layout.chunk_start[c + 1];
    const auto advance = [&](const auto& law, int b) {
      if (far && b + ahead < end && body.points.block_used[b + ahead] > 0) prefetch_block(body, b + ahead);
      if (body.points.block_used[b] == 0) return;
      if (options.mixed)
        advance_block<true>(pass, law, b);
      else
        advance_block<false>(pass, law, b);
    };
    if (body.laws.size() == 1) {
      visit_laws(body.laws, 1u, [&](const auto& law) {
        for (int b = begin; b < end; ++b) advance(law, b);
      });
    } else {
      for (int b = begin; b < end; ++b) {
        visit_laws(body.laws, body.points.block_materials[b], [&](const auto& law) { advance(law, b); });
      }
    }
    for (int l = 0; l < lane_width; ++l) dissipated[static_cast<std::size_t>(c)] += pass.dissipated.value[l];
  });
  for (double d : dissipated) body.work.dissipated += d;
  return movers;
}

template MoverLists advance_points<2>(Body<2>&, const StepOptions<2>&);
template MoverLists advance_points<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
