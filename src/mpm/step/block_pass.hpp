// SPDX-License-Identifier: MIT
#pragma once
// The one pass over the points, block by block: velocity, position, strain, stress and volume, and the nodal sums of
// the next step. What pore water adds are the hooks of a block and of a slot that the phase hands in: DryPass of
// advance_points.cpp has none, WetPass of coupled/advance_points.cpp has them all. Everything is inlined by force into
// advance_block(), whose packs then live in registers.

#include <optional>

#include "mpm/body/node_average.hpp"
#include "mpm/body/rows.hpp"
#include "mpm/step/full_element.hpp"
#include "mpm/step/softening.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {

inline double sum_lanes(Pack a) {
  double sum = 0;
  for (int l = 0; l < lane_width; ++l) sum += a.value[l];
  return sum;
}

/// What a chunk sums up beside the sums of its nodes.
struct ChunkSums {
  double dissipated = 0;  ///< plastic work [J]
  double pressed_in = 0;  ///< see Water::pressed_in [kg]
  double pore_work = 0;   ///< see Work::pore_water [J]
};

/// Everything a block's pass needs that does not change from block to block, and what it sums over a chunk.
template <int D>
struct ChunkPass {
  static constexpr int dimension = D;
  Body<D>& body;
  const StepOptions<D>& options;
  std::vector<Mover> movers;
  Pack dissipated{0.0};  ///< plastic work, by lane [J]

  ChunkPass(Body<D>& b, const StepOptions<D>& o) : body(b), options(o) {}
  bool is_stable() const { return options.smoothing == input::Smoothing::stable; }
  ChunkSums sum() const { return {sum_lanes(dissipated)}; }
  /// What the passes leave in lists; empty where a chunk is another rank's.
  template <class Passes>
  static void collect_lists(Body<D>&, const Passes&) {}
};

/// A pass over points with one velocity.
template <int D>
struct OneVelocityPass : ChunkPass<D> {
  static constexpr int far = 50000;  ///< points from which on memory is fetched ahead
  using ChunkPass<D>::ChunkPass;

  TALUS_KERNEL static void prefetch_node(const Body<D>& body, std::size_t row) {
    __builtin_prefetch(&body.nodes.motion[row * motion_stride<D>], 0, 3);
    __builtin_prefetch(&body.nodes.sums[row * sums_stride], 1, 3);
  }
  TALUS_KERNEL static void prefetch_moment(const Body<D>& body, std::size_t i) {
    __builtin_prefetch(&body.elements.moments[i], 1, 3);
  }
};

/// Where block `b` stands in the arrays of a body, and what is the same for all its points.
template <int D>
struct BlockPlace {
  int b;
  std::size_t first;  ///< of its lanes
  const int* rows;
  Pack g[D * D], count;

  TALUS_KERNEL BlockPlace(const Body<D>& body, int index)
      : b(index), first(static_cast<std::size_t>(index) * lane_width) {
    rows = &body.layout->connectivity[first * (D + 1)];
    TALUS_UNROLL
    for (int i = 0; i < D * D; ++i) g[i] = load<Pack>(&body.layout->gradients[first * D * D + i * lane_width]);
    count = load<Pack>(&body.points.count[first]);
  }
};

/// The first Count vectors of the rows of a block's nodes.
template <int D, int Count, int Stride>
struct NodeVectors {
  Pack of[Count][D + 1][D];

  TALUS_KERNEL NodeVectors(const double* base, const int* rows) {
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k) {
      Pack row[Count * D];
      load_rows<Count * D, Stride>(base, rows + k * lane_width, row);
      TALUS_UNROLL
      for (int c = 0; c < Count; ++c) {
        TALUS_UNROLL
        for (int d = 0; d < D; ++d) of[c][k][d] = row[c * D + d];
      }
    }
  }
};

/// The points of a slot of a block.
template <int D>
struct SlotPoints {
  using P = Points<D>;
  double* p;
  const int* ids;
  Mask active;
  Pack xi[D], u[D], s[P::stress_size], q[material::max_state_size], volume, mass, material{0.0}, softened{0.0};

