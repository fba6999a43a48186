// SPDX-License-Identifier: MIT
#pragma once
// The pass over the points on the CPU: chunks run on threads, the blocks of a chunk one after another. Also the
// stopwatch that times the phases of a step.

#include <chrono>
#include <optional>

#include "mpm/kernels/called_law.hpp"
#include "mpm/kernels/g2p_p2g_kernels.hpp"
#include "mpm/kernels/softening.hpp"
#include "mpm/state/partition.hpp"

namespace talus::mpm {

/// Runs the phases of a step one after another, and adds the time since the last one, or since construction, to `part`
/// [s].
class Stopwatch {
 public:
  template <class Line>
  void operator()(double& part, Line&& line) {
    line();
    const auto now = std::chrono::steady_clock::now();
    part += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Sums over a chunk beside the nodal sums.
struct ChunkSums {
  double dissipated = 0;  ///< plastic work [J]
  double pressed_in = 0;  ///< added to Water::pressed_in [kg]
  double pore_work = 0;   ///< added to Work::pore_water [J]
};

/// Data that are constant over the blocks of a chunk, and the sums over the chunk.
template <int D>
struct ChunkPass {
  static constexpr int dimension = D;
  using B = Body<D>;
  B& body;
  const StepOptions<D>& options;
  std::vector<Mover> movers;
  Pack dissipated{0.0};  ///< plastic work, by lane [J]

  ChunkPass(B& b, const StepOptions<D>& o) : body(b), options(o) {}
  TALUS_KERNEL void note_movers(const BlockPlace<B>& at, int k, Mask outside) {
    movers.push_back({at.b, k, to_bits(outside)});
  }
  bool is_stable() const { return options.smoothing == input::Smoothing::stable; }
  ChunkSums sum() const { return {sum_lanes(dissipated)}; }
  /// Appends the lists of the passes to those of the body. The entry of a chunk of another rank is empty.
  static void collect_lists(B&, const auto&) {}
};

/// A pass over points with one velocity.
template <int D>
struct OneVelocityPass : ChunkPass<D> {
  static constexpr int far = 50000;  ///< number of points above which memory is prefetched
  using ChunkPass<D>::ChunkPass;

  /// P2G: adds the sums of a block to its node rows.
  TALUS_KERNEL void add_to_nodes(const BlockPlace<Body<D>>& at, const Pack out[D + 1][1 + 2 * D]) const {
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k) add_rows<1 + 2 * D>(this->body.nodes.sums.data(), at.rows + k * lane_width, out[k]);
  }

  TALUS_KERNEL static void prefetch_node(const Body<D>& body, std::size_t row) {
    __builtin_prefetch(&body.nodes.motion[row * motion_stride<D>], 0, 3);
    __builtin_prefetch(&body.nodes.sums[row * sums_stride], 1, 3);
  }
  TALUS_KERNEL static void prefetch_moment(const Body<D>& body, std::size_t i) {
    __builtin_prefetch(&body.elements.moments[i], 1, 3);
  }
};

/// Prefetches what block `b` will read and write. It is forced inline: GCC takes a function that only prefetches for
/// one without effect and removes its calls.
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

/// Takes the blocks of chunk `c` that hold points through the pass.
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

/// The pass over all blocks. Each chunk has a pass of its own, and sums are added in the order of the chunks, so that
/// the result does not depend on the number of threads.
template <class Pass, int D>
MoverLists advance_blocks(Body<D>& body, const StepOptions<D>& options) {
  if (body.softening_reach) average_softening(body, options.threads);
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
