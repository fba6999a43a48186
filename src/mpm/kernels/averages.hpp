// SPDX-License-Identifier: MIT
#pragma once
// Nodal averages of element values and back (2.94, 2.95). `first` is the first lane of a block.

#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"

namespace talus::mpm {

/// Mask of the elements with a point that keeps a gap.
template <class B, class T = typename B::Lanes>
TALUS_KERNEL MaskOf<T> is_apart(const B& body, std::size_t first) {
  return load<T>(&body.elements.apart[first]) > T(0.0);
}

/// Mask of the elements that take part in nodal averages: they hold points, none of which keeps a gap. Averaging over
/// separated soil would create energy (theory 4).
template <class B, class T = typename B::Lanes>
TALUS_KERNEL MaskOf<T> takes_part(const B& body, std::size_t first) {
  return load<T>(&body.points.count[first]) > T(0.0) && !is_apart(body, first);
}

/// Fraction of what averaging removes that an element keeps for one step, a viscosity on null modes of the volume
/// change (T4.5).
inline constexpr double kept_fraction = 0.25;

/// Volumetric strain increment of the elements of a block with smoothing "stable", from their `own` increment and the
/// nodal `average` of its elastic part (T4.4, T4.5). `rough` receives r_e for the next step.
template <class B, class T = typename B::Lanes>
TALUS_KERNEL T join_dilation(const B& body, std::size_t first, T own, T average, T& rough) {
  const T plastic = load<T>(&body.elements.plastic_dilation[first]);
  rough = select(takes_part(body, first), own - plastic - average, T(0.0));
  return average + plastic + kept_fraction * (rough - load<T>(&body.elements.rough[first]));
}

/// Mean over the nodes of the elements of a block, of one column of rows that are Stride doubles long.
template <class B, int Stride>
TALUS_KERNEL typename B::Lanes find_node_mean(const double* column, const int* rows) {
  constexpr int D = B::dimension;
  typename B::Lanes mean(0.0);
  for (int l = 0; l < LaneTraits<typename B::Lanes>::width; ++l) {
    double s = 0;
    for (int k = 0; k <= D; ++k) s += column[static_cast<std::int64_t>(rows[k * B::width + l]) * Stride];
    set_lane(mean, l, s / (D + 1));
  }
  return mean;
}

// Nodal averages of element values (2.94). Rows hold pairs of Σ value·weight and Σ weight.

/// Calls work(b, rows) for all blocks of chunk `c` that hold points.
template <int D, class Work>
void for_blocks_of(const Body<D>& body, int c, Work&& work) {
  const Layout<D>& layout = *body.layout;
  for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b)
    if (body.points.block_used[b] > 0)
      work(b, &layout.connectivity[static_cast<std::size_t>(b) * lane_width * (D + 1)]);
}
/// The same for all chunks of this rank.
template <int D, class Work>
void for_blocks(const Body<D>& body, int threads, Work&& work) {
  for_chunks(body, threads, [&](int c) { for_blocks_of(body, c, work); });
}
/// The same for work that fills `rows`, which are complete on return; see for_chunks_and_update().
template <int D, class Work>
void for_blocks_and_update(const Body<D>& body, int threads, AlignedVector<double>& rows, int stride,
                           const Work& work) {
  for_chunks_and_update(body, threads, rows, stride, [&](int c) { for_blocks_of(body, c, work); });
}

/// Adds packs to the rows of a block's nodes.
template <int D, int Columns>
TALUS_KERNEL void add_average(AlignedVector<double>& average, const int* rows, const Pack (&values)[Columns]) {
  for (int k = 0; k <= D; ++k) {
    for (int l = 0; l < lane_width; ++l) {
      double* row = &average[static_cast<std::size_t>(rows[k * lane_width + l]) * Columns];
      TALUS_UNROLL
      for (int c = 0; c < Columns; ++c) row[c] += values[c].value[l];
    }
  }
}

/// Divides the sums of all nodes, whose rows are complete, by their weights, writes the averages into rows of Stride
/// doubles and zeroes the sums.
template <int Columns, int Stride, int D>
void divide_averages(const Body<D>& body, int threads, AlignedVector<double>& average, double* smoothed) {
  const Layout<D>& layout = *body.layout;
  for_node_pieces(body, threads, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i) {
      double sum[Columns] = {};
      for (int r = layout.row_start[i]; r < layout.row_start[i + 1]; ++r) {
        double* row = &average[static_cast<std::size_t>(layout.node_rows[r]) * Columns];
        TALUS_UNROLL
        for (int q = 0; q < Columns; ++q) {
          sum[q] += row[q];
          row[q] = 0;
        }
      }
      TALUS_UNROLL
      for (int q = 0; q < Columns; q += 2) sum[q] = sum[q + 1] > 0 ? sum[q] / sum[q + 1] : 0;
      for (int r = layout.row_start[i]; r < layout.row_start[i + 1]; ++r) {
        double* row = smoothed + static_cast<std::size_t>(layout.node_rows[r]) * Stride;
        TALUS_UNROLL
        for (int q = 0; q < Columns; q += 2) row[q / 2] = sum[q];
      }
    }
  });
}

}  // namespace talus::mpm