  TALUS_KERNEL SlotPoints(P& points, const BlockPlace<D>& at, int k) {
    const std::int64_t slot = points.block_start[at.b] + k;
    p = points.slot(slot);
    ids = &points.id[static_cast<std::size_t>(slot * lane_width)];
    active = at.count > Pack(static_cast<double>(k));
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      xi[d] = load<Pack>(p + (P::xi + d) * lane_width);
      u[d] = load<Pack>(p + (P::velocity + d) * lane_width);
    }
    volume = load<Pack>(p + P::volume * lane_width);
    mass = load<Pack>(p + P::mass * lane_width);
  }

  TALUS_KERNEL void store_fields(bool moving) const {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      store(p + (P::velocity + d) * lane_width, u[d]);
      if (moving) store(p + (P::xi + d) * lane_width, xi[d]);
    }
    TALUS_UNROLL
    for (int i = 0; i < P::stress_size; ++i) store(p + (P::stress + i) * lane_width, s[i]);
    if (moving) store(p + P::volume * lane_width, volume);
  }
  TALUS_KERNEL void store_state(int state_size) const {
    for (int i = 0; i < state_size; ++i) store(p + (P::state + i) * lane_width, q[i]);
  }

  /// Empties the other lanes: they may hold anything, also what is no number.
  TALUS_KERNEL void keep(Mask stays) {
    mass = select(stays, mass, Pack(0.0));
    volume = select(stays, volume, Pack(0.0));
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      xi[d] = select(stays, xi[d], Pack(0.0));
      u[d] = select(stays, u[d], Pack(0.0));
    }
    TALUS_UNROLL
    for (int i = 0; i < P::stress_size; ++i) s[i] = select(stays, s[i], Pack(0.0));
  }
};

/// What the points of a block sum up.
template <int D>
struct BlockSums {
  ElementSums<D, Pack> solid;
  Pack staying_volume{0.0}, all_volume{0.0}, plastic_dilation{0.0}, dissipated{0.0}, softened{0.0},
      softening_volume{0.0}, first_material{-1.0};
  Mask uniform{true};

  TALUS_KERNEL void add_plastic(Mask active, Pack volume, const material::Response<Pack>& response) {
    const Pack v_p = select(active, volume, Pack(0.0));
    dissipated += v_p * select(active, response.dissipation, Pack(0.0));
    plastic_dilation += v_p * select(active, response.plastic_dilation, Pack(0.0));
  }
  TALUS_KERNEL void add_softening(Mask softens, Pack volume, Pack dilation) {
    const Pack v_p = select(softens, volume, Pack(0.0));
    softening_volume += v_p;
    softened += v_p * select(softens, lane_max(dilation, Pack(0.0)), Pack(0.0));
  }
  TALUS_KERNEL void add_material(Mask stays, Pack material) {
    uniform = uniform && (!stays || first_material < Pack(0.0) || material == first_material);
    first_material = select(stays && first_material < Pack(0.0), material, first_material);
  }
};

/// Strain of the elements and its rotation; sums the strain. The block gets its `volumetric`.
template <bool Apart, class Pass, class Block, int D = Pass::dimension>
TALUS_KERNEL StressIncrement<D> strain_elements(Pass& pass, const BlockPlace<D>& at, Block& block) {
  constexpr int NS = material::stress_size<D>;
  StressIncrement<D> increment{{}, {}, pass.body.time};
  Pack* d_epsilon = increment.d_epsilon;
  if (pass.options.objective) increment.rotation = Rotation<D, Pack>(block.motion.grad);
  block.motion.strain(d_epsilon);
  block.volumetric = d_epsilon[0] + d_epsilon[1] + d_epsilon[2];
  if (pass.options.smoothing != input::Smoothing::none) {  // (2.95), recomposed over the components that move
    const Pack own = block.volumetric;
    block.smooth(pass, at);
    if (pass.is_stable()) {
      Pack rough;
      block.volumetric = join_dilation(pass.body, at.first, own, block.volumetric, rough);
      store(&pass.body.elements.rough[at.first], rough);
    }
    if constexpr (Apart) block.volumetric = select(is_apart(pass.body, at.first), own, block.volumetric);
    const Pack correction = (block.volumetric - own) * (1.0 / D);
    TALUS_UNROLL
    for (int i = 0; i < D; ++i) d_epsilon[i] += correction;
  }
  double* strain = &pass.body.elements.strain[at.first * NS];
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) store(strain + i * lane_width, load<Pack>(strain + i * lane_width) + d_epsilon[i]);
  return increment;
}

/// Notes elements with a gap where they stand: few have one, and a sum over the slots would cost all a register.
template <int D>
TALUS_KERNEL void note_apart(Body<D>& body, const BlockPlace<D>& at, Mask apart) {
  if (!any(apart)) return;
  double* noted = &body.elements.apart[at.first];
  store(noted, select(apart, Pack(1.0), load<Pack>(noted)));
}

