// SPDX-License-Identifier: MIT
#pragma once
// Partition of a body over ranks. The part of a rank is consecutive chunks with the points in their elements. Its body
// has the layout and the numbering of the whole body; only the fields of its own chunks, and the rows of other ranks at
// the nodes between chunks, are filled and take memory (base/aligned.hpp). Sums are taken by chunk and in the order of
// the chunks, so results are bitwise identical to those of one process.

#include <algorithm>
#include <array>
#include <memory>

#include "base/parallel.hpp"
#include "base/ranks.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

template <int D>
struct Partition {
  Ranks* ranks = nullptr;
  std::vector<int> chunk_of_rank;          ///< first chunk of each rank, [ranks + 1]
  std::vector<std::array<int, 2>> guests;  ///< ranges of nodes that touch these chunks and are summed by other ranks
  std::unique_ptr<Halo> rows;              ///< rows of nodes between ranks
  std::unique_ptr<Halo> elements;          ///< elements of other ranks that touch a node of these chunks
  std::unique_ptr<Halo> nodes;             ///< nodes of these elements that other ranks sum
  std::unique_ptr<Halo> reach;             ///< elements within nonlocal reach of these; null without nonlocal averaging
  std::vector<int> outer, inner;           ///< own chunks with rows that other ranks need, and without
  std::vector<std::uint8_t> is_near;       ///< by element: it touches a node of these chunks

  int first_chunk() const { return chunk_of_rank[static_cast<std::size_t>(ranks->rank())]; }
  int last_chunk() const { return chunk_of_rank[static_cast<std::size_t>(ranks->rank()) + 1]; }
};

/// The chunks [first, last) of this rank.
template <int D>
std::array<int, 2> own_chunks(const Body<D>& body) {
  if (!body.partition) return {0, body.layout->chunks};
  return {body.partition->first_chunk(), body.partition->last_chunk()};
}

/// Index of the interval, of those that start at `starts`, that contains an item.
inline int find_interval(const std::vector<int>& starts, int item) {
  return static_cast<int>(std::upper_bound(starts.begin(), starts.end(), item) - starts.begin()) - 1;
}

/// The elements [first, last) of this rank's chunks.
template <int D>
std::array<int, 2> own_elements(const Body<D>& body) {
  const auto [first, last] = own_chunks(body);
  const auto& start = body.layout->chunk_start;
  const int count = body.mesh().element_count();
  const auto element = [&](int c) { return std::min(start[static_cast<std::size_t>(c)] * lane_width, count); };
  return {element(first), element(last)};
}

/// Calls work(c) for the chunks of this rank.
template <int D, class Work>
void for_chunks(const Body<D>& body, int threads, Work&& work) {
  const auto [first, last] = own_chunks(body);
  parallel_for(last - first, threads, [&, begin = first](int i) { work(begin + i); });
}

/// First node of piece `c`, which is the nodes whose first row belongs to that chunk.
template <int D>
int first_node(const Body<D>& body, int c) {
  return body.layout->node_start[static_cast<std::size_t>(c)];
}

/// Calls work(begin, end, c) for the pieces of nodes on this rank; c is -1 for nodes of other ranks' pieces, whose sums
/// are counted on those ranks.
template <int D, class Work>
void for_node_pieces(const Body<D>& body, int threads, Work&& work) {
  const auto [first, last] = own_chunks(body);
  const int own = last - first, guests = body.partition ? static_cast<int>(body.partition->guests.size()) : 0;
  parallel_for(own + guests, threads, [&, begin = first](int i) {
    if (i < own)
      work(first_node(body, begin + i), first_node(body, begin + i + 1), begin + i);
    else
      work(body.partition->guests[static_cast<std::size_t>(i - own)][0],
           body.partition->guests[static_cast<std::size_t>(i - own)][1], -1);
  });
}

namespace detail {

// Never inlined, so that it is compiled once for all loops: an inlined copy might be contracted to different fused
// operations.
template <class Work, class... Arguments>
[[gnu::noinline]] void work_on(const Work& work, Arguments... arguments) {
  work(arguments...);
}

}  // namespace detail

/// Calls work(c) for the chunks of this rank, which fill `rows`, and updates the rows of other ranks. Their halo
/// exchange overlaps with the work on chunks that no other rank touches.
template <int D, class Work>
void for_chunks_and_update(const Body<D>& body, int threads, AlignedVector<double>& rows, int stride,
                           const Work& work) {
  if (!body.partition) return for_chunks(body, threads, [&](int c) { detail::work_on(work, c); });
  const Partition<D>& share = *body.partition;
  const auto run = [&](const std::vector<int>& chunks) {
    parallel_for(static_cast<int>(chunks.size()), threads,
                 [&](int i) { detail::work_on(work, chunks[static_cast<std::size_t>(i)]); });
  };
  run(share.outer);
  share.rows->begin({{rows.data(), stride}});
  run(share.inner);
  share.rows->end();
}

