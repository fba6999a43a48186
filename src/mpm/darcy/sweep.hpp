// SPDX-License-Identifier: MIT
#pragma once
// Loops over elements and nodes of a body, chunk by chunk in parallel. Each rank covers its own ones; a halo exchange
// (update_elements, update_nodes) must precede reads of values of other ranks.

#include <algorithm>

#include "base/parallel.hpp"
#include "mpm/state/node_rows.hpp"

namespace talus::mpm {

namespace detail {

// Never inlined, so that it is compiled once for any number of threads: an inlined copy might be contracted to
// different fused operations.
[[gnu::noinline]] void run_each(int begin, int end, const auto& work) {
  for (int i = begin; i < end; ++i) work(i);
}
template <class T = double>
[[gnu::noinline]] T sum_each(int begin, int end, const auto& value) {
  T sum(0.0);
  for (int i = begin; i < end; ++i) sum += value(i);
  return sum;
}

}  // namespace detail

/// Selected nodes of a rank, by chunk and in the order of the chunks.
struct NodeList {
  std::vector<int> node, chunk_start;

  void for_each(int threads, const auto& work) const {
    const auto at = [&](int k) { work(node[static_cast<std::size_t>(k)]); };
    parallel_for(chunks(), threads, [&](int c) { detail::run_each(first(c), first(c + 1), at); });
  }
  /// Calls work(i) for each node of a chunk.
  void for_each_of(int chunk, const auto& work) const {
    detail::run_each(first(chunk), first(chunk + 1), [&](int k) { work(node[static_cast<std::size_t>(k)]); });
  }
  /// Calls work(i, chunk) for each node in order, on one thread.
  void for_each_in_chunk(const auto& work) const {
    for (int c = 0; c < chunks(); ++c)
      for (int k = first(c); k < first(c + 1); ++k) work(node[static_cast<std::size_t>(k)], c);
  }
  /// Sum of value(i) over all ranks, bitwise identical for any number of ranks and threads.
  template <int D, class Value>
  double sum(const Body<D>& body, int threads, const Value& value) const {
    std::vector<double> pieces(static_cast<std::size_t>(chunks()), 0.0);
    const auto at = [&](int k) { return value(node[static_cast<std::size_t>(k)]); };
    parallel_for(chunks(), threads,
                 [&](int c) { pieces[static_cast<std::size_t>(c)] = detail::sum_each(first(c), first(c + 1), at); });
    complete_chunks(body, pieces);
    double all = 0;
    for (const double piece : pieces) all += piece;
    return all;
  }

 private:
  int chunks() const { return static_cast<int>(chunk_start.size()) - 1; }
  int first(int chunk) const { return chunk_start[static_cast<std::size_t>(chunk)]; }
};

/// The nodes of a NodeList by slice (NodeGraph): whole slices of a chunk that contain one of them, and single nodes of
/// the slices that a chunk shares with the next one.
struct SliceList {
  std::vector<int> slice, slice_start;  ///< first node of each slice; where those of a chunk start
  NodeList single;

  /// Calls work.operator()<Pack>(i) for slices and work.operator()<double>(i) for single nodes.
  void for_each(int threads, const auto& work) const {
    parallel_for(chunks(), threads, [&](int c) {
      const auto pack = [&](int k) { work.template operator()<Pack>(slice[static_cast<std::size_t>(k)]); };
      detail::run_each(first(c), first(c + 1), pack);
      single.for_each_of(c, [&](int i) { work.template operator()<double>(i); });
    });
  }
  /// Sum of the values that work returns, over all ranks, bitwise identical for any number of ranks and threads.
  template <int D, class Work>
  double sum(const Body<D>& body, int threads, const Work& work) const {
    std::vector<double> pieces(static_cast<std::size_t>(chunks()), 0.0);
    parallel_for(chunks(), threads, [&](int c) {
      const auto pack = [&](int k) { return work.template operator()<Pack>(slice[static_cast<std::size_t>(k)]); };
      double piece = sum_lanes(detail::sum_each<Pack>(first(c), first(c + 1), pack));
      single.for_each_of(c, [&](int i) { piece += work.template operator()<double>(i); });
      pieces[static_cast<std::size_t>(c)] = piece;
    });
    complete_chunks(body, pieces);
    double all = 0;
    for (const double piece : pieces) all += piece;
    return all;
  }

 private:
  int chunks() const { return static_cast<int>(slice_start.size()) - 1; }
  int first(int chunk) const { return slice_start[static_cast<std::size_t>(chunk)]; }
};

/// The slices of the nodes of `list`.
template <int D>
SliceList list_slices(const Body<D>& body, const NodeList& list) {
  SliceList slices;
  for (int c = 0; c < body.layout->chunks; ++c) {
    slices.slice_start.push_back(static_cast<int>(slices.slice.size()));
    slices.single.chunk_start.push_back(static_cast<int>(slices.single.node.size()));
    int last = -1;
    for (int k = list.chunk_start[static_cast<std::size_t>(c)]; k < list.chunk_start[static_cast<std::size_t>(c) + 1];
         ++k) {
      const int i = list.node[static_cast<std::size_t>(k)], begin = i - i % lane_width;
      if (begin < first_node(body, c) || begin + lane_width > first_node(body, c + 1))
        slices.single.node.push_back(i);
      else if (begin != last)
        slices.slice.push_back(last = begin);
    }
  }
  slices.slice_start.push_back(static_cast<int>(slices.slice.size()));
  slices.single.chunk_start.push_back(static_cast<int>(slices.single.node.size()));
  return slices;
}

/// List of the nodes of this rank for which belongs(i) is true.
template <int D, class Belongs>
NodeList list_nodes(const Body<D>& body, const Belongs& belongs) {
  NodeList list;
  const auto [begin, end] = own_chunks(body);
  for (int c = 0; c < body.layout->chunks; ++c) {
    list.chunk_start.push_back(static_cast<int>(list.node.size()));
    if (c < begin || c >= end) continue;
    for (int i = first_node(body, c); i < first_node(body, c + 1); ++i)
      if (belongs(i)) list.node.push_back(i);
  }
  list.chunk_start.push_back(static_cast<int>(list.node.size()));
  return list;
}

/// Calls work(e) with the first element of each block of this rank.
template <int D, class Work>
void for_blocks_of_elements(const Body<D>& body, int threads, const Work& work) {
  const Layout<D>& layout = *body.layout;
  for_chunks(body, threads, [&](int c) {
    detail::run_each(layout.chunk_start[c], layout.chunk_start[c + 1], [&](int b) { work(b * lane_width); });
  });
}

/// Calls work.operator()<Pack>(i) for the whole slices of a chunk (NodeGraph) and work.operator()<double>(i) for its
/// other nodes.
template <int D, class Work>
void for_slices_of_nodes(const Body<D>& body, int threads, const Work& work) {
  for_chunks(body, threads, [&](int c) {
    const int begin = first_node(body, c), end = first_node(body, c + 1),
              first = std::min(end, (begin + lane_width - 1) / lane_width * lane_width),
              packs = (end - first) / lane_width;
    const auto single = [&](int i) { work.template operator()<double>(i); };
    detail::run_each(begin, first, single);
    detail::run_each(0, packs, [&](int k) { work.template operator()<Pack>(first + k * lane_width); });
    detail::run_each(first + packs * lane_width, end, single);
  });
}

}  // namespace talus::mpm
