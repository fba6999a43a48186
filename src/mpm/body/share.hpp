// SPDX-License-Identifier: MIT
#pragma once
// One rank's share of a body: consecutive chunks, with the points in their elements. A shared body has the layout and
// the numbers of the whole one, and is filled where its rank works: its chunks, and of the nodes between chunks also
// the rows of other ranks. As chunks are what is summed up, and in their order, all numbers are those of a single
// process.

#include <algorithm>
#include <array>
#include <memory>

#include "base/parallel.hpp"
#include "base/ranks.hpp"
#include "mpm/body/body.hpp"

namespace talus::mpm {

template <int D>
struct Share {
  Ranks* ranks = nullptr;
  std::vector<int> chunk_of_rank;          ///< first chunk of each rank, [ranks + 1]
  std::vector<std::array<int, 2>> guests;  ///< ranges of nodes that touch these chunks, and are summed up by others
  std::unique_ptr<Halo> rows;              ///< of nodes between ranks
  std::unique_ptr<Halo> elements;          ///< neighbours of these chunks' elements

  int first_chunk() const { return chunk_of_rank[static_cast<std::size_t>(ranks->rank())]; }
  int last_chunk() const { return chunk_of_rank[static_cast<std::size_t>(ranks->rank()) + 1]; }
};

/// The chunks [first, last) that are worked on here.
template <int D>
std::array<int, 2> own_chunks(const Body<D>& body) {
  if (!body.share) return {0, body.layout->chunks};
  return {body.share->first_chunk(), body.share->last_chunk()};
}

/// The elements [first, last) of these chunks.
template <int D>
std::array<int, 2> own_elements(const Body<D>& body) {
  const auto [first, last] = own_chunks(body);
  const auto& start = body.layout->chunk_start;
  const int count = body.mesh().element_count();
  const auto element = [&](int c) { return std::min(start[static_cast<std::size_t>(c)] * lane_width, count); };
  return {element(first), element(last)};
}

/// Calls work(c) for the chunks that are worked on here.
template <int D, class Work>
void for_chunks(const Body<D>& body, int threads, Work&& work) {
  const auto [first, last] = own_chunks(body);
  parallel_for(last - first, threads, [&, begin = first](int i) { work(begin + i); });
}

/// First node of piece `c`: the nodes whose first row belongs to that chunk.
template <int D>
int first_node(const Body<D>& body, int c) {
  return body.layout->node_start[static_cast<std::size_t>(c)];
}

/// Calls work(begin, end, c) for the pieces of the nodes that are worked on here; c is -1 for nodes of other ranks'
/// pieces, whose sums are counted there.
template <int D, class Work>
void for_node_pieces(const Body<D>& body, int threads, Work&& work) {
  const auto [first, last] = own_chunks(body);
  const int own = last - first, guests = body.share ? static_cast<int>(body.share->guests.size()) : 0;
  parallel_for(own + guests, threads, [&, begin = first](int i) {
    if (i < own)
      work(first_node(body, begin + i), first_node(body, begin + i + 1), begin + i);
    else
      work(body.share->guests[static_cast<std::size_t>(i - own)][0],
           body.share->guests[static_cast<std::size_t>(i - own)][1], -1);
  });
}

/// Rows of other ranks of the nodes that are worked on here, as these ranks have left them.
template <int D>
void update_rows(const Body<D>& body, AlignedVector<double>& rows, int stride) {
  if (body.share) body.share->rows->update(rows.data(), stride);
}

/// Numbers of points in the elements of other ranks beside those here.
template <int D>
void update_counts(Body<D>& body) {
  if (body.share) body.share->elements->update(body.points.count.data(), 1);
}

/// What other ranks have of a list with an item per chunk.
template <int D, class T>
void complete_chunks(const Body<D>& body, std::vector<T>& by_chunk) {
  if (!body.share) return;
  const auto [first, last] = own_chunks(body);
  Message mine;
  mine.put(by_chunk.data() + first, static_cast<std::size_t>(last - first));
  std::size_t at = 0;
  for (Bytes& bytes : body.share->ranks->gather(mine.bytes(), true)) {
    const std::size_t count = bytes.size() / sizeof(T);
    Message(std::move(bytes)).get(by_chunk.data() + at, count);
    at += count;
  }
}

/// A list that every rank has a part of, in the order of the ranks.
template <int D, class T>
std::vector<T> join_lists(const Body<D>& body, std::vector<T> mine) {
  if (!body.share) return mine;
  Message message;
  message.put_list(mine);
  std::vector<T> all;
  for (Bytes& bytes : body.share->ranks->gather(message.bytes(), true)) {
    const std::vector<T> part = Message(std::move(bytes)).get_list<T>();
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// The share of this rank, of a body that every rank has as a whole. Throws Error (wrong_input) for a mesh whose nodes
/// are not in the order of their elements.
template <int D>
Body<D> take_share(const Body<D>& whole, Ranks& ranks);

/// Puts the whole body together again, on all ranks or on rank 0 alone: `whole` is the body that the shares were taken
/// of.
template <int D>
void collect(const Body<D>& share, bool to_all, Body<D>& whole);

}  // namespace talus::mpm