/// Like for_node_pieces(), with the rows of other ranks updated first. The halo exchange overlaps with the work on
/// nodes that need none of them.
template <int D, class Work>
void update_and_for_node_pieces(const Body<D>& body, int threads, AlignedVector<double>& rows, int stride,
                                const Work& work) {
  if (!body.partition)
    return for_node_pieces(body, threads, [&](int begin, int end, int c) { detail::work_on(work, begin, end, c); });
  const Partition<D>& share = *body.partition;
  const auto run = [&](const std::vector<int>& chunks, int i) {
    const int c = chunks[static_cast<std::size_t>(i)];
    detail::work_on(work, first_node(body, c), first_node(body, c + 1), c);
  };
  const int inner = static_cast<int>(share.inner.size()), outer = static_cast<int>(share.outer.size()),
            guests = static_cast<int>(share.guests.size());
  share.rows->begin({{rows.data(), stride}});
  parallel_for(inner, threads, [&](int i) { run(share.inner, i); });
  share.rows->end();
  parallel_for(outer + guests, threads, [&](int i) {
    if (i < outer) return run(share.outer, i);
    const auto& range = share.guests[static_cast<std::size_t>(i - outer)];
    detail::work_on(work, range[0], range[1], -1);
  });
}

/// Adapts an array by node or by element, of numbers or of vectors, to a halo exchange.
template <class Array>
HaloArray as_halo(Array& array) {
  using Item = typename Array::value_type;
  if constexpr (std::is_same_v<Item, double>)
    return {array.data(), 1};
  else
    return {array.empty() ? nullptr : array.front().data(), sizeof(Item) / sizeof(double)};
}

/// Halo exchange of arrays by element: values of other ranks for the elements that touch a node of this rank.
template <int D, class... Arrays>
void update_elements(const Body<D>& body, Arrays&... arrays) {
  if (body.partition) body.partition->elements->update({as_halo(arrays)...});
}
/// Halo exchange of arrays by node: values of other ranks for the nodes of these elements. After both, a loop over
/// elements may read all nodes of its elements, and a loop over nodes all elements around them with their nodes.
template <int D, class... Arrays>
void update_nodes(const Body<D>& body, Arrays&... arrays) {
  if (body.partition) body.partition->nodes->update({as_halo(arrays)...});
}

/// Halo exchange of the numbers of points per element.
template <int D>
void update_counts(Body<D>& body) {
  update_elements(body, body.points.count);
}

/// Completes a list of `per` items per chunk with the entries of the other ranks' chunks.
template <int D, class T>
void complete_chunks(const Body<D>& body, std::vector<T>& by_chunk, std::size_t per = 1) {
  if (!body.partition) return;
  const auto [first, last] = own_chunks(body);
  Message mine;
  mine.put(by_chunk.data() + static_cast<std::size_t>(first) * per, static_cast<std::size_t>(last - first) * per);
  std::size_t at = 0;
  for (Bytes& bytes : body.partition->ranks->gather(mine.bytes(), true)) {
    const std::size_t count = bytes.size() / sizeof(T);
    Message(std::move(bytes)).get(by_chunk.data() + at, count);
    at += count;
  }
}

/// Concatenates the lists of all ranks, in the order of the ranks.
template <int D, class T>
std::vector<T> join_lists(const Body<D>& body, std::vector<T> mine) {
  if (!body.partition) return mine;
  Message message;
  message.put_list(mine);
  std::vector<T> all;
  for (Bytes& bytes : body.partition->ranks->gather(message.bytes(), true)) {
    const std::vector<T> part = Message(std::move(bytes)).get_list<T>();
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Returns whether `here` is true on any rank.
template <int D>
bool is_any(const Body<D>& body, bool here) {
  if (!body.partition) return here;
  const std::vector<char> all = join_lists(body, std::vector<char>{here ? '\1' : '\0'});
  return std::any_of(all.begin(), all.end(), [](char c) { return c != 0; });
}

/// Cost of a step by chunk, in points, for the chunks of this rank; an element adds a small cost.
template <int D>
std::vector<double> count_work(const Body<D>& body);

/// Partitions chunks over ranks so that each has about the same `work` (by chunk). Returns the first chunk of each
/// rank, [ranks + 1].
std::vector<int> divide_chunks(const std::vector<double>& work, int ranks);

/// Scatters the body that rank 0 has as a whole (`whole`; null elsewhere) and returns the part of this rank;
/// chunk_of_rank as of divide_chunks(). Throws Error (wrong_input) for a mesh whose nodes are not in the order of their
/// elements.
template <int D>
Body<D> scatter_body(const Body<D>* whole, Body<D> description, Ranks& ranks, const std::vector<int>& chunk_of_rank);

/// Gathers the whole body into the one that was scattered: on rank 0 (`whole` is null elsewhere), or on all ranks.
template <int D>
void collect(const Body<D>& share, bool to_all, Body<D>* whole);

}  // namespace talus::mpm
