// Nodal averages of what makes soil and water change their volume: of the strain increment with weights V_e, of the
// divergence of the seepage with weights V̄ (2.94), and the surplus of pressure smoothing (2.96, T14.8).

#include "base/parallel.hpp"
#include "mpm/body/rows.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/kernels.hpp"

namespace talus::mpm {
namespace {

constexpr int columns = 4;  ///< of a row of Water::average: value and weight, twice

/// Adds packs to the rows of Water::average.
template <int D>
void add_average(Water<D>& water, const int* rows, const Pack (&values)[columns]) {
  for (int k = 0; k <= D; ++k) {
    for (int l = 0; l < lane_width; ++l) {
      double* row = &water.average[static_cast<std::size_t>(rows[k * lane_width + l]) * columns];
      for (int c = 0; c < columns; ++c) row[c] += values[c].value[l];
    }
  }
}

/// Divides the averages of all nodes by their weights, into Water::smoothed from `column` on, and empties them.
template <int D>
void divide_averages(Body<D>& body, std::size_t column, int threads) {
  const Layout<D>& layout = *body.layout;
  Water<D>& water = body.water;
  const int nodes = body.mesh().node_count();
  parallel_for(layout.chunks, threads, [&](int c) {
    const int begin = static_cast<int>(static_cast<std::int64_t>(nodes) * c / layout.chunks);
    const int end = static_cast<int>(static_cast<std::int64_t>(nodes) * (c + 1) / layout.chunks);
    for (int i = begin; i < end; ++i) {
      double sum[columns] = {};
      for (int r = layout.row_start[i]; r < layout.row_start[i + 1]; ++r) {
        double* row = &water.average[static_cast<std::size_t>(layout.node_rows[r]) * columns];
        for (int q = 0; q < columns; ++q) {
          sum[q] += row[q];
          row[q] = 0;
        }
      }
      const double first = sum[1] > 0 ? sum[0] / sum[1] : 0, second = sum[3] > 0 ? sum[2] / sum[3] : 0;
      for (int r = layout.row_start[i]; r < layout.row_start[i + 1]; ++r) {
        double* row = &water.smoothed[static_cast<std::size_t>(layout.node_rows[r]) * columns + column];
        row[0] = first;
        row[1] = second;
      }
    }
  });
}

/// Calls work(b, rows) for all blocks that hold points.
template <int D, class Work>
void for_blocks(const Body<D>& body, int threads, Work&& work) {
  const Layout<D>& layout = *body.layout;
  parallel_for(layout.chunks, threads, [&](int c) {
    for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b) {
      if (body.points.block_used[b] > 0)
        work(b, &layout.connectivity[static_cast<std::size_t>(b) * lane_width * (D + 1)]);
    }
  });
}

/// Mean over an element's nodes of a column of Water::smoothed.
template <int D>
Pack find_node_mean(const Water<D>& water, const int* rows, std::size_t column) {
  Pack mean(0.0);
  for (int l = 0; l < lane_width; ++l) {
    double s = 0;
    for (int k = 0; k <= D; ++k)
      s += water.smoothed[static_cast<std::size_t>(rows[k * lane_width + l]) * columns + column];
    mean.value[l] = s / (D + 1);
  }
  return mean;
}

/// Strain increment and divergence of a block, times Δt.
template <int D>
std::pair<Pack, Pack> find_increments(const Body<D>& body, int b, const int* rows, double dt) {
  Pack strain(0.0), divergence(0.0), first[4 * D];
  const double* g = &body.layout->gradients[static_cast<std::size_t>(b) * D * D * lane_width];
  load_rows<4 * D, wet_motion_stride<D>>(body.water.motion.data(), rows, first);
  TALUS_UNROLL
  for (int k = 0; k < D; ++k) {
    Pack motion[4 * D];
    load_rows<4 * D, wet_motion_stride<D>>(body.water.motion.data(), rows + (k + 1) * lane_width, motion);
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      const Pack gradient = load<Pack>(g + (k * D + d) * lane_width);
      strain += (motion[2 * D + d] - first[2 * D + d]) * gradient;
      divergence += (motion[3 * D + d] - first[3 * D + d]) * gradient;
    }
  }
  return {strain * dt, divergence * dt};
}

}  // namespace

template <int D>
void smooth_coupled_increments(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  const bool strains = o.smoothing != input::Smoothing::none;
  if (strains) {
    for_blocks(body, o.threads, [&](int b, const int* rows) {
      const std::size_t first = static_cast<std::size_t>(b) * lane_width;
      const Mask active = load<Pack>(&body.points.count[first]) > Pack(0.0);
      const Pack V_e = select(active, load<Pack>(&body.layout->volumes[first]), Pack(0.0));
      const Pack wet = select(active, load<Pack>(&water.volume[first]) * load<Pack>(&water.stretch[first]), Pack(0.0));
      const auto [strain, divergence] = find_increments(body, b, rows, o.dt);
      add_average(water, rows,
                  {V_e * select(active, strain, Pack(0.0)), V_e, wet * select(active, divergence, Pack(0.0)), wet});
    });
    divide_averages(body, 0, o.threads);
  }
  if (!o.smooth_pressure) return;
  // What makes the pressure of an element rise, per volume; kept in `surplus` until its average is known.
  for_blocks(body, o.threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    auto [strain, divergence] = find_increments(body, b, rows, o.dt);
    if (strains) {
      strain = find_node_mean(water, rows, 0);
      divergence = find_node_mean(water, rows, 1);
    }
    store(&water.surplus[first],
          load<Pack>(&water.stretch[first]) * (load<Pack>(&water.mean_saturation[first]) * strain + divergence));
  });
  for_blocks(body, o.threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    const Mask active = load<Pack>(&body.points.count[first]) > Pack(0.0);
    const Pack volume = select(active, load<Pack>(&water.volume[first]), Pack(0.0));
    const Pack value = select(active, load<Pack>(&water.surplus[first]), Pack(0.0));
    add_average(water, rows, {Pack(0.0), Pack(0.0), volume * value, volume});
  });
  divide_averages(body, 2, o.threads);
  for_blocks(body, o.threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    store(&water.surplus[first], find_node_mean(water, rows, 3) - load<Pack>(&water.surplus[first]));
  });
}

template void smooth_coupled_increments<2>(Body<2>&, const StepOptions<2>&);
template void smooth_coupled_increments<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
