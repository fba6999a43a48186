// SPDX-License-Identifier: MIT
#pragma once
// Nodal averages of element values (2.94). Rows hold pairs: Σ value·weight, and Σ weight.

#include "mpm/body/element_average.hpp"
#include "mpm/body/node_rows.hpp"

namespace talus::mpm {

/// Calls work(b, rows) for all blocks of chunk `c` that hold points.
template <int D, class Work>
void for_blocks_of(const Body<D>& body, int c, Work&& work) {
  const Layout<D>& layout = *body.layout;
  for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b)
    if (body.points.block_used[b] > 0)
      work(b, &layout.connectivity[static_cast<std::size_t>(b) * lane_width * (D + 1)]);
}
/// The same for all chunks.
template <int D, class Work>
void for_blocks(const Body<D>& body, int threads, Work&& work) {
  for_chunks(body, threads, [&](int c) { for_blocks_of(body, c, work); });
}
/// The same where they fill `rows`, which then are complete: see for_chunks_and_update().
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

/// Divides the averages of all nodes, whose rows are complete, by their weights, into rows of Stride doubles, and
/// empties them.
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