/// Takes the points of slot `k` through the step, and adds what stays in its element to the sums.
template <class Pass, class Block, class Update, int D = Pass::dimension>
TALUS_KERNEL void advance_slot(Pass& pass, const BlockPlace<D>& at, Block& block, const Update& update,
                               BlockSums<D>& sums, int k) {
  using Law = typename Update::Law;
  const StepOptions<D>& o = pass.options;
  SlotPoints<D> points(pass.body.points, at, k);
  typename Block::Slot slot(block, points);
  block.motion.advance_velocity(points.xi, points.u);
  slot.advance_velocity(block, points);
  if (o.moving) {
    block.motion.advance_position(points.xi);
    points.volume *= block.growth;
  }
  if constexpr (!Law::is_single)
    points.material = lane_materials(pass.body.points, pass.body.points.block_start[at.b] + k);
  const Pack saturation = slot.update_water(pass, block, update, points);
  const material::Response<Pack> response = update_point_stress(update, saturation, points);
  if constexpr (Law::is_plastic) {
    if (o.moving && (Update::apart || any(response.opened > Pack(0.0)))) {
      points.volume *= slot.find_solid_share(response.opened);
      note_apart(pass.body, at, points.active && response.gap > Pack(0.0));
    }
    if (response.any_plastic) sums.add_plastic(points.active, points.volume, response);
    if constexpr (Law::softens)
      if (update.increment.lends)
        sums.add_softening(points.active && update.law.find_softening(points.material), points.volume, points.softened);
    if (pass.is_stable()) sums.all_volume += select(points.active, points.volume, Pack(0.0));
  }
  points.store_fields(o.moving);
  slot.store_fields();
  if (Update::mixed || response.any_plastic)
    points.store_state(Update::apart || (o.moving && response.any_plastic) ? update.law.state_size
                                                                           : update.law.core_size);

  Mask stays = points.active;
  if (o.moving) {
    const Mask outside = points.active && smallest_shape<D>(points.xi) < Pack(0.0);
    if (any(outside)) {
      pass.movers.push_back({at.b, k, to_bits(outside)});
      stays = points.active && !outside;
    }
  }
  if (!all(stays)) {
    points.keep(stays);
    slot.keep(stays);
  }
  if constexpr (!Law::is_single) sums.add_material(stays, points.material);
  sums.staying_volume += points.volume;
  slot.add_to(block, points);
  sums.solid.add(points.mass, points.volume, points.xi, points.u, points.s);
}

/// Gives the sums to the elements and to their nodes. `weight`: V_e/Σ V_p where the forces of this step were taken over
/// V_e; the work of the stress is that of the forces.
template <bool Mixed, class Law, class Pass, class Block, int D = Pass::dimension>
TALUS_KERNEL void give_sums(Pass& pass, const BlockPlace<D>& at, const Block& block, const Mask& was_full, Pack weight,
                            BlockSums<D>& sums) {
  Elements<D>& elements = pass.body.elements;
  Pack stretch(1.0);
  if constexpr (Mixed) {  // a full element's internal force is taken over its whole volume (2.92)
    const Pack V_e = load<Pack>(&pass.body.layout->volumes[at.first]);
    const Mask full = sums.staying_volume > load<Pack>(&elements.fill_limit[at.first]) && sums.uniform;
    stretch = select(full, V_e / select(full, sums.staying_volume, Pack(1.0)), Pack(1.0));
    TALUS_UNROLL
    for (int i = 0; i < force_size<D>; ++i) sums.solid.stress[i] *= stretch;
    pass.note_full(at, full && !was_full);
  }
  if (pass.is_stable()) {
    const Mask some = sums.all_volume > Pack(0.0);
    store(&elements.plastic_dilation[at.first],
          select(some, sums.plastic_dilation / select(some, sums.all_volume, Pack(1.0)), Pack(0.0)));
  }
  if constexpr (Law::is_plastic) {
    pass.dissipated += sums.dissipated * weight;
  }
  if constexpr (Law::softens) {
    if (!elements.lent.empty()) {
      store(&elements.softened[at.first], sums.softened);
      store(&elements.softening_volume[at.first], sums.softening_volume);
    }
  }
  Pack out[D + 1][1 + 2 * D];
  sums.solid.to_nodes(at.g, out);
  block.add_to_nodes(pass, at, stretch, out);
  double* moments = &elements.moments[at.first * moment_size<D>];
  TALUS_UNROLL
  for (int i = 0; i < moment_size<D>; ++i) store(moments + i * lane_width, sums.solid.moments[i]);
}

/// `Mixed` and `Apart`, whether a point of the block keeps a gap, are template parameters because the second source of
/// stress and the closing of gaps cost registers that other points need.
template <bool Mixed, bool Apart, class Pass, class Law>
void advance_block(Pass& pass, const Law& law, int b) {
  constexpr int D = Pass::dimension;
  Body<D>& body = pass.body;
  const BlockPlace<D> at(body, b);
  typename Pass::template Block<Law> block(pass, at);
  StressIncrement<D> increment = strain_elements<Apart>(pass, at, block);
  if constexpr (Law::softens) {
    increment.lends = !body.elements.lent.empty();
    if (increment.lends) increment.lent = load<Pack>(&body.elements.lent[at.first]);
  }
  FullElement<D, Law> element;
  if constexpr (Mixed) {
    element = gather_full_elements<Apart>(body, law, b, at.count);
    const Pack saturation = block.share_water(pass, at, element);
    update_full_elements<Apart>(body, pass.options, law, b, increment, saturation, element);
  }
  block.find_growth();
  const bool none_partial = Mixed && all(element.full || !(at.count > Pack(0.0)));
  const StressUpdate<Mixed, Apart, D, Law> update{pass.options, law, increment, element, none_partial};
  if constexpr (Apart) store(&body.elements.apart[at.first], Pack(0.0));
  BlockSums<D> sums;
  for (int k = 0; k < body.points.block_used[b]; ++k) advance_slot(pass, at, block, update, sums, k);
  Pack weight(1.0);
  if constexpr (Mixed && Law::is_plastic)
    weight = select(element.full,
                    load<Pack>(&body.layout->volumes[at.first]) / select(element.full, element.volume, weight), weight);
  give_sums<Mixed, Law>(pass, at, block, element.full, weight, sums);
}

/// Prefetches what block `b` will read and write. Inlined by force: GCC takes a function that only prefetches for one
/// without effect and removes its calls.
template <class Pass, int D>
TALUS_KERNEL void prefetch_block(const Body<D>& body, int b) {
  const Points<D>& points = body.points;
  const char* data = reinterpret_cast<const char*>(points.slot(points.block_start[b]));
  const std::int64_t bytes = static_cast<std::int64_t>(points.block_used[b]) * points.fields * lane_width * 8;
  for (std::int64_t i = 0; i < bytes; i += 64) __builtin_prefetch(data + i, 1, 3);
  const std::size_t first = static_cast<std::size_t>(b) * lane_width;
  const int* rows = &body.layout->connectivity[first * (D + 1)];
  for (int i = 0; i < (D + 1) * lane_width; ++i) Pass::prefetch_node(body, static_cast<std::size_t>(rows[i]));
  for (int i = 0; i < moment_size<D>; ++i) Pass::prefetch_moment(body, first * moment_size<D> + i * lane_width);
  const double* strain = &body.elements.strain[first * material::stress_size<D>];
  for (int i = 0; i < material::stress_size<D>; ++i) __builtin_prefetch(strain + i * lane_width, 1, 3);
}

/// The blocks of chunk `c`.
template <class Pass>
void advance_chunk(Pass& pass, int c) {
  constexpr int D = Pass::dimension, ahead = D == 2 ? 1 : 3;
  const Body<D>& body = pass.body;
  const int begin = body.layout->chunk_start[c], end = body.layout->chunk_start[c + 1];
  const bool far = body.points.size() > Pass::far;  // beyond the second-level cache
  const auto advance = [&](const auto& law, int b) {
    if (far && b + ahead < end && body.points.block_used[b + ahead] > 0) prefetch_block<Pass>(body, b + ahead);
    if (body.points.block_used[b] == 0) return;
    const bool apart = any(is_apart(body, static_cast<std::size_t>(b) * lane_width));
    if (pass.options.mixed)
      apart ? advance_block<true, true>(pass, law, b) : advance_block<true, false>(pass, law, b);
    else
      apart ? advance_block<false, true>(pass, law, b) : advance_block<false, false>(pass, law, b);
  };
  if (body.laws.size() == 1) {
    visit_laws(body.laws, 1u, [&](const auto& law) {
      for (int b = begin; b < end; ++b) advance(law, b);
    });
  } else {
    for (int b = begin; b < end; ++b)
      visit_laws(body.laws, body.points.block_materials[b], [&](const auto& law) { advance(law, b); });
  }
}

/// All blocks. Each chunk has a pass of its own, and their sums are taken in their order.
template <class Pass, int D>
MoverLists advance_blocks(Body<D>& body, const StepOptions<D>& options) {
  if (body.softening_reach) lend_softening(body, options.threads);
  std::vector<std::optional<Pass>> passes(static_cast<std::size_t>(body.layout->chunks));
  for_chunks(body, options.threads, [&](int c) {
    Pass pass(body, options);  // on the stack: neighbouring chunks must not share a cache line
    advance_chunk(pass, c);
    passes[static_cast<std::size_t>(c)].emplace(std::move(pass));
  });
  MoverLists movers(passes.size());
  std::vector<ChunkSums> sums(passes.size());
  for (std::size_t c = 0; c < passes.size(); ++c) {
    if (!passes[c]) continue;  // of another rank
    sums[c] = passes[c]->sum();
    movers[c] = std::move(passes[c]->movers);
  }
  complete_chunks(body, sums);
  for (const ChunkSums& of_chunk : sums) {
    body.work.dissipated += of_chunk.dissipated;
    body.work.pore_water += of_chunk.pore_work;
    body.water.pressed_in += of_chunk.pressed_in;
  }
  Pass::collect_lists(body, passes);
  return movers;
}

}  // namespace talus::mpm
